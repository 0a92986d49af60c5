// A page that flies over the endless plane of a texture set, in any browser with WebGL2 and from the disk.
#pragma once

#include "tiles/texture/texture_set.hpp"

#include <string>

namespace poissonlab {

/// The page of a set with has_places(), with all that it needs in it; `name`: how the set is called.
std::string render_plane_page(const TextureSet& set, const std::string& name);

}
