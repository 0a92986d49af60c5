// Seams of smooth pictures become slopes: each side takes on a part of the difference, and keeps its own gradients.
//
// Perez, Gangnet, Blake, Poisson image editing, SIGGRAPH 2003, with a term that keeps what is far from a seam as it is
// (a screened Poisson equation; Bhat and others, Fourier analysis of the 2D screened Poisson equation for gradient
// domain problems, 2008). Where two neighbours p and q show windows A and B, the step from p to q should be the mean of
// the steps in both windows. The method minimises a sum over all tiles: the squared errors of these steps, and each
// pixel's squared change over the square of a length. A pixel that tiles share is one unknown, so that tiles still fit.
// The method blurs nothing: windows keep their gradients except for a slope that fades over that length.
#pragma once

#include "host/texture/texture_request.hpp"
#include "tiles/texture/texture_set.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The length in pixels over which what a picture shows changes: that of a correlation exp(-d^2 / 2 s^2) which has the
/// same mean square of steps beside the variance, s^2 = variance / mean square. 0 for pictures of one colour.
double smooth_length(const PngPixels& exemplar);

/// True if that is four pixels and more: steps are a quarter of what the picture shows, or less, and no edge is seen.
bool is_smooth(const PngPixels& exemplar);

/// Returns the length over which seams fade, in pixels: twice smooth_length(), so that windows which have nothing to do
/// with each other differ by less than half of the picture's own slopes, but from 2 pixels to half of a tile.
double fading_length(const PngPixels& exemplar, int size);

/// True for sets whose shared pixels are known and few enough: corner and omega tiles, and Wang tiles that are chosen
/// together, without marked corners, of at most most_blended_pixels.
bool can_blend(const TextureRequest& request);
inline constexpr std::size_t most_blended_pixels = std::size_t{1} << 22;

/// Says so in words that follow the name of the option.
std::string blended_sets();

/// The change of each value of a set, tile after tile, before it is rounded.
std::vector<double> seam_changes(const TextureSet& set);

/// Blends the seams of a set that shows its sources.
void blend_seams(TextureSet& set);

/// Levels the light of tiles (joint/tile_levels.hpp), whose seams may be blended.
void level_tiles(TextureSet& set);

/// Proves that each pixel of a blended or levelled set is its source's, blended and levelled: that is done again.
/// Throws InputError for the first that is not.
void certify_changes(const TextureSet& set);

}
