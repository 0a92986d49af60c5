// Surfaces as triangles, read from files of polygons: OFF, OBJ, PLY, STL and glTF.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

using MeshPoint = std::array<double, 3>;
using MeshTriangle = std::array<std::uint32_t, 3>;

/// Texture coordinates (u, v).
using TexturePoint = std::array<double, 2>;

/// This number stands for the texture point, or the normal, of a corner that has none.
inline constexpr std::uint32_t no_texture_point = UINT32_MAX;

/// Numbers of vertices beside their places, such as colours, have a row for each vertex and a column for each name.
struct VertexColumns
{
    std::vector<std::string> names;
    std::vector<bool> are_bytes; ///< true for columns of whole numbers from 0 to 255
    std::vector<double> values;  ///< row after row; NaN where a vertex has no such number

    double at(std::size_t vertex, std::size_t column) const { return values[vertex * names.size() + column]; }
};

struct TriangleMesh
{
    std::vector<MeshPoint> vertices;     ///< all of them finite
    std::vector<MeshTriangle> triangles; ///< numbers of vertices, counterclockwise as seen from outside
    std::size_t divided = 0;             ///< faces of four corners or more, which became triangles
    std::size_t dropped = 0;             ///< faces of fewer than three corners, or that no triangles fill

    std::vector<TexturePoint> texture_points = {}; ///< all of them finite
    /// Numbers of texture points, of each triangle, or no_texture_point. Empty: they were not read, or there are none.
    std::vector<MeshTriangle> texture_triangles = {};

    std::vector<MeshPoint> normals =
        {}; ///< of vertices or corners, as long as in the file; those of glTF have length 1
    std::vector<MeshTriangle> normal_triangles = {}; ///< numbers of normals, as for texture points
    VertexColumns columns = {};
    std::vector<std::uint32_t> faces = {}; ///< the number in the file, from 0, of the face of each triangle

    std::vector<std::string> notes = {}; ///< what of the file was left out, a sentence each
};

/// Parts of a mesh that are read.
enum class MeshParts
{
    faces,
    faces_and_texture, ///< faces, and texture coordinates if there are any
    all                ///< these, and normals, colours and all other numbers of vertices
};

/// Reads a mesh; the end of its name says the format: .off, .obj, .ply, .stl, .gltf or .glb. Materials are skipped.
/// Colours are the columns red, green, blue and alpha, in the units of the file; notes name skins and morph targets of
/// glTF, which are left out. Texture coordinates are `vt` of OBJ, s and t, u and v, or texture_u and texture_v of a PLY
/// file's vertices or the list texcoord of its faces, and TEXCOORD_0 of glTF, whose v is counted from below as in OBJ;
/// other formats have none. Vertices are those of the file, in its order; of STL, those at one place are one. Meshes of
/// glTF are joined, each where its nodes put it. Throws InputError, a line that names the file, the place in it and the
/// cause: the file is not a mesh, has no faces, coordinates that are not finite numbers or faces with vertices that are
/// not there, ends early or late, or requires an extension of glTF that is not known here.
TriangleMesh read_triangle_mesh(const std::filesystem::path& file, MeshParts parts = MeshParts::faces);

/// Files that hold a part of a mesh that was read: those of numbers that .gltf names.
std::vector<std::filesystem::path> files_beside_mesh(const std::filesystem::path& file);

/// The corners of a polygon, which may be concave and need not be quite plane, as triangles of their numbers: those of
/// least area that fill it. Nothing where none do.
std::vector<MeshTriangle> polygon_triangles(const std::vector<MeshPoint>& corners);

// Vectors of space, as meshes hold them.

inline MeshPoint difference(const MeshPoint& a, const MeshPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

inline double dot(const MeshPoint& a, const MeshPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline MeshPoint cross(const MeshPoint& a, const MeshPoint& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The vector of length 1 in this direction; along z for the vector of length 0.
inline MeshPoint unit(const MeshPoint& a)
{
    const double length = std::hypot(a[0], a[1], a[2]);
    return length > 0 ? MeshPoint{a[0] / length, a[1] / length, a[2] / length} : MeshPoint{0, 0, 1};
}

}
