// The complex numbers of length 1 at whole parts of a turn, so that host and kernels multiply the same bits.
#pragma once

#include "tiles/poisson/tile_position.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Whole cycles a tile along each axis; 2D: z is 0.
using TileFrequency = std::array<std::int32_t, 3>;

/// exp(-2 pi i n / 65,536) for n from 0 to 65,535: what a point n units along an axis adds to the lowest frequency.
const std::vector<std::complex<double>>& unit_circle();

/// The entry for a frequency (cycles a tile) and a position.
inline std::uint32_t phase_of(const TileFrequency& frequency, const TilePosition& position)
{
    std::uint32_t phase = 0;
    for (std::size_t k = 0; k < 3; ++k)
        phase += static_cast<std::uint32_t>(frequency[k]) * static_cast<std::uint32_t>(position[k]);
    return phase & (tile_units - 1);
}

}
