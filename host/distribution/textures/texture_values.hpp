// Values of textures by the keys of texture_measures(), and their means over several sets.
#pragma once

#include "host/texture/comparison/texture_comparison.hpp"
#include "results/pictures/distribution_result.hpp"
#include "tiles/texture/texture_set.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

using TextureValues = std::map<std::string, double>;

/// Tiles along the sides of the tiling that is measured.
inline constexpr std::uint64_t measured_tiles = 16;

/// Tiles along the sides of that in which repetition is looked for, at most peak_side pixels.
inline constexpr int compared_tiles = 64;

/// Seams, repetition and colours of a set, laid by a seed.
TextureValues tile_values(const TextureSet& set, std::uint64_t seed);

/// Repetition at 1/T of a picture that is a texture, and its colours: what needs no tiles. `is_of_one`: its exemplar is
/// one picture.
void add_picture_values(const PngPixels& picture, const PngPixels& exemplar, int size, bool is_of_one,
                        TextureValues& values);

/// Seams where sources of a picture's pixels are no neighbours, per T x T pixels.
void add_seam_values(const TextureSet& set, double tiles, TextureValues& values);

/// Adds what compare_texture() says, repetition being looked for along at most so many pixels; exemplars that are too
/// small have nothing of it.
void add_comparison(const PngPixels& exemplar, const TextureSquare& texture, int largest, TextureValues& values);

/// A square of the tiling by a seed, from its south-west on.
TextureSquare square_of_tiles(const TextureSet& set, std::uint64_t seed);

/// Means over sets, with standard errors where there are several.
std::vector<DistributionNumber> texture_numbers(const std::vector<TextureValues>& sets);

}
