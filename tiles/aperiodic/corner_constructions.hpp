// Corner tile sets made from Wang tile sets, and Wang tile sets made from those again.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 8.3 and 8.4. Corner tiles are counted once each,
// and so are those that no tiling of the plane contains: the dissertation's tables do the same.
#pragma once

#include "base/word_table.hpp"
#include "tiles/aperiodic/tile_list.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

enum class CornerConstruction
{
    diagonal,   ///< a corner in the middle of each Wang tile: its colour is the tile (D. 8.3.1)
    horizontal, ///< corners on the middles of horizontal edges, in their colours (D. 8.3.2)
    vertical,   ///< corners on the middles of vertical edges, in their colours (D. 8.3.2)
    rotation,   ///< corners on the middles of all edges, in a lattice turned by 45 degrees (D. 8.3.3)
    subdivision ///< four corner tiles in each Wang tile (D. 8.3.4)
};
inline constexpr WordTable<CornerConstruction, 5> corner_constructions{
    {{{CornerConstruction::diagonal, "diagonal"},
      {CornerConstruction::horizontal, "horizontal"},
      {CornerConstruction::vertical, "vertical"},
      {CornerConstruction::rotation, "rotation"},
      {CornerConstruction::subdivision, "subdivision"}}}};

struct ConstructedCorners
{
    CornerList list;
    std::size_t patterns = 0; ///< of Wang tiles that corner tiles were made from, each counted
    std::size_t white = 0;    ///< of a rotation: tiles made from one Wang tile, the first ones of the list
    std::size_t black = 0;    ///< and tiles made from squares of four

    /// True where the dissertation says "failed": different patterns of Wang tiles gave the same corner tile, so that
    /// corner tiles do not tell the Wang tiles. The reading is inferred from the tables, which give no reason.
    bool is_ambiguous() const { return patterns > list.tiles.size(); }
};

/// The corner tiles that a construction makes of a set of Wang tiles: in the order of the colours of north-west,
/// south-west, north-east and south-east corners, without repetitions; those of a rotation, white ones first; those of
/// a subdivision, four for each Wang tile: upper right, lower right, upper left, lower left. Colours that no tile has
/// are left out, except those of a diagonal construction, which are the Wang tiles. Throws Interrupted.
ConstructedCorners construct_corners(const WangList& wang, CornerConstruction construction);

/// A step of a repeated construction: corner tiles, and the Wang tiles that are equivalent to them.
struct ConstructionStep
{
    ConstructedCorners corners;
    WangList wang;
};

/// The largest set that a construction is repeated on: the next one could not be kept in memory.
inline constexpr std::size_t max_repeated_tiles = 1'000'000;

/// Repeats a construction, each step on the Wang tiles of the one before; ends early with an ambiguous step. Throws
/// InputError where a set has more than max_repeated_tiles before the last step, and Interrupted.
std::vector<ConstructionStep> repeat_construction(const WangList& wang, CornerConstruction construction,
                                                  std::size_t repetitions);

}
