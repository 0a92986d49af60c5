// Texture tiles whose patches and cuts are chosen for the whole set together.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.3, and the papers before it fit one piece after
// another. Here all pixels of a set, those that tiles share once, are one problem: seams of all tiles, and the power of
// their mean, which tilings repeat. Patches of corners are chosen by all their pairs; pieces over edges and in tiles
// begin as they do one by one; then windows that fit what is there are laid over the dearest place of each corner, edge
// and tile, as large as half a tile, and cut into all tiles at once by expansion moves (Boykov and others 2001; Kwatra
// and others 2003, section 4, hide seams by more windows in the same way). At last every window that a tile shows may
// grow or shrink in it. No move after the first pieces makes the sum dearer.
//
// Wang tiles have a common corner in this way, and fit there; the articles' do not.
#pragma once

#include "host/texture/corner_texture.hpp"

namespace poissonlab {

/// The arguments and errors are those of make_corner_texture(); `request` has no marked corners.
TextureSources make_joint_texture(const PngPixels& exemplar, const TextureRequest& request,
                                  const std::vector<TextureTile>& tiles, const PieceProgress& progress);

}
