// Tests of whether the colours of a stochastic tiling are as random as they should be: the frequency of each, and
// the agreement of colours at some distance from one another. A bad hash function shows in both.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// Colours 0 .. `colors` - 1 on a part of a lattice, row by row.
struct ColorField
{
    std::uint32_t colors = 2;
    std::size_t width = 0;
    std::vector<std::uint8_t> values;

    std::size_t height() const { return width == 0 ? 0 : values.size() / width; }
};

/// Pearson's chi-square test of counts that should be equal on average.
struct FrequencyTest
{
    double chi_square = 0; ///< sum of (count - mean)^2 / mean
    /// The probability that chance makes it at least as large: chi-square with n - 1 degrees of freedom.
    double p_value = 1;

    bool operator==(const FrequencyTest&) const = default;
};

/// Tests whether counts are equally frequent. With fewer than two counts, or if all are 0, p = 1 and chi-square 0.
FrequencyTest test_frequencies(std::span<const std::uint64_t> counts);

/// The number of places of each colour.
std::vector<std::uint64_t> color_counts(const ColorField& field);

/// The agreement of colours at each displacement, against independent and equally frequent ones.
///
/// With n pairs of places at a displacement, m of them of the same colour, z = (m - n/C) / sqrt(n/C (1 -
/// 1/C)): for independent colours of equal probability 1/C, mean 0 and variance 1 exactly (pairs of places
/// are independent two by two even where they share a place).
struct ColorAutocorrelation
{
    int lags = 0;                    ///< L: displacements from -L to L along each axis
    std::vector<double> z;           ///< (2 L + 1)^2 values, y slowest; 0 in the middle, where all colours agree
    double largest = 0;              ///< of |z|
    std::array<int, 2> largest_at{}; ///< where, the first in order with y >= 0
    double bound = 0;                ///< what chance exceeds with probability 0.01 in one of all displacements (Sidak)

    bool operator==(const ColorAutocorrelation&) const = default;
};

/// The autocorrelation at displacements up to `lags`. It takes fast Fourier transforms, O(C A log A) for A places;
/// the same bytes for any number of threads. Throws std::invalid_argument unless lags are below width and height of
/// the field.
ColorAutocorrelation color_autocorrelation(const ColorField& field, int lags);

}
