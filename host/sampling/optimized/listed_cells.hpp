// Points that lie in a small part of the torus, as in long regions, sorted by grid cells, of which only those that have
// points are listed: for kernels/sample_elimination.cl.
//
// Tiles are blocks of cells, two wide or wider along each axis, and coloured like a chessboard. Cells are sorted by
// their tile's colour, then by tiles, and in each tile row by row.
#pragma once

#include "base/geometry/point_set.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

struct ListedCells
{
    std::vector<std::uint32_t> ids;           ///< the points' numbers, in the order of their cells
    std::vector<std::uint32_t> cells;         ///< the cell of each of these
    std::vector<std::uint32_t> runs;          ///< RUNS(dimension) pairs of words for each cell
    std::vector<std::uint32_t> tile_starts;   ///< the first point of each tile, and the end
    std::vector<std::uint32_t> tiles_around;  ///< TILES_AROUND(dimension) words for each tile
    std::vector<std::uint32_t> colour_starts; ///< the first tile of each colour, and the end
};

/// Lists the cells of points below 1/2 along each axis. Cells are at least `reach` wide. Tiles are made wider until
/// there are no more than `most_tiles`, if that is possible.
ListedCells listed_cells(const PointSet& points, double reach, std::size_t most_tiles);

}
