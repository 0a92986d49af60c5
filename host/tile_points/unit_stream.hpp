// Whoever needs the points of many tiles takes them from a stream, which a kernel or its plain twin makes.
#pragma once

#include "host/tile_points/tile_points.hpp"

#include <cstdint>
#include <functional>
#include <span>

namespace poissonlab {

/// Hands on the integer positions of the points of the tiles `first` ... `end` - 1 of a block, in pieces of whole
/// tiles.
using UnitStream =
    std::function<void(const PoissonTiling& tiling, const TileBlock& block, std::uint64_t first, std::uint64_t end,
                       const std::function<void(std::span<const std::uint32_t>)>& sink)>;

/// Makes a stream by a kernel. The device and the tiles must outlive what is returned.
UnitStream device_stream(const Device& device, const PoissonTileSet& tiles);

/// Makes a stream by the plain twin, one tile after the other. The tiles must outlive what is returned.
UnitStream reference_stream(const PoissonTileSet& tiles);

}
