// Tests of whether the colours of a stochastic tiling are as random as they should be: the frequency of each, and
// the agreement of colours at some distance from one another. A bad hash function shows in both.
//
// The power spectrum of one colour of a tiling: its diffraction. Where tiles repeat, or nearly do, it has peaks.
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

/// The agreement of colours at each displacement, against the field's own colours in random order.
///
/// By chance the agreement is the sum of the squared frequencies of colours, 1/C where all are as frequent. With n
/// pairs of places at a displacement, m of them of the same colour, z = (m - E m) / sqrt(Var m), where E and Var are
/// those over all orders of the field's colours: mean 0 and variance 1 exactly. (Join counts without replacement: Cliff
/// and Ord, Spatial Autocorrelation, 1973, chapter 1.) Independent colours have them as well, since given its counts of
/// colours each order of an independent field is as probable as any other.
struct ColorAutocorrelation
{
    int lags = 0;          ///< L: displacements from -L to L along each axis
    std::vector<double> z; ///< (2 L + 1)^2 values, y slowest; 0 in the middle, and where any order has as many
    double chance = 0;     ///< the share of pairs that agree in random order, at any displacement
    double largest = 0;    ///< of |z|
    std::array<int, 2> largest_at{}; ///< where, the first in order with y >= 0
    double agreement = 0;            ///< the share of pairs that agree there
    double bound = 0;                ///< what chance exceeds with probability 0.01 in one of all displacements (Sidak)

    bool operator==(const ColorAutocorrelation&) const = default;
};

/// The autocorrelation at displacements up to `lags`. It takes fast Fourier transforms, O(C A log A) for A places;
/// the same bytes for any number of threads. Throws std::invalid_argument unless lags are below width and height of
/// the field.
ColorAutocorrelation color_autocorrelation(const ColorField& field, int lags);

/// Powers of n x n places, `count` of which have the colour: |F|^2 / (n^2 p (1 - p)) with p = count / n^2, where F is
/// the Fourier transform of the places that have the colour. Without frequency 0 its mean is 1; that of independent
/// colours is 1 at every frequency.
struct ColorSpectrum
{
    std::size_t size = 0;      ///< n
    std::uint64_t count = 0;   ///< places of the colour
    std::vector<double> power; ///< rows of n, frequency 0 at (n / 2, n / 2), where it is 0; y slowest, upwards

    /// The highest power.
    double peak() const;

    /// The share of all power that the strongest `share` of all frequencies have. Of independent colours, whose powers
    /// are exponentially distributed: share (1 - ln share).
    double strongest(double share) const;
};

/// The field must be square. Throws std::invalid_argument for other fields, and where all places or none have the
/// colour.
ColorSpectrum color_spectrum(const ColorField& field, std::uint32_t color);

}
