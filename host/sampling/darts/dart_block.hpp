// A part of the torus in which darts are thrown as if there was nothing around it, and the order of its points.
#pragma once

#include <array>
#include <cstdint>

namespace poissonlab {

/// A cube of level 0 cells of the torus, from `first` on, around the torus; as many as the torus has, or less by the
/// reach of a point on either side.
struct DartBlock
{
    std::array<std::uint32_t, 3> first{}; ///< along each axis
    std::uint32_t size = 0;               ///< cells along each axis

    bool operator==(const DartBlock&) const = default;
};

/// A point with what decides its place among all points: batch, time, position. The order of these words is that in
/// which darts fall.
template <int D>
using OrderedDart = std::array<std::uint32_t, D + 2>;

}
