// Penrose points, plain and sequential: what the kernels must reproduce.
#include "host/tile_sampling/penrose/penrose_walk.hpp"

namespace poissonlab::reference {

std::vector<PenrosePoint> penrose_points(const PenroseTiling& tiling, std::uint64_t importance,
                                         const PenroseWindow& window)
{
    const PenroseWalk walk(tiling, importance, window);
    PenroseStart start = start_penrose(tiling, importance, window);
    std::vector<PenrosePoint> points = std::move(start.points);
    for (const contract::penrose::Tile& triangle : start.triangles)
        visit_new_points(walk, tile_of(triangle), [&](const PenroseTile& point) { walk.keep(point, points); });
    return points;
}

}
