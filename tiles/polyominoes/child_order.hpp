// The order in which the children of a polyomino get points.
#pragma once

#include "tiles/polyominoes/neighbourhoods.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// Greedy farthest points: the first child is the one whose copies keep the largest distance in all tilings, each
/// further one is the farthest from copies of all before and of its own. Middles of tiles decide, ties go to the lower
/// number.
std::vector<std::uint32_t> farthest_children(const Neighbourhoods& neighbourhoods);

/// Reorders the children of neighbourhoods.
Neighbourhoods with_children_in_order(const Neighbourhoods& neighbourhoods, const std::vector<std::uint32_t>& order);

}
