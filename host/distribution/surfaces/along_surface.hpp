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

/// Lengths of paths prove this. They may be wrong by a part for rounding, and by a little because sources in corners
/// and on edges are moved; both are in the mesh's units.
struct PathRule
{
    double distance = 0; ///< a path at least so long is as long as the rule asks
    double sure = 0;     ///< places with a shorter path are covered
};
PathRule path_rule(const FixedSurface& surface, const TriangleMesh& mesh, const contract::surface::SurfaceRule& rule);

/// A part of a path's length by which rounding may change it: far more than it is found to do.
inline constexpr double path_rounding = 1e-9;

/// The middle of a piece, and the largest distance of its places from it in the mesh's units.
struct PieceDisk
{
    SurfacePoint middle{};
    double radius = 0;
};
PieceDisk disk_of(const FixedSurface& surface, const SurfacePiece& piece);

/// The state of a piece by the length of a path from a point to its middle.
std::uint32_t state_by_path(const SurfacePiece& piece, const PieceDisk& disk, double length, const PathRule& rule);

/// Changes the state of a piece to one that was found, from several threads: covered goes before small, small before
/// open.
void note_state(std::uint32_t& piece, std::uint32_t found);

/// Makes an engine that throws darts by distances along the surface. The rule's normals do not matter.
std::unique_ptr<SurfaceDartEngine> path_dart_engine(const SurfaceDartRequest& request);

/// Finds the order of removal by a heap, see SurfaceRemovalOrder. Keeps all pairs of near points in memory.
std::vector<std::uint32_t> removal_order_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                               const SurfaceReach& reach, std::size_t count);

/// Lengths of the shortest paths between points, in the mesh's units. Points that reach no other one within some
/// sixteen mean distances count as alone.
struct PathDistances
{
    double least = 0;        ///< infinite where all points are alone
    double mean_nearest = 0; ///< of the others; 0 where there are none
};
PathDistances distances_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points);

/// Those of the points of `from` from their nearest ones of `to`; of others, where both are one object.
PathDistances distances_along(const FixedSurface& surface, const std::vector<SurfacePoint>& from,
                              const std::vector<SurfacePoint>& to);

/// Are all paths from points number `first` and later to others at least so long, but for rounding?
bool keep_distance_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points, double distance,
                         std::size_t first = 0);

/// Returns the number of places to which no path from a point is shorter than a distance in the mesh's units.
std::size_t uncovered_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                            const std::vector<SurfacePoint>& places, double distance);

}
