// The tables [[texture]] and [[packing]] of a config become these checked settings.
#pragma once

#include "host/texture/endless/endless_request.hpp"
#include "host/texture/texture_request.hpp"
#include "tiles/tilings/tile_set.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// A table [[texture]]: tiles from a picture, how well they fit, and a tiling with them.
struct TextureSettings
{
    TextureRequest request;    ///< without seed
    bool is_size_open = false; ///< the command has no size, and takes one that fits the picture
    bool are_colors_open = false;
    std::optional<EndlessRequest> endless;   ///< instead of tiles, whose size T remains the unit of windows
    std::filesystem::path exemplar;          ///< empty: a pattern
    std::filesystem::path marked_exemplar;   ///< of marked corners; empty: none are marked
    std::filesystem::path marks;             ///< a picture whose lighter part is marked; empty: corners are at random
    std::vector<std::filesystem::path> also; ///< pictures over the exemplar that are cut as well
    bool is_straightened = false;            ///< a regular exemplar becomes straight, and fits tiles
    std::optional<bool> is_flattened;        ///< its light becomes even; nothing: if it differs over more than a tile
    std::string pattern;                     ///< one of exemplar_patterns()
    int pattern_size = 256;                  ///< pixels along a side
    int sets = 1;                            ///< with other patches each, over which measures are averaged
    std::uint64_t columns = 8;               ///< tiles of the window that is drawn
    std::uint64_t rows = 4;
    std::vector<std::string> show; ///< some of texture_shows()
    bool has_timing = false;       ///< frames a second are measured
    bool is_compared = false;      ///< colours, contrast, gradients, structure and repetition, with the exemplar's own
};

/// The picture that `texture endless` draws.
struct EndlessSettings
{
    EndlessRequest request; ///< without seed
    std::filesystem::path exemplar;
    std::array<std::int64_t, 4> window{0, 0, 1024, 576}; ///< pixels: left, top, width, height
};

/// A table [[packing]]: see tiles/packing.
struct PackingSettings
{
    TileKind kind = TileKind::corner; ///< or wang
    Color colors = 2;
    std::string method = "closed";
    std::string show = "tiles";
    bool is_printed = false; ///< by the command, which draws only where it is asked to
};

/// The largest number of colours whose tiles are drawn: 65,536 of them.
inline constexpr Color most_drawn_colors = 16;
inline constexpr auto most_drawn_words = "must be at most 16 for a picture";

}
