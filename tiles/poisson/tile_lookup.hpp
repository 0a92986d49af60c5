// Which tile of a Poisson tile set is where: the look-up of docs/tile-set-file.md, by the header that engines
// use.
#pragma once

#include "runtime/poisson_tiles.h"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>

namespace poissonlab {

/// Which of the tilings of a set: every seed gives another one. Along each axis it closes after `period`
/// tiles; 0: never.
struct PoissonTiling
{
    std::uint32_t seed = 1;
    std::int32_t period = 0;
};

/// A tiling as the runtime header takes it. With points, `tiles` must outlive it.
inline ptiles_tiling runtime_tiling(const PoissonTileSet& tiles, const PoissonTiling& tiling)
{
    const PoissonTileParameters& p = tiles.parameters;
    return {{static_cast<std::uint32_t>(p.kind), static_cast<std::uint32_t>(p.dimension), p.colors, p.tiles,
             p.points_per_tile, tiles.points.data()},
            tiling.seed,
            tiling.period};
}

/// The same without points.
class TileLookup
{
public:
    TileLookup(PoissonTileKind kind, int dimension, std::uint32_t colors, std::uint32_t tiles, std::uint32_t seed,
               std::int32_t period = 0)
        : tiling_{{static_cast<std::uint32_t>(kind), static_cast<std::uint32_t>(dimension), colors, tiles, 0, nullptr},
                  seed,
                  period}
    {}

    /// The number of the tile whose lowest corner is at this place; in 2D, k is not looked at.
    std::uint32_t operator()(std::int32_t i, std::int32_t j, std::int32_t k = 0) const
    {
        return ptiles_tile(&tiling_, i, j, k);
    }

private:
    ptiles_tiling tiling_;
};

}
