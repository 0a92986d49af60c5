// Values of textures by the keys of texture_measures(), and their means over several sets.
#pragma once

#include "host/texture/comparison/texture_comparison.hpp"
#include "results/pictures/distribution_result.hpp"
#include "tiles/texture/texture_set.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

using TextureValues = std::map<std::string, double>;

/// Tiles along the sides of the tiling that is measured.
inline constexpr std::uint64_t measured_tiles = 16;

/// Tiles along the sides of that in which repetition is looked for, at most peak_side pixels.
inline constexpr int compared_tiles = 64;

/// Seams, what recurs, and colours of a set, laid by a seed.
TextureValues tile_values(const TextureSet& set, std::uint64_t seed);

/// Recurrence is measured in a tiling with so many tiles along each side, where 0.1 % of the power recurs by chance.
inline constexpr std::uint64_t recurrence_tiles = 32;

/// Tiles after which a tiling could recur: 2 of omega tiles, whose colours alternate.
inline int recurrence_period(const TextureSet& set) { return set.kind == TextureKind::omega ? 2 : 1; }

/// The part of the power of a tiling by a seed that recurs after recurrence_period() tiles, beyond chance. Where the
/// exemplar has regular waves that fit the tiles, it is the power of what pixels have beside the exemplar's means at
/// their phase, as in the construction. No value without any power.
std::optional<double> set_recurrence(const TextureSet& set, std::uint64_t seed);

/// The line that commands print of it: "2.0 % of a tiling's power recurs every 64 pixels: ...".
std::string recurrence_words(const TextureSet& set, double recurrence);

/// Adds the measures that need no tiles: the power of a picture at 1/T and 1/2T, and its colours.
void add_picture_values(const PngPixels& picture, const PngPixels& exemplar, int size, TextureValues& values);

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
