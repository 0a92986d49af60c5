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
