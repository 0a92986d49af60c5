// The power of a frequency, in the order in which spectra and half spectra store it.
#pragma once

#include "analysis/spectra/half_spectrum.hpp"
#include "analysis/spectra/spectrum.hpp"

#include <array>
#include <cstddef>

namespace poissonlab {

/// Frequencies along x, y and z, in 2D 0 along z; each from -M/2 on, and below M/2.
inline double frequency_power(const Spectrum& spectrum, const std::array<int, 3>& f)
{
    const auto m = static_cast<std::size_t>(spectrum.size);
    const auto index = [&](int along) { return static_cast<std::size_t>(along + spectrum.size / 2); };
    const std::size_t slice = spectrum.dimension == 3 ? index(f[2]) : 0;
    return spectrum.power[(slice * m + index(f[1])) * m + index(f[0])];
}

inline double frequency_power(const HalfSpectrum& half, const std::array<int, 3>& f)
{
    const int sign = f[0] < 0 ? -1 : 1; // of f and -f, the one that is stored
    const auto index = [&](int along) { return static_cast<std::size_t>(sign * along + half.size / 2); };
    const auto u = static_cast<std::size_t>(sign * f[0]);
    if (half.dimension == 2) return half.power[u * half.rows() + index(f[1])];
    return half.power[(u * half.lines() + index(f[1])) * half.rows() + index(f[2])];
}

}
