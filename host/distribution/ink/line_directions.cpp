#include "host/distribution/ink/line_directions.hpp"

#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr int smoothing_reach = 4; ///< pixels to each side, three times: a Gaussian of some 4.5 pixels

/// Means over `reach` numbers to each side along a row of `count` numbers that are `step` apart, cut at its ends.
void smooth_row(const std::vector<double>& from, std::vector<double>& to, std::size_t first, std::size_t step,
                int count, int reach)
{
    const auto value = [&](int i) { return from[first + static_cast<std::size_t>(i) * step]; };
    for (int i = 0; i < count; ++i) {
        const int low = std::max(0, i - reach), high = std::min(count - 1, i + reach);
        double sum = 0;
        for (int k = low; k <= high; ++k) sum += value(k);
        to[first + static_cast<std::size_t>(i) * step] = sum / (high - low + 1);
    }
}

/// Means over squares around each pixel.
void smooth(std::vector<double>& values, int width, int height, int reach)
{
    stop_if_interrupted();
    std::vector<double> rows(values.size());
    const auto wide = static_cast<std::size_t>(width);
    for (int y = 0; y < height; ++y) smooth_row(values, rows, static_cast<std::size_t>(y) * wide, 1, width, reach);
    for (int x = 0; x < width; ++x) smooth_row(rows, values, static_cast<std::size_t>(x), wide, height, reach);
}

}

LineDirections::LineDirections(const PixelValues& picture, double otherwise)
    : width_(picture.width), otherwise_(otherwise)
{
    const int width = picture.width, height = picture.height;
    PixelValues smoothed = picture;
    for (int i = 0; i < 2; ++i) smooth(smoothed.values, width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double dx = smoothed.at(std::min(x + 1, width - 1), y) - smoothed.at(std::max(x - 1, 0), y);
            const double dy = smoothed.at(x, std::min(y + 1, height - 1)) - smoothed.at(x, std::max(y - 1, 0));
            xx_.push_back(dx * dx);
            xy_.push_back(dx * dy);
            yy_.push_back(dy * dy);
        }
    for (int i = 0; i < 3; ++i)
        for (std::vector<double>* part : {&xx_, &xy_, &yy_}) smooth(*part, width, height, smoothing_reach);
}

double LineDirections::at(double x, double y) const
{
    constexpr double even = 1e-9; // squared change, where black to white is 1
    const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    if (xx_[i] + yy_[i] < even) return otherwise_;
    return std::atan2(2 * xy_[i], xx_[i] - yy_[i]) / 2 + std::numbers::pi / 2;
}

}
