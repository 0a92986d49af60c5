// A grid of level 0 cells that has only those near a region, in bricks: where a region is much longer than wide, or in
// parts far from each other, a cube of cells around it would be nearly empty.
//
// kernels/common/darts/dart_bricks.clh says how cells are numbered.
#pragma once

#include "kernels/common/darts/dart_throwing.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

struct DartBricks
{
    int dimension = 2;
    std::vector<std::uint32_t> corners; ///< `dimension` words a brick: the coordinates of its lowest cell
    std::vector<std::uint32_t> around;  ///< the numbers of the bricks around each, itself among them, or NO_BRICK

    std::size_t count() const { return corners.size() / static_cast<std::size_t>(dimension); }
    std::size_t cells() const { return count() * contract::dart_throwing::BRICK_CELLS; }
};

/// The cells of a brick along each axis.
constexpr std::uint32_t brick_side(int dimension)
{
    return 1u << contract::dart_throwing::BRICK_BITS(static_cast<std::size_t>(dimension));
}

}
