// Files of points on surfaces.
#pragma once

#include "host/sampling/surfaces/fixed_surface.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Writes points, whole or not at all: .ply has x, y, z as doubles and the normals nx, ny, nz of their triangles as
/// floats, binary in the byte order of this machine; other ends are point files as write_points() has them. Throws
/// StorageError.
void write_surface_points(const std::filesystem::path& file, const FixedSurface& surface,
                          const std::vector<SurfacePoint>& points, const std::string& comment);

/// Normals of points, three numbers each.
PointSet normals_of(const FixedSurface& surface, const std::vector<SurfacePoint>& points);

}
