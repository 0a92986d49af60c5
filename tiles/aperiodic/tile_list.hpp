// Sets of Wang tiles and of corner tiles as lists: for aperiodic sets, which have few tiles over many colours.
//
// A TileSet numbers its tiles by their colours, which ends at 256 colours; the sets that repeated constructions make
// (D. tables 8.3 to 8.7) have tens of thousands. D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, chapter 8.
//
// Sets of tiles as text files.
//
// A line has a tile: four words, the colours of north, east, south and west of a Wang tile, or, after a first line
// "corner", those of north-east, south-east, south-west and north-west of a corner tile. Colours are any words without
// blanks; what follows a # is a comment. A first line "wang" may stand before Wang tiles.
#pragma once

#include "tiles/tilings/tile_index.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// Different Wang tiles in some order. Horizontal edges (north, south) have the colours 0 to colors.horizontal - 1,
/// vertical ones 0 to colors.vertical - 1; equal numbers on the two kinds of edges have nothing in common.
struct WangList
{
    std::vector<WangTile> tiles;
    WangColors colors{0, 0};

    bool operator==(const WangList&) const = default;
};

/// Different corner tiles in some order, over the colours 0 to `colors` - 1.
struct CornerList
{
    std::vector<CornerTile> tiles;
    Color colors = 0;

    bool operator==(const CornerList&) const = default;
};

/// "Colours" as the dissertation counts them: the larger of the two numbers.
Color color_count(const WangList& list);

/// The tiles with the colours of each kind of edges numbered anew from 0, in the order of the numbers.
WangList renumbered(std::vector<WangTile> tiles);

/// The corner tiles with their colours numbered anew from 0, as above.
CornerList renumbered(std::vector<CornerTile> tiles);

/// The Wang tiles with pairs of corner colours as edge colours (D. 8.4): west and east, or south and north. Tile k of
/// the result is tile k of the list, and two tiles fit exactly where the corner tiles do.
WangList wang_list_of(const CornerList& list);

/// The tiles reflected in the diagonal from the north-west to the south-east: rows become columns.
WangList transposed(const WangList& list);

/// Positions of tiles in a list.
using ListPlace = std::uint32_t;

/// Finds the tiles of a list by their colours. Spans are in the order of the list, and valid as long as the index.
class TilesByColor
{
public:
    /// Keeps no reference to the list.
    explicit TilesByColor(const WangList& list);

    std::span<const ListPlace> with_west(Color west) const;
    std::span<const ListPlace> with_north(Color north) const;
    std::span<const ListPlace> with_north_and_west(Color north, Color west) const;

private:
    std::vector<ListPlace> by_west_, by_north_; ///< the latter by (north, west)
    std::vector<Color> wests_;                  ///< of by_north_
    std::vector<std::size_t> west_begins_, north_begins_;
};

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
