// Surfaces as triangles, read from files of polygons: OFF, OBJ, PLY and STL, by CGAL.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace poissonlab {

using MeshPoint = std::array<double, 3>;
using MeshTriangle = std::array<std::uint32_t, 3>;

struct TriangleMesh
{
    std::vector<MeshPoint> vertices;     ///< all of them finite
    std::vector<MeshTriangle> triangles; ///< numbers of vertices, counterclockwise as seen from outside
    std::size_t divided = 0;             ///< faces of four corners or more, which became triangles
    std::size_t dropped = 0;             ///< faces of fewer than three corners, or that no triangles fill
};

/// Reads a mesh; the end of its name says the format: .off, .obj, .ply or .stl. Materials, colours, texture coordinates
/// and normals of files are left alone. Throws InputError, a line that names the file: what is no mesh, has no faces,
/// coordinates that are no finite numbers, or faces with vertices that are not there.
TriangleMesh read_triangle_mesh(const std::filesystem::path& file);

/// The corners of a polygon, which may be concave and need not be quite plane, as triangles of their numbers: those of
/// least area that fill it. Nothing where none do.
std::vector<MeshTriangle> polygon_triangles(const std::vector<MeshPoint>& corners);

}
