// The complex numbers of length 1 at whole parts of a turn, so that host and kernels multiply the same bits.
#pragma once

#include "tiles/poisson/tile_regions.hpp"

#include <complex>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// exp(-2 pi i n / 65,536) for n from 0 to 65,535: what a point n units along an axis adds to the lowest frequency.
const std::vector<std::complex<double>>& unit_circle();

/// The entry for a frequency (cycles a tile) and a position.
inline std::uint32_t phase_of(const std::array<std::int32_t, 2>& frequency, std::int32_t x, std::int32_t y)
{
    const auto phase = static_cast<std::uint32_t>(frequency[0]) * static_cast<std::uint32_t>(x) +
                       static_cast<std::uint32_t>(frequency[1]) * static_cast<std::uint32_t>(y);
    return phase & (tile_units - 1);
}

}
