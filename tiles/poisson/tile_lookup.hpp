// The tilings of a Poisson tile set: the look-up of docs/tile-set-file.md, by the header that engines use.
#pragma once

#include "runtime/poisson_tiles.h"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>

namespace poissonlab {

/// One of the tilings of a set: every seed gives another one. Along each axis it closes after `period` tiles; 0: never.
struct PoissonTiling
{
    std::uint32_t seed = 1;
    std::int32_t period = 0;
};

/// A tiling as the runtime header takes it. With points, `tiles` must outlive it.
inline ptiles_tiling runtime_tiling(const PoissonTileSet& tiles, const PoissonTiling& tiling)
{
    const PoissonTileParameters& p = tiles.parameters;
    const StoredScale scale = stored_scale(p.border);
    const Overhang overhang = overhang_of(tiles);
    return {{static_cast<std::uint32_t>(p.kind), static_cast<std::uint32_t>(p.dimension), p.colors, p.tiles,
             p.points_per_tile, tiles.points.data(), scale.low, scale.step, overhang.below, overhang.above,
             tiles.ranks.empty() ? nullptr : tiles.ranks.data(), static_cast<std::uint32_t>(p.classes.count()),
             reinterpret_cast<const unsigned char*>(p.classes.points.data()), // whose machines are little-endian
             tiles.squared_min_distance, p.equal_moments},
            tiling.seed,
            tiling.period};
}

}
