// Points of files that lie on a surface.
#pragma once

#include "base/surfaces/triangle_tree.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// The triangles of a surface with shared corners, in the mesh's units.
TriangleMesh triangles_of(const FixedSurface& surface);

/// Reads the only set of a file, in space. Throws InputError if the file is not a point file or has several sets.
PointSet points_in_space(const std::filesystem::path& file);

/// The triangles of a surface in units of its grid, in which no squares overflow or underflow. Corners are not shared.
TriangleMesh triangles_on_grid(const FixedSurface& surface);

/// Makes a point of a position and the place that was to be there, in units of the grid. Places that darts round to the
/// grid are off their triangle by up to sqrt(3)/2, and the shares and the place of the nearest position are rounded by
/// up to 1/2 each along an axis. Places that differ by no more than one unit therefore stay as given: the points of
/// this program keep their distances.
SurfacePoint surface_point(const FixedSurface& surface, const MeshPosition& position, const MeshPoint& given);

/// Points of a surface, and the largest distance by which they were moved.
struct GivenPoints
{
    std::vector<SurfacePoint> points;
    double farthest = 0;
};

/// Moves points to the nearest triangles; places that this program has written stay as they are. Throws InputError, a
/// line that begins with the file's name, where a point is farther than `tolerance` away.
GivenPoints points_on_surface(const FixedSurface& surface, const PointSet& places, double tolerance,
                              const std::filesystem::path& file);

}
