#include "tiles/texture/tiling_measures.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

int step_of(const PngPixels& picture, int x, int y, int dx, int dy)
{
    int sum = 0;
    for (int c = 0; c < picture.channels; ++c)
        sum += std::abs(picture.values[picture.at(x + dx, y + dy, c)] - picture.values[picture.at(x, y, c)]);
    return sum;
}

double mean_step(const PngPixels& picture, int dx, int dy)
{
    std::int64_t sum = 0, count = 0;
    for (int y = 0; y + dy < picture.height; ++y)
        for (int x = 0; x + dx < picture.width; ++x, ++count) sum += step_of(picture, x, y, dx, dy);
    return static_cast<double>(sum) / static_cast<double>(std::max<std::int64_t>(1, count));
}

/// Means by place in the tile, of one direction, over the exemplar's; 1 where that has no steps.
std::vector<double> directed_steps(const PngPixels& tiling, const PngPixels& exemplar, int size, int dx, int dy)
{
    const auto side = static_cast<std::size_t>(size);
    std::vector<std::int64_t> sums(side * side), counts(side * side);
    for (int y = 0; y + dy < tiling.height; ++y)
        for (int x = 0; x + dx < tiling.width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y % size) * side + static_cast<std::size_t>(x % size);
            sums[at] += step_of(tiling, x, y, dx, dy);
            ++counts[at];
        }
    const double natural = mean_step(exemplar, dx, dy);
    std::vector<double> means(sums.size(), 1);
    for (std::size_t i = 0; natural > 0 && i < sums.size(); ++i)
        if (counts[i] > 0) means[i] = static_cast<double>(sums[i]) / static_cast<double>(counts[i]) / natural;
    return means;
}

/// The mean over a column, or of a row.
double line_mean(const std::vector<double>& means, std::size_t side, std::size_t line, bool is_column)
{
    double sum = 0;
    for (std::size_t i = 0; i < side; ++i) sum += is_column ? means[i * side + line] : means[line * side + i];
    return sum / static_cast<double>(side);
}

PngPixels part_of(const PngPixels& picture, int left, int top, int width, int height)
{
    PngPixels part{width, height, picture.channels, {}};
    for (int y = top; y < top + height; ++y) {
        const auto first = picture.values.begin() + static_cast<std::ptrdiff_t>(picture.at(left, y, 0));
        part.values.insert(part.values.end(), first, first + static_cast<std::ptrdiff_t>(width) * picture.channels);
    }
    return part;
}

/// Factors e^(-2 pi i k x / length) of all x.
std::vector<std::complex<double>> fourier_factors(int k, int length)
{
    std::vector<std::complex<double>> factors;
    for (int x = 0; x < length; ++x)
        factors.push_back(std::polar(1.0, -2 * std::numbers::pi * (static_cast<double>(k) * x) / length));
    return factors;
}

double channel_variance(const PngPixels& picture, int channel)
{
    std::int64_t sum = 0, squares = 0;
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = static_cast<std::size_t>(channel); i < picture.values.size(); i += channels) {
        const int value = picture.values[i];
        sum += value;
        squares += value * value;
    }
    const double pixels = static_cast<double>(picture.width) * picture.height, mean = static_cast<double>(sum) / pixels;
    return static_cast<double>(squares) / pixels - mean * mean;
}

/// The power of a channel at u cycles along rows, and as many along columns as make a frequency below 1 / period.
double slow_power_at(const PngPixels& picture, int channel, int u, double period)
{
    const std::vector<std::complex<double>> along = fourier_factors(u, picture.width);
    std::vector<std::complex<double>> rows(static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            rows[static_cast<std::size_t>(y)] +=
                static_cast<double>(picture.values[picture.at(x, y, channel)]) * along[static_cast<std::size_t>(x)];
    const double fx = static_cast<double>(u) / picture.width,
                 pixels = static_cast<double>(picture.width) * picture.height;
    double power = 0;
    const int most = static_cast<int>(picture.height / period);
    for (int v = -most; v <= most; ++v) {
        const double fy = static_cast<double>(v) / picture.height;
        if (fx * fx + fy * fy >= 1 / (period * period) || (u == 0 && v == 0)) continue;
        const std::vector<std::complex<double>> across = fourier_factors(v, picture.height);
        std::complex<double> sum = 0;
        for (std::size_t y = 0; y < rows.size(); ++y) sum += rows[y] * across[y];
        power += std::norm(sum) / (pixels * pixels);
    }
    return u == 0 ? power : 2 * power; // that of -u is as large
}

/// The mean of slow_power() over parts of width x height pixels that cover the picture, as few as do, at even
/// distances.
double mean_slow_power(const PngPixels& picture, int width, int height, int period)
{
    const int columns = (picture.width + width - 1) / width, rows = (picture.height + height - 1) / height;
    double sum = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int left = column * (picture.width - width) / std::max(1, columns - 1),
                      top = row * (picture.height - height) / std::max(1, rows - 1);
            sum += slow_power(part_of(picture, left, top, width, height), period);
        }
    return sum / (columns * rows);
}

std::array<double, 256> cumulative(const PngPixels& picture, int channel)
{
    std::array<double, 256> shares{};
    const double one = 1.0 / (static_cast<double>(picture.width) * picture.height);
    for (std::size_t i = static_cast<std::size_t>(channel); i < picture.values.size();
         i += static_cast<std::size_t>(picture.channels))
        shares[picture.values[i]] += one;
    for (std::size_t i = 1; i < shares.size(); ++i) shares[i] += shares[i - 1];
    return shares;
}

}

StepMap step_map(const PngPixels& tiling, const PngPixels& exemplar, int size)
{
    const auto side = static_cast<std::size_t>(size);
    const std::vector<double> east = directed_steps(tiling, exemplar, size, 1, 0),
                              south = directed_steps(tiling, exemplar, size, 0, 1);
    StepMap map{size, std::vector<double>(east.size()), 0, 0};
    for (std::size_t i = 0; i < east.size(); ++i) map.steps[i] = (east[i] + south[i]) / 2;
    map.border = (line_mean(east, side, side - 1, true) + line_mean(south, side, side - 1, false)) / 2;
    for (std::size_t line = 0; line < side; ++line)
        map.largest = std::max({map.largest, line_mean(east, side, line, true), line_mean(south, side, line, false)});
    return map;
}

double lattice_power(const PngPixels& tiling, int width, int height)
{
    const int columns = tiling.width / width, rows = tiling.height / height;
    const auto wide = static_cast<std::size_t>(width), high = static_cast<std::size_t>(height);
    double lattice = 0, all = 0;
    for (int c = 0; c < tiling.channels; ++c) {
        std::vector<double> folded(wide * high);
        double sum = 0, squares = 0;
        for (int y = 0; y < rows * height; ++y)
            for (int x = 0; x < columns * width; ++x) {
                const double value = tiling.values[tiling.at(x, y, c)];
                folded[static_cast<std::size_t>(y % height) * wide + static_cast<std::size_t>(x % width)] += value;
                sum += value;
                squares += value * value;
            }
        const double copies = static_cast<double>(columns) * rows, pixels = copies * static_cast<double>(folded.size());
        const double mean = sum / pixels;
        for (const double value : folded)
            lattice += (value / copies - mean) * (value / copies - mean) / static_cast<double>(folded.size());
        all += squares / pixels - mean * mean;
    }
    return all > 0 ? lattice / all : 0;
}

double beyond_chance(double share, double squares, double pixels)
{
    const double chance = (pixels - 1) / (squares * pixels - 1);
    return (share - chance) / (1 - chance);
}

std::optional<double> recurrence(const PngPixels& tiling, int width, int height)
{
    const double squares = static_cast<double>(tiling.width / width) * (tiling.height / height);
    const double share = squares < 2 ? 0 : lattice_power(tiling, width, height);
    if (share == 0) return std::nullopt;
    return beyond_chance(share, squares, static_cast<double>(width) * height);
}

double variance_of_channels(const PngPixels& picture)
{
    double sum = 0;
    for (int c = 0; c < picture.channels; ++c) sum += channel_variance(picture, c);
    return sum;
}

double slow_power(const PngPixels& picture, double period)
{
    const int columns = 1 + static_cast<int>(picture.width / period);
    std::vector<double> powers(static_cast<std::size_t>(columns * picture.channels));
    tbb::parallel_for(std::size_t{0}, powers.size(), [&](std::size_t i) {
        const int at = static_cast<int>(i);
        powers[i] = slow_power_at(picture, at / columns, at % columns, period);
    });
    const double all = variance_of_channels(picture);
    return all > 0 ? std::accumulate(powers.begin(), powers.end(), 0.0) / all : 0;
}

std::optional<SlowPower> slow_powers(const PngPixels& tiling, const PngPixels& exemplar, int size)
{
    const int width = std::min(exemplar.width, tiling.width), height = std::min(exemplar.height, tiling.height);
    if (std::max(width, height) <= 2 * size) return std::nullopt;
    const double own = mean_slow_power(exemplar, width, height, 2 * size);
    if (own == 0) return std::nullopt;
    return SlowPower{own, mean_slow_power(tiling, width, height, 2 * size)};
}

double color_distance(const PngPixels& one, const PngPixels& other)
{
    double sum = 0;
    for (int c = 0; c < one.channels; ++c) {
        const auto a = cumulative(one, c), b = cumulative(other, c);
        for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    }
    return sum / one.channels;
}

}
