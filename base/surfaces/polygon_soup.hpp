// Polygons as files have them, and the readers that fill them, one a format.
//
// The readers are the laboratory's own. Assimp 5.2 holds coordinates as floats, makes a vertex of each corner, loses
// triangles of strips, and falls over where a PLY file is damaged; CGAL's readers lose faces of OBJ with tabs, take 16
// seconds to compile, and neither says the line or the reason where a file is wrong.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

struct PolygonSoup
{
    std::vector<MeshPoint> points;
    std::vector<std::uint32_t> corners; ///< numbers of points, face after face
    std::vector<std::uint32_t> sizes;   ///< how many corners each face has

    std::vector<TexturePoint> texture_points;
    std::vector<std::uint32_t> texture_corners; ///< as TriangleMesh has them, of each corner; empty: there are none

    std::vector<MeshPoint> normals;
    std::vector<std::uint32_t> normal_corners; ///< numbers of normals; empty: columns may have the normals
    VertexColumns columns;

    std::size_t lines = 0;          ///< lines and points of the file, which have no area
    std::vector<std::string> notes; ///< see TriangleMesh
};

/// More points or corners than that are refused.
inline constexpr std::size_t most_in_mesh = UINT32_MAX / 4;

/// A file of polygons: its name, which messages begin with, and its bytes.
struct MeshBytes
{
    std::string name;
    std::string_view bytes;
    MeshParts parts = MeshParts::faces;
};

// Each throws InputError, which names the file, the line or the row, and the cause. All points are finite, and all
// corners are there.
PolygonSoup read_obj(const MeshBytes& file);
PolygonSoup read_off(const MeshBytes& file);
PolygonSoup read_ply(const MeshBytes& file);
PolygonSoup read_stl(const MeshBytes& file);
/// Numbers may be in files beside it.
PolygonSoup read_gltf(const MeshBytes& file);

/// Reads a file of one of these formats as it is, by the end of its name. Throws InputError as read_triangle_mesh()
/// does.
PolygonSoup read_polygons(const std::filesystem::path& file, MeshParts parts);

}
