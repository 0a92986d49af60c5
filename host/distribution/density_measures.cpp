#include "host/distribution/density_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

using PixelPoint = std::array<double, 2>;

std::vector<PixelPoint> in_pixels(const PixelPlaces& places)
{
    std::vector<PixelPoint> points;
    for (std::size_t i = 0; i < places.size(); i += 2)
        points.push_back(
            {static_cast<double>(places[i]) / 4294967296.0, static_cast<double>(places[i + 1]) / 4294967296.0});
    return points;
}

/// The weight of each window of a density. Pixels that lie in two windows are split by area.
std::vector<double> window_weights(const Density& density)
{
    const auto parts = [](int pixels) {
        std::vector<std::vector<double>> shares(static_cast<std::size_t>(pixels), std::vector<double>(density_windows));
        for (int pixel = 0; pixel < pixels; ++pixel)
            for (int window = 0; window < density_windows; ++window) {
                const double low = std::max<double>(pixel, static_cast<double>(window) * pixels / density_windows);
                const double high = std::min<double>(pixel + 1, (window + 1.0) * pixels / density_windows);
                shares[static_cast<std::size_t>(pixel)][static_cast<std::size_t>(window)] = std::max(0.0, high - low);
            }
        return shares;
    };
    const auto columns = parts(density.width), rows = parts(density.height);
    std::vector<double> weights(density_windows * density_windows);
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const auto weight = static_cast<double>(density.weights[row * columns.size() + column]);
            for (std::size_t y = 0; y < density_windows; ++y) {
                if (rows[row][y] == 0) continue;
                for (std::size_t x = 0; x < density_windows; ++x)
                    weights[y * density_windows + x] += weight * rows[row][y] * columns[column][x];
            }
        }
    return weights;
}

}

double density_error(const Density& density, const PixelPlaces& places)
{
    const std::vector<double> weights = window_weights(density);
    std::vector<double> counts(weights.size());
    for (const auto& [x, y] : in_pixels(places)) {
        const auto column = static_cast<std::size_t>(x / density.width * density_windows);
        const auto row = static_cast<std::size_t>(y / density.height * density_windows);
        ++counts[row * density_windows + column];
    }
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0;
    int windows = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double expected = weights[i] / total * static_cast<double>(places.size()) / 2;
        if (expected <= 1) continue;
        sum += (counts[i] - expected) * (counts[i] - expected) / expected;
        ++windows;
    }
    return windows == 0 ? 0 : sum / windows;
}

LocalSpacing local_spacing(const Density& density, const PixelPlaces& places)
{
    std::vector<PixelPoint> points = in_pixels(places);
    std::ranges::sort(points);
    double total = 0;
    for (const std::uint64_t weight : density.weights) total += static_cast<double>(weight);
    LocalSpacing spacing{0, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest = std::numeric_limits<double>::infinity(); // squared
        const auto look = [&](std::size_t k) {
            const double x = points[k][0] - points[i][0], y = points[k][1] - points[i][1];
            nearest = std::min(nearest, x * x + y * y);
            return x * x < nearest;
        };
        for (std::size_t k = i; k-- > 0 && look(k);) {
        }
        for (std::size_t k = i + 1; k < points.size() && look(k); ++k) {
        }
        const auto column = static_cast<std::size_t>(points[i][0]), row = static_cast<std::size_t>(points[i][1]);
        const auto weight =
            static_cast<double>(density.weights[row * static_cast<std::size_t>(density.width) + column]);
        const double points_a_pixel = weight / total * static_cast<double>(points.size());
        const double part = std::sqrt(nearest * points_a_pixel * std::numbers::sqrt3 / 2);
        spacing.mean += part / static_cast<double>(points.size());
        spacing.least = std::min(spacing.least, part);
    }
    return spacing;
}

}
