// The proof that the tiles of a texture set fit together, from the set alone.
//
// Two pixels side by side are contiguous if their sources lie side by side in the same way. Across the border of two
// tiles they are that, or a joint that the shared colours predict: the same two sources wherever these colours meet.
// Wang tiles have exceptions beside their corners, whose pixels belong to the horizontal edges: the corner problem
// (Cohen and others 2003, section 3.4).
#pragma once

#include "tiles/texture/texture_set.hpp"

#include <cstdint>

namespace poissonlab {

struct TextureCertificate
{
    std::uint64_t tile_pairs = 0;  ///< that may lie side by side, west and east, and south and north
    std::uint64_t pixel_pairs = 0; ///< across their borders
    std::uint64_t joints = 0;      ///< of these, those that are not contiguous but predicted
    std::uint64_t exceptions = 0;  ///< and those beside corners of Wang tiles that nothing predicts
};

/// Compares all pairs of tiles that fit, pixel by pixel; all rings of the same colours; and all pixels with their
/// sources, of smoothed sets those in rings, of blended sets none; corners of tiles with the exemplar of their mark.
/// Throws InputError for the first that is not as it must be.
TextureCertificate certify_texture(const TextureSet& set);

}
