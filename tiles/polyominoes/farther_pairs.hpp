// Pairs of tiles farther apart than near ones, which tilings with polyominoes can have.
//
// Along the line between two tiles of a tiling one tile follows another, each touching the next. So all pairs are found
// by going from near tile to near tile; what comes of it are all pairs that a tiling can have, and perhaps some more,
// of tiles whose neighbourhoods fit each other although no tiling has both.
#pragma once

#include "tiles/polyominoes/neighbourhoods.hpp"

#include <vector>

namespace poissonlab {

/// The distance of a tile's middle from its farthest corner is 2.23 cells at most.
inline constexpr double tile_radius = 2.25;

/// All pairs of tiles of tilings, near ones among them, whose middles are at most `reach` cells apart; each pair from
/// either side, ascending.
std::vector<NearTiles> pairs_within(const Neighbourhoods& neighbourhoods, double reach);

}
