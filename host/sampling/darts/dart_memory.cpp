#include "host/sampling/darts/dart_memory.hpp"

#include "host/sampling/cells/cell_hierarchy.hpp"
#include "kernels/common/darts/dart_throwing.h"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

std::size_t six_deviations_above(double mean) { return static_cast<std::size_t>(mean + 6 * std::sqrt(mean)) + 1; }

/// No batch has more darts than the first, a Poisson number.
std::size_t most_darts(std::size_t cells, int dimension)
{
    return six_deviations_above(static_cast<double>(cells) * darts_per_cell(0, dimension));
}

/// The first subdivision leaves 0.83 open cells for each cell of level 0 in 2D, up to 1.604 in 3D, whatever the size of
/// the set; later batches fewer. The lists begin with one.
std::size_t most_open_cells(std::size_t cells, int dimension)
{
    return dimension == 2 ? cells : six_deviations_above(1.605 * static_cast<double>(cells));
}

/// No packing has more points in the grid, and no cell has two: disks of those in a cube of cells lie in a cube that is
/// larger by the distance, and in such a cube they are no denser than anywhere. (Twice as much larger, as it is less
/// than the whole.)
std::size_t most_points_in(const DartTorus& torus, double min_distance)
{
    if (torus.bricks) return torus.cells();
    const double all = static_cast<double>(packing_bound(min_distance, torus.dimension));
    const double side = (torus.grid_size + 2.0 * torus.hierarchy.reach) / torus.hierarchy.size;
    return static_cast<std::size_t>(all * std::min(1.0, std::pow(side, torus.dimension))) + 1;
}

}

/// Later batches have more thresholds than the first.
NeededBuffers dart_buffers(DartBuffers& b, const DartThrowingRequest& request, DartSettling settling,
                           unsigned compute_units)
{
    using namespace contract::dart_throwing;
    const int d = request.dimension;
    const DartTorus torus(request.min_distance, d, request.block, request.bricks);
    const std::size_t cells = torus.cells();
    const std::size_t axes = static_cast<std::size_t>(d);
    const std::size_t most = most_darts(cells, d);
    NeededBuffers buffers{{b.thresholds, poisson_thresholds(darts_per_cell(1, d)).size()},
                          {b.masks, cells * MASK_WORDS(d, torus.hierarchy.reach)},
                          {b.positions, cells * axes},
                          {b.points, most_points_in(torus, request.min_distance) * POINT_WORDS(d)},
                          {b.counters, COUNTERS},
                          {b.parents, most_open_cells(cells, d) * PARENT_WORDS(axes, torus.bricks != nullptr)},
                          {b.open, most_open_cells(cells, d) * PARENT_WORDS(axes, torus.bricks != nullptr)},
                          {b.darts, std::max(cells, most) * DART_WORDS(d)}};
    if (torus.bricks) {
        buffers.push_back({b.brick_corners, torus.bricks->corners.size()});
        buffers.push_back({b.bricks_around, torus.bricks->around.size()});
    }
    for (const NeededBuffer& buffer : b.land.needed(request)) buffers.push_back(buffer);
    for (const NeededBuffer& buffer : settling_buffers(b, settling, torus, compute_units, most))
        buffers.push_back(buffer);
    return buffers;
}

}
