// The power spectrum of one colour of a tiling: its diffraction. Where tiles repeat, or nearly do, it has peaks.
#pragma once

#include "analysis/tilings/color_statistics.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

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
