// A page on which texture tiles are drawn by hand, in any browser and from the disk: Cohen, Shade, Hiller, Deussen,
// Wang Tiles for Image and Texture Generation, 2003, section 3.1. A mark that crosses an edge is in every tile with the
// edge's colour, and of corner tiles one that crosses a corner is at every corner of its colour.
//
// A page that flies over the endless plane of a texture set, in any browser with WebGL2 and from the disk.
#pragma once

#include "tiles/texture/texture_set.hpp"

#include <string>

namespace poissonlab {

/// The page for a complete set of corner or Wang tiles without pixels: its kind, colours, size, ring and tiles.
std::string render_design_page(const TextureSet& set);

/// The page of a set with has_places(), with all that it needs in it; `name`: how the set is called.
std::string render_plane_page(const TextureSet& set, const std::string& name);

}
