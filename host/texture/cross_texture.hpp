// Corner tiles in the manner of Cohen's Wang tiles: four overlapping patches and cuts between them, no new piece.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, figure 5.5a, "a straightforward extension of the method of
// Cohen et al.", which has no text. Here each of the four joints from the middle of an edge to the middle of the tile
// is a minimum cut in a band around the straight line, within a quarter of the tile that the diagonals bound; in the
// ring it is straight.
#pragma once

#include "host/texture/corner_texture.hpp"

namespace poissonlab {

/// The arguments and errors are those of make_corner_texture().
TextureSources make_cross_texture(const PngPixels& exemplar, const TextureRequest& request,
                                  const std::vector<TextureTile>& tiles, const PieceProgress& progress);

}
