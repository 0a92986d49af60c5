// Files of points on a surface, with columns that describe each point.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Writes points, whole or not at all: .ply has x, y, z as doubles and the normals nx, ny, nz of their triangles as
/// floats, binary in the byte order of this machine, .csv has these columns, and .glb (glTF 2.0) both as floats; other
/// ends are point files as write_points() has them. Throws StorageError.
///
/// With `mesh`, which the surface was made of, .ply and .csv have further columns: face, the number of the point's face
/// in the mesh's file from 0; vertex_0 to vertex_2, the numbers of its triangle's vertices; bary_0 to bary_2, the
/// barycentric coordinates; and numbers of vertices, interpolated linearly: shading_nx, shading_ny and shading_nz, of
/// length 1, u and v, and the mesh's columns under their names. Missing numbers are NaN.
void write_surface_points(const std::filesystem::path& file, const FixedSurface& surface,
                          const std::vector<SurfacePoint>& points, const std::string& comment,
                          const TriangleMesh* mesh = nullptr);

/// The classes of points, one for each.
using SurfaceClasses = std::vector<std::uint32_t>;

/// Writes points that have classes: .ply and .csv have the column class after the normals, and .glb a node and a mesh
/// of points for each class that has some, named class_0, class_1, ...
void write_surface_points(const std::filesystem::path& file, const FixedSurface& surface,
                          const std::vector<SurfacePoint>& points, const SurfaceClasses& classes,
                          const std::string& comment, const TriangleMesh* mesh = nullptr);

/// Returns true for files that can have the further columns.
bool has_surface_columns(const std::filesystem::path& file);

/// Normals of points, three numbers each.
PointSet normals_of(const FixedSurface& surface, const std::vector<SurfacePoint>& points);

/// The barycentric coordinates of a point in its triangle: they add up to exactly 1.
MeshPoint barycentrics_of(const SurfacePoint& point);

}
