#include "tiles/texture/square_means.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace poissonlab {

std::vector<double> channel_sums(const PngPixels& picture)
{
    const auto channels = static_cast<std::ptrdiff_t>(picture.channels);
    std::vector<double> sums;
    sums.reserve(picture.values.size() / static_cast<std::size_t>(channels));
    for (auto value = picture.values.begin(); value != picture.values.end(); value += channels)
        sums.push_back(std::accumulate(value, value + channels, 0));
    return sums;
}

SquareMeans::SquareMeans(std::span<const double> values, int width)
    : width_(width), height_(static_cast<int>(values.size() / static_cast<std::size_t>(width))),
      mean_(std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size())),
      sums_((static_cast<std::size_t>(width_) + 1) * (static_cast<std::size_t>(height_) + 1))
{
    auto value = values.begin();
    for (int y = 0; y < height_; ++y) {
        double row = 0;
        for (int x = 0; x < width_; ++x) {
            row += *value++ - mean_;
            sums_[index(x + 1, y + 1)] = row + sums_[index(x + 1, y)];
        }
    }
}

double SquareMeans::mean(int left, int top, int right, int bottom) const
{
    const double sum =
        sums_[index(right, bottom)] - sums_[index(left, bottom)] - sums_[index(right, top)] + sums_[index(left, top)];
    return mean_ + sum / (static_cast<double>(right - left) * (bottom - top));
}

double SquareMeans::variance(int side) const
{
    const auto rows = static_cast<std::size_t>(height_ - side + 1);
    std::vector<double> sums(rows), squares(rows);
    tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x + side <= width_; ++x) {
            const double difference = mean(x, y, x + side, y + side) - mean_;
            sums[row] += difference;
            squares[row] += difference * difference;
        }
    });
    const double count = static_cast<double>(rows) * (width_ - side + 1);
    const double average = std::accumulate(sums.begin(), sums.end(), 0.0) / count;
    return std::accumulate(squares.begin(), squares.end(), 0.0) / count - average * average;
}

std::optional<double> SquareMeans::side_of_variance(double least) const
{
    const int most = std::min(width_, height_) / 2;
    int last = 1, side = 2; // the variance is between theirs
    while (side <= most && variance(side) > least) last = std::exchange(side, side + 1 + side / 8);
    double before = variance(last);
    for (int next = last + 1; next <= std::min(side, most); ++next) {
        const double after = variance(next);
        if (after <= least) return next - 1 + (before - least) / (before - after);
        before = after;
    }
    return std::nullopt;
}

}
