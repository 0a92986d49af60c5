// The last step to equal moments: single points by single units, until moments agree in whole numbers.
#pragma once

#include "tiles/poisson/tile_moments.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The farthest that a point is moved along an axis, in stored numbers.
inline constexpr std::int64_t exact_reach = 3;

/// A position in stored numbers, from the middle of its tile.
using StoredFromMiddle = std::array<std::int64_t, 3>;

/// Moves points until the sums of the monomials up to order 1, in the plane also up to order 2, are those that are
/// wanted. `wanted`: by monomials_up_to(). Sums of squares must be wanted odd where those of numbers are. False: there
/// is no way that the search knows; points are then anywhere within reach.
bool make_moments_exact(std::vector<StoredFromMiddle>& points, const std::vector<std::int64_t>& wanted,
                        std::uint32_t order, int dimension);

}
