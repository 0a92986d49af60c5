// Measures in the closures of all tiles of a set: the points of a tile with all shared pieces around it.
#pragma once

#include "tiles/poisson/proof/tile_certificate.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

struct ClosureMeasures
{
    std::uint64_t squared_distance = UINT64_MAX; ///< the smallest in any closure, in squared units
    NearestPair nearest;                         ///< the points that have it, of the first tile that has two
    double empty_radius = 0;                     ///< as EmptyBallSearch::radius(), of all tiles
};

/// The points of a closure, and where the tile ends if that is not its square.
struct Closure
{
    std::vector<UnitPosition> points;
    std::vector<UnitPosition> border; ///< a polygon
};

/// Makes the closure of a tile; called from several threads at once.
using ClosureSource = std::function<void(std::uint32_t tile, Closure& closure)>;

/// Runs on all threads; the result is the same for any number of them.
ClosureMeasures measure_closures(const PoissonTileParameters& parameters, const ClosureSource& closure_of);

/// A certificate with these measures and this distance of points without a common tile; without region counts.
TileCertificate certificate_of(const PoissonTileParameters& parameters, const ClosureMeasures& measures,
                               std::uint64_t squared_separation);

/// The lowest tile for which this holds, or the number of tiles. Runs on all threads.
std::uint32_t first_tile_where(std::uint32_t tiles, const std::function<bool(std::uint32_t tile)>& holds);

}
