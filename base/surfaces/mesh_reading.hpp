// Formats of meshes, which the ends of names say.
#pragma once

#include "base/surfaces/polygon_soup.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

struct MeshFormat
{
    std::string_view end; ///< of names, in lower case
    PolygonSoup (*read)(const MeshBytes& file);
    std::string_view faces; ///< what is not there in a file without faces
};

/// Null where the end of the name is that of no mesh.
const MeshFormat* mesh_format(const std::filesystem::path& file);

/// The end of a name in lower case.
std::string mesh_end(const std::filesystem::path& file);

}
