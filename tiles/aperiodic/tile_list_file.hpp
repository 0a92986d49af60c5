// Sets of tiles as text files.
//
// A line has a tile: four words, the colours of north, east, south and west of a Wang tile, or, after a first line
// "corner", those of north-east, south-east, south-west and north-west of a corner tile. Colours are any words without
// blanks; what follows a # is a comment. A first line "wang" may stand before Wang tiles.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

struct ReadTiles
{
    WangList wang;                       ///< of corner tiles, the Wang tiles that are equivalent
    CornerList corners;                  ///< empty for Wang tiles
    std::vector<std::string> warnings{}; ///< a line each: tiles beside which nothing fits

    bool are_corners() const { return !corners.tiles.empty(); }
};

/// Takes the text of a file apart; `name` is what messages call it. Colours are numbered in the order in which they
/// come, those of horizontal and vertical edges each on their own. Throws InputError with the line: a line with other
/// than four colours, a tile twice; and for a file without tiles or with more than 65,536.
ReadTiles parse_tile_list(std::string_view text, const std::string& name);

/// Reads a file and takes its text apart, as above. Throws InputError also where it cannot be read.
ReadTiles read_tile_list(const std::filesystem::path& file);

/// The texts of such files, with numbers for colours.
std::string tile_list_text(const WangList& list);
std::string tile_list_text(const CornerList& list);

}
