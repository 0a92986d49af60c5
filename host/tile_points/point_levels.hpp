// Tilings of lower density: which points are left.
//
// Each point has a level, the density above which it is there: with ranked tiles by its rank, else by chance. More
// density adds points and moves none. See ptiles_in_window in runtime/poisson_tiles.h.
#pragma once

#include "host/tile_points/tile_points.hpp"

#include <span>
#include <vector>

namespace poissonlab {

/// The levels of a block's points, in pieces, in the order of TilePointGenerator::stream().
class PointLevels
{
public:
    /// `tiles` must outlive this. `block` is one that check() accepts, `first` the tile of it that comes first.
    PointLevels(const PoissonTileSet& tiles, const PoissonTiling& tiling, const TileBlock& block,
                std::uint64_t first = 0);

    /// Returns the levels of the next `tiles` tiles; they are valid until the next call.
    std::span<const double> next(std::size_t tiles);

private:
    /// Writes the levels of a tile, which is known by its place in the block.
    void write_tile(std::uint64_t tile, double* levels) const;

    ptiles_tiling tiling_;
    TileBlock block_;
    std::uint64_t done_ = 0; ///< tiles
    std::vector<double> levels_;
};

/// The points of a torus, made by TilePointGenerator::generate_torus() or its reference, with a level below `density`.
PointSet at_density(PointSet points, double density, const PoissonTileSet& tiles, std::uint32_t seed,
                    std::uint32_t period);

}
