// Recursive Wang tiles, their division: which tiles the sixteen cells of a tile hold, and which of their points are
// the tile's own.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006.
#pragma once

#include "tiles/recursive/recursive_tile_set.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

using TileCells = std::array<std::uint8_t, recursive_cells>;
using TileLinks = std::array<std::vector<RecursiveLink>, even_wang_tiles>;

/// The cells of all tiles. An edge of either colour becomes four, two of each colour; which is chance, and differs for
/// both colours. Inside of tiles all is chance as far as colours are even.
std::array<TileCells, even_wang_tiles> random_divisions(std::uint64_t seed);

/// The point of a cell for every point of every tile, which becomes its place. Rank by rank each tile takes the nearest
/// one that is left and keeps away from those before it, of the tile and of all that may lie beside it: 0.6 times what
/// as many points could be apart; or the one that comes nearest to that. As points move, so do those of the tiles
/// around their tiles: what is then nearer than 0.5 times that chooses again, until nothing does.
///
/// Departure: the paper's points take the nearest one.
TileLinks own_points(RecursivePlaces places, const std::array<TileCells, even_wang_tiles>& cells);

/// The places of all points in the cells of a tile, cell by cell.
std::vector<RecursivePlace> places_in_cells(const RecursivePlaces& places, const TileCells& cells);

}
