// Farthest point optimization: one point after the other moves to where all others leave the largest empty circle.
//
// Schloemer, Heck, Deussen, Farthest-point optimized point sets with maximized minimum distance, High Performance
// Graphics 2011, the local variant: a point moves to the farthest of the Voronoi vertices around its neighbours, as
// they are without it, if that is farther from all of them than the point is. Coordinates are multiples of 2^-32.
//
// So that many points can move side by side, the torus is a grid of cells in five by five colors; those of one color
// are at work together, each with the points that lie in it at that time. A point looks at the 5 x 5 cells around its
// own, of 2.5 points each, which no other cell of its color looks at, and moves to centres of circles that are inside
// of these only: the result is that of one point after the other, and the smallest distance never falls. In sets of a
// few points, or very uneven ones, moves are missed by that; later sweeps make up for it.
#pragma once

#include "host/sampling/lloyd_relaxation.hpp"

#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// Cells along each axis: a multiple of five, or three for sets of a few points, whose cells are at work alone.
std::uint32_t farthest_point_grid(std::size_t points);

/// The set with coordinates as multiples of 2^-32, rounded down.
PointSet snapped_down(PointSet points);

/// `points` has at least one point, in 2D. An iteration is a sweep: each point moves once. The energies of records are
/// those of Lloyd relaxation.
namespace reference {
LloydResult move_to_farthest(const PointSet& points, const LloydRequest& request);
}

/// Moves points by kernels/farthest_point.cl, to the places of the reference. Energies of records are equal to its own
/// within rounding.
class FarthestPointOptimization
{
public:
    /// `work_group_size` 0: the default.
    explicit FarthestPointOptimization(Device device, std::size_t work_group_size = 0);

    LloydResult optimize(const PointSet& points, const LloydRequest& request);

    /// The memory that optimize() takes, and gives back.
    static DeviceMemory memory(std::size_t points);

private:
    Device device_;
    std::size_t work_group_size_;
};

/// The sampler "farthest-point": iterations, start, until_relative_radius.
SamplerSpec farthest_point_sampler();

}
