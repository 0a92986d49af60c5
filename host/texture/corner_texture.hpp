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

/// Which samples lie where in a Wang tile, T^2 pixels a tile: for smoothing, which the papers tried and which fails.
struct BowTies
{
    std::vector<std::uint8_t> shown;     ///< 1 where a vertical edge's sample is shown
    std::vector<SourcePixel> vertical;   ///< the source in that sample, whether it is shown or not
    std::vector<SourcePixel> horizontal; ///< the same of the horizontal edge's
};

/// The sources of all tiles, tile after tile, and what all cuts cost.
struct TextureSources
{
    std::vector<SourcePixel> sources;
    std::int64_t cost = 0;
    std::vector<ExemplarWindow> windows; ///< all patches or samples, then pieces that are shown
    std::size_t patches = 0;             ///< how many of them are patches or samples
    std::vector<FittedPiece> middles{};  ///< the pieces in the middles of tiles with corners
    BowTies bow_ties{};                  ///< of Wang tiles
    std::vector<std::string> notes{};    ///< lines that a person should read
};

/// `request` is checked, and the exemplar has room for a window. `tiles` are requested_tiles(). Throws InputError where
/// the diversity that is asked for does not fit.
TextureSources make_corner_texture(const PngPixels& exemplar, const TextureRequest& request,
                                   const std::vector<TextureTile>& tiles, const PieceProgress& progress);

/// Makes the texture of corner, omega and Wang tiles that are chosen for the whole set together, without marked
/// corners: joint/joint_texture.cpp.
TextureSources make_joint_texture(const PngPixels& exemplar, const TextureRequest& request,
                                  const std::vector<TextureTile>& tiles, const PieceProgress& progress);

}
