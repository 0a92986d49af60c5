// The points of a Poisson disk tiling that is laid over the texture coordinates of a surface.
//
// Tile (i, j) covers u from i / T to (i + 1) / T and v likewise, with T tiles a unit: the tiling is that of `tiles
// points` with the same seed, or that of its torus.
#pragma once

#include "host/distribution/surfaces/texture_plane.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// Points, by rows of tiles from below, in each from the left, the points of a tile as they are stored.
struct LaidPoints
{
    std::vector<SurfacePoint> points;
    std::vector<TexturePoint> texture; ///< of each, its texture coordinates
    std::vector<double> levels;        ///< of each, the density above which it is there
    std::size_t repetitions = 0;       ///< points that one before is a repetition of, on another triangle
};

LaidPoints lay_tiles(const FixedSurface& surface, const TexturePlane& plane, const PoissonTileSet& tiles,
                     const PoissonTiling& tiling);

/// Returns how many points these are.
std::uint64_t count_laid_points(const TexturePlane& plane, const PoissonTileSet& tiles, const PoissonTiling& tiling);

}
