// Texture tiles by the colours of their corners.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.3; Ng and others 2005, section 3: a patch of the
// exemplar a colour, and a new one in the middle of each tile. With three stages, as Poisson disk tiles are made
// (D. 4.5), a piece around the middle of each edge covers the joint of its patches before; the papers leave it.
//
// Departure: the papers let the middle reach the border, where tiles beyond show something else. Here it ends w pixels
// before: that ring depends on the colours of corners alone.
#pragma once

#include "host/texture/piece_fitting.hpp"

namespace poissonlab {

/// The sources of all tiles, tile after tile, and what all cuts cost.
struct TextureSources
{
    std::vector<SourcePixel> sources;
    std::int64_t cost = 0;
    std::vector<ExemplarWindow> windows; ///< all that are used, patches first
    std::vector<FittedPiece> middles{};  ///< the pieces in the middles of tiles with corners
};

/// `request` is checked, and the exemplar has room for a window. `tiles` are requested_tiles(). Throws InputError where
/// the diversity that is asked for does not fit.
TextureSources make_corner_texture(const PngPixels& exemplar, const TextureRequest& request,
                                   const std::vector<TextureTile>& tiles, const PieceProgress& progress);

}
