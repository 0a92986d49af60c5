// Samples are sorted by pixel; then bands of rows are made independently of each other. A band goes through
// the samples of its own rows and of the two or three around it in sorted order and adds each to the pixels
// that it reaches, so that every pixel meets its samples in the same order whichever band it is in.
#include "analysis/zone_plate/reconstruction.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr int rows_of_a_band = 32;
constexpr int reach = 2; // rows and columns of pixels beyond a sample's own that it can count in

struct Sample
{
    double x; // in pixels
    double y;
    double value;
};

/// Samples by pixel, row by row, within a pixel in the order of the set; those of pixel p are begin[p] up to
/// begin[p + 1].
struct SortedSamples
{
    int size;
    std::vector<std::uint32_t> begin;
    std::vector<Sample> samples;

    std::span<const Sample> rows(int first, int end) const { return cells(0, first, 0, end); }
    std::span<const Sample> of_pixel(int column, int row) const { return cells(column, row, column + 1, row); }

private:
    // The samples of the pixels from one up to another, in the order of pixels.
    std::span<const Sample> cells(int from_column, int from_row, int to_column, int to_row) const
    {
        const auto number = [&](int column, int row) {
            return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
        };
        const auto from = begin[number(from_column, from_row)];
        return std::span(samples).subspan(from, begin[number(to_column, to_row)] - from);
    }
};

std::uint32_t pixel_of(const Sample& sample, int size)
{
    // A coordinate just below 1 can be rounded up to `size`.
    const auto column = std::min(static_cast<int>(sample.x), size - 1);
    const auto row = std::min(static_cast<int>(sample.y), size - 1);
    return static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(size) + static_cast<std::uint32_t>(column);
}

SortedSamples sort_samples(const PointSet& points, std::span<const double> values, int size)
{
    const auto sample = [&](std::size_t k) {
        const auto x = points[k];
        return Sample{x[0] * size, x[1] * size, values[k]};
    };
    const std::size_t n = points.size();
    const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    SortedSamples sorted{size, std::vector<std::uint32_t>(pixels + 1), std::vector<Sample>(n)};
    std::vector<std::uint32_t> pixel(n);
    for (std::size_t k = 0; k < n; ++k) ++sorted.begin[pixel[k] = pixel_of(sample(k), size)];

    // Counts become ends, and, from the last sample to the first, beginnings.
    std::uint32_t end = 0;
    for (auto& count : sorted.begin) count = end += count;
    for (std::size_t k = n; k-- > 0;) sorted.samples[--sorted.begin[pixel[k]]] = sample(k);
    return sorted;
}

/// The four pixels along an axis that a sample at x counts in, and with which weights.
struct Taps
{
    int first;
    std::array<double, 4> weights;
};

Taps taps(double x)
{
    const double below = std::floor(x - 0.5); // the last pixel whose centre is not above x
    const double t = x - 0.5 - below;
    return {static_cast<int>(below) - 1,
            {mitchell_weight(1 + t), mitchell_weight(t), mitchell_weight(1 - t), mitchell_weight(2 - t)}};
}

struct WeightedSum
{
    double weights = 0;
    double values = 0;
};

/// Sums of rows `first` up to `end`.
std::vector<WeightedSum> weighted_sums(const SortedSamples& sorted, int first, int end)
{
    const int size = sorted.size;
    std::vector<WeightedSum> sums(static_cast<std::size_t>(end - first) * static_cast<std::size_t>(size));
    const auto near = sorted.rows(std::max(first - reach, 0), std::min(end + reach, size));
    for (const Sample& sample : near) {
        const Taps across = taps(sample.x);
        const Taps up = taps(sample.y);
        for (int j = 0; j < 4; ++j) {
            const int row = up.first + j;
            if (row < first || row >= end) continue;
            WeightedSum* const line =
                sums.data() + static_cast<std::size_t>(row - first) * static_cast<std::size_t>(size);
            for (int i = 0; i < 4; ++i) {
                const int column = across.first + i;
                if (column < 0 || column >= size) continue;
                const double weight =
                    up.weights[static_cast<std::size_t>(j)] * across.weights[static_cast<std::size_t>(i)];
                line[column].weights += weight;
                line[column].values += weight * sample.value;
            }
        }
    }
    return sums;
}

/// The value of the sample nearest to the centre of a pixel, of those in the 5 x 5 pixels around it.
double nearest_value(const SortedSamples& sorted, int column, int row)
{
    double nearest = std::numeric_limits<double>::infinity();
    double value = empty_pixel;
    for (int j = std::max(row - reach, 0); j <= std::min(row + reach, sorted.size - 1); ++j)
        for (int i = std::max(column - reach, 0); i <= std::min(column + reach, sorted.size - 1); ++i)
            for (const Sample& sample : sorted.of_pixel(i, j)) {
                const double dx = sample.x - column - 0.5;
                const double dy = sample.y - row - 0.5;
                const double squared = dx * dx + dy * dy;
                if (squared >= nearest) continue;
                nearest = squared;
                value = sample.value;
            }
    return value;
}

void make_band(const SortedSamples& sorted, int first, int end, SquareImage& image)
{
    const auto sums = weighted_sums(sorted, first, end);
    double* pixel = image.pixels.data() + static_cast<std::size_t>(first) * static_cast<std::size_t>(image.size);
    for (int row = first, at = 0; row < end; ++row)
        for (int column = 0; column < image.size; ++column, ++at) {
            const WeightedSum& sum = sums[static_cast<std::size_t>(at)];
            *pixel++ = sum.weights >= least_weight ? sum.values / sum.weights : nearest_value(sorted, column, row);
        }
}

}

int one_sample_a_pixel(std::size_t points)
{
    return std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(points)))));
}

SquareImage reconstruct(const PointSet& points, std::span<const double> values, int size)
{
    if (points.dimension != 2 || points.size() == 0 || points.size() != values.size() || size < 1)
        throw std::invalid_argument("reconstruct: needs a 2D set with a value a point, and pixels");
    const auto sorted = sort_samples(points, values, size);
    SquareImage image{size, std::vector<double>(sorted.begin.size() - 1)};
    const int bands = (size + rows_of_a_band - 1) / rows_of_a_band;
    tbb::parallel_for(0, bands, [&](int band) {
        const int first = band * rows_of_a_band;
        make_band(sorted, first, std::min(first + rows_of_a_band, size), image);
    });
    return image;
}

}
