#include "host/texture/advice/picture_scales.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace poissonlab {
namespace {

/// Sums over rectangles of a map, whose mean is subtracted first: sums stay small.
class LightSums
{
public:
    explicit LightSums(const LightMap& light)
        : width_(light.width), height_(light.height),
          mean_(std::accumulate(light.values.begin(), light.values.end(), 0.0) /
                static_cast<double>(light.values.size())),
          sums_((static_cast<std::size_t>(width_) + 1) * (static_cast<std::size_t>(height_) + 1))
    {
        for (int y = 0; y < height_; ++y) {
            double row = 0;
            for (int x = 0; x < width_; ++x) {
                row += light.at(x, y) - mean_;
                sums_[index(x + 1, y + 1)] = row + sums_[index(x + 1, y)];
            }
        }
    }

    /// The mean over columns and rows from the first to before the last.
    double mean(int left, int top, int right, int bottom) const
    {
        const double sum = sums_[index(right, bottom)] - sums_[index(left, bottom)] - sums_[index(right, top)] +
                           sums_[index(left, top)];
        return mean_ + sum / (static_cast<double>(right - left) * (bottom - top));
    }

    /// The variance of the means over all squares of a side.
    double variance(int side) const
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

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 1) + static_cast<std::size_t>(x);
    }

    int width_, height_;
    double mean_;
    std::vector<double> sums_;
};

}

ReducedPicture reduced_picture(const PngPixels& picture, std::size_t most)
{
    const double pixels = static_cast<double>(picture.width) * picture.height;
    const int shorter = std::min(picture.width, picture.height);
    const int factor =
        std::min(shorter, std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / static_cast<double>(most))))));
    if (factor == 1) return {picture, 1};
    PngPixels small{picture.width / factor, picture.height / factor, picture.channels, {}};
    small.values.resize(small.at(0, small.height, 0));
    tbb::parallel_for(0, small.height, [&](int y) {
        std::vector<int> sums(small.at(0, 1, 0));
        for (int row = y * factor; row < (y + 1) * factor; ++row)
            for (int x = 0; x < small.width * factor; ++x)
                for (int c = 0; c < picture.channels; ++c)
                    sums[small.at(x / factor, 0, c)] += picture.values[picture.at(x, row, c)];
        const int area = factor * factor;
        for (std::size_t i = 0; i < sums.size(); ++i)
            small.values[small.at(0, y, 0) + i] = static_cast<std::uint8_t>((sums[i] + area / 2) / area);
    });
    return {std::move(small), factor};
}

LightMap without_slow_light(const LightMap& light, int reach)
{
    const LightSums sums(light);
    LightMap map = light;
    tbb::parallel_for(0, map.height, [&](int y) {
        const int top = std::max(0, y - reach), bottom = std::min(map.height, y + reach + 1);
        for (int x = 0; x < map.width; ++x)
            map.values[map.index(x, y)] -=
                sums.mean(std::max(0, x - reach), top, std::min(map.width, x + reach + 1), bottom);
    });
    return map;
}

std::optional<double> side_at_share(const LightMap& light, double share)
{
    const LightSums sums(light);
    const double pixels = sums.variance(1);
    if (!(pixels > 0)) return std::nullopt;
    const int most = std::min(light.width, light.height) / 2;
    int last = 1, side = 2; // the share is between theirs
    while (side <= most && sums.variance(side) > share * pixels) last = std::exchange(side, side + 1 + side / 8);
    double before = sums.variance(last) / pixels;
    for (int next = last + 1; next <= std::min(side, most); ++next) {
        const double part = sums.variance(next) / pixels;
        if (part <= share) return next - 1 + (before - share) / (before - part);
        before = part;
    }
    return std::nullopt;
}

}
