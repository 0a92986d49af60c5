// Aperiodic tile sets and their tilings by the words that users name them with: "kari", or "ammann-rotation" for the
// corner tiles that a construction makes of a set.
//
// Tiles have the index that their colours give them in the complete set with as many colours along both kinds of edges,
// so that pictures and statistics are those of any tiles.
#pragma once

#include "tiles/tilings/tile_set.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The words for sets of Wang or corner tiles; none for other kinds.
const std::vector<std::string>& aperiodic_set_words(TileKind kind);

/// These sets have tilings that can be computed at any place: by Beatty sequences, or by substitution.
const std::vector<std::string>& aperiodic_tiling_words(TileKind kind);

bool is_aperiodic_word(TileKind kind, const std::string& word);

/// The number of colours of a set with one of the words.
Color aperiodic_colors(const std::string& word);

TileSet aperiodic_tile_set(TileKind kind, const std::string& word);

/// The tiles of a window, rows from north to south. Throws InputError for places that the tiling does not have.
std::vector<TileIndex> aperiodic_window(const std::string& word, std::uint64_t seed, const TileWindow& window);

}
