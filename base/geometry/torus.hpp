// The unit torus in 32-bit fixed point: coordinate c stands for c / 2^32.
//
// Unsigned subtraction wraps around like the torus does, so a difference read as a signed integer is the
// shortest one, and squared distances are exact 64-bit integers (in units of 2^-64): no rounding, no special
// case at borders.
#pragma once

#include "base/geometry/point_set.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace poissonlab {

template <int D>
using TorusPoint = std::array<std::uint32_t, D>;

/// The exact squared toroidal distance in units of 2^-64; at most D * 2^62, which fits.
template <int D>
std::uint64_t squared_distance(const TorusPoint<D>& a, const TorusPoint<D>& b)
{
    std::uint64_t sum = 0;
    for (int k = 0; k < D; ++k) {
        const auto difference = static_cast<std::int64_t>(static_cast<std::int32_t>(a[k] - b[k]));
        sum += static_cast<std::uint64_t>(difference * difference);
    }
    return sum;
}

/// The smallest squared distance (units of 2^-64) that is not below min_distance (unit lengths), exactly.
/// `min_distance` in [0, 1]; a value too large for 64 bits becomes the largest one, which no distance
/// reaches.
std::uint64_t squared_threshold(double min_distance);

/// The points as doubles, exactly.
template <int D>
PointSet to_point_set(std::span<const TorusPoint<D>> points)
{
    PointSet set{D, {}};
    set.coordinates.reserve(points.size() * D);
    for (const TorusPoint<D>& p : points) {
        for (const std::uint32_t c : p) set.coordinates.push_back(c * 0x1p-32);
    }
    return set;
}

}
