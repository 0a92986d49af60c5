// Texture coordinates of files of polygons, which CGAL's readers leave out.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace poissonlab {

struct TextureCoordinates
{
    std::vector<TexturePoint> points;
    /// Numbers of points, or no_texture_point, face after face, corner after corner.
    std::vector<std::uint32_t> corners;
};

/// Reads those of the faces of a file, whose corners are numbers of vertices. `end` is that of the file's name, in
/// lower case: other files than .obj and .ply have none. Throws InputError, which names the file and, if it can, the
/// line.
TextureCoordinates read_texture_coordinates(const std::filesystem::path& file, std::string_view end,
                                            const std::vector<std::vector<std::size_t>>& faces);

}
