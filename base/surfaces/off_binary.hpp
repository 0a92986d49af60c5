// Binary files of OFF.
#pragma once

#include "base/surfaces/polygon_soup.hpp"

namespace poissonlab {

/// Is the second word of the first line BINARY?
bool is_binary_off(std::string_view bytes);

/// Throws InputError; see read_off().
PolygonSoup read_binary_off(const MeshBytes& file);

}
