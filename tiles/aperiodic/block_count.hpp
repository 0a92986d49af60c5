// The number of rectangles of tiles that fit: what a set can do locally, whether or not a tiling of the plane has it.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"

#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// The number of rectangles of width x height >= 1 x 1 tiles in which all neighbours fit, counted by transfer from row
/// to row. Throws InputError for more rows than a RowGraph holds and for counts beyond 2^64 - 1, and Interrupted.
std::uint64_t count_blocks(const WangList& list, std::size_t width, std::size_t height);

}
