// Squares of positions, in space cubes, that have all of a region, and not much besides: places in it are found by them
// where the box around it is nearly empty.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace poissonlab {

/// A position of a region's grid.
template <typename Region>
using PositionIn = std::remove_cvref_t<decltype(std::declval<const Region&>().extent().low)>;

template <typename Region>
struct RegionSquares
{
    std::vector<PositionIn<Region>> corners; ///< the lowest position of each; none where nothing is inside
    int shift = 0;                           ///< squares are 2^shift positions wide, up to 2^31

    /// Turns a random word into a position in a square along an axis, from its lowest one on.
    std::uint32_t within(std::uint32_t word) const
    {
        return static_cast<std::uint32_t>(std::uint64_t{word} << shift >> 32);
    }
};

/// So many squares at most are worth their time.
inline constexpr std::size_t most_region_squares = std::size_t{1} << 18;

/// The squares that are left where the least square around all positions is halved, and those outside are dropped,
/// until half of what is left is the region's, margins aside, or there would be more than `most`.
RegionSquares<FixedRegion> squares_of(const FixedRegion& region, std::size_t most);
RegionSquares<FixedSpace> squares_of(const FixedSpace& space, std::size_t most);

/// The smallest squares that cover the region with at most `most` of them, and at least 2^shift positions wide.
RegionSquares<FixedRegion> small_squares_of(const FixedRegion& region, std::size_t most, int shift);

}
