// Points by distances along a surface: dart throwing, sample elimination, and what sets are measured by. The distance
// of two points is the length of the shortest path between them, see base/surfaces/surface_paths.hpp.
//
// Paths are exact but for the rounding of doubles, so that there are no kernels, and no second program with the same
// bytes. Points of different parts of a surface, and those on two sides of a sheet, are as far apart as paths are long.
#pragma once

#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"
#include "host/sampling/surfaces/surface_elimination.hpp"

#include "base/surfaces/triangle_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace poissonlab {

/// Gives the points as positions on triangles_of(surface).
std::vector<MeshPosition> positions_of(const std::vector<SurfacePoint>& points);

/// Makes an engine that throws darts by distances along the surface. The rule's normals do not matter.
std::unique_ptr<SurfaceDartEngine> path_dart_engine(const SurfaceDartRequest& request);

/// Finds the order of removal by a heap, see SurfaceRemovalOrder. Keeps all pairs of near points in memory.
std::vector<std::uint32_t> removal_order_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                               const SurfaceReach& reach, std::size_t count);

/// Lengths of the shortest paths between points, in the mesh's units. Points that reach no other one within some
/// sixteen mean distances count as alone.
struct PathDistances
{
    double least = 0; ///< infinite where all points are alone
    double mean_nearest = 0;
};
PathDistances distances_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points);

/// Are all paths from points number `first` and later to others at least so long, but for rounding?
bool keep_distance_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points, double distance,
                         std::size_t first = 0);

/// Returns the number of places to which no path from a point is shorter than a distance in the mesh's units.
std::size_t uncovered_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                            const std::vector<SurfacePoint>& places, double distance);

}
