// An order of the points of monotiles that makes any density even: the points of all parts of a tile are ranked
// together.
//
// Polyominoes with an order for importance sampling: Ostromoukhov, Sampling with polyominoes, 2007. Here all tilings
// are ranked at once, by the pairs of tiles that they have.
#pragma once

#include "tiles/monotiles/monotile_table.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// Returns the rank of each point of each part: [first part of the state + number of the part][point], where parts are
/// numbered state after state. The ranks of a state are those from 0 to its number of points - 1, each once. A point is
/// next if it is the farthest one from those that are there in all tilings, by the sum of the inverse fourth powers of
/// distances. Ranks depend on the tiles around a tile and not on its ancestors. `levels` is that of monotile_states().
std::vector<std::uint16_t> monotile_ranks(const MonotileTable& table, std::uint32_t levels);

}
