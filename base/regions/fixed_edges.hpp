// Edges of regions and boxes in whole numbers: on which side of a line, how near, and whether they meet.
//
// kernels/common/regions/inside_region.clh has the same functions.
#pragma once

#include "base/regions/fixed_region.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace poissonlab::fixed_edges {

inline constexpr std::uint32_t most_coordinate = (1u << FixedRegion::coordinate_bits) - 1;

inline FixedEdgeKind kind_of(const FixedEdge& e)
{
    return FixedEdgeKind{e[0] >> FixedRegion::coordinate_bits | e[2] >> FixedRegion::coordinate_bits << 1};
}

inline FixedEdge ends_of(const FixedEdge& e) { return {e[0] & most_coordinate, e[1], e[2] & most_coordinate, e[3]}; }

inline bool is_of_boundary(const FixedEdge& e) { return kind_of(e) == FixedEdgeKind::boundary; }

inline std::int64_t whole(std::uint32_t value) { return static_cast<std::int64_t>(value); }

/// Positive on one side of the edge's line, negative on the other, and 0 on it.
inline std::int64_t line_side(const FixedEdge& e, std::int64_t x, std::int64_t y)
{
    return (whole(e[2]) - whole(e[0])) * (y - whole(e[1])) - (whole(e[3]) - whole(e[1])) * (x - whole(e[0]));
}

/// Does an edge that goes through the height y + e cross it left of x + e^2? `side` is line_side(x, y).
inline bool is_left(const FixedEdge& edge, std::int64_t side) { return side < 0 || (side == 0 && edge[2] <= edge[0]); }

/// Does an edge that goes through x + e^2 cross that below y + e?
inline bool is_below(const FixedEdge& edge, std::int64_t side) { return edge[2] > edge[0] ? side >= 0 : side <= 0; }

inline bool spans_height(const FixedEdge& e, std::uint32_t y) { return e[1] <= y && y < e[3]; }
inline bool spans_width(const FixedEdge& e, std::uint32_t x) { return (e[0] <= x) != (e[2] <= x); }

/// Does a position on the edge's line lie between its ends?
inline bool is_between(const FixedEdge& e, const TorusPoint<2>& p)
{
    return std::min(e[0], e[2]) <= p[0] && p[0] <= std::max(e[0], e[2]) && e[1] <= p[1] && p[1] <= e[3];
}

/// Does the edge have a point in the box, its border included?
inline bool touches(const FixedEdge& e, const FixedBox& box)
{
    if (std::max(e[0], e[2]) < box.low[0] || std::min(e[0], e[2]) > box.high[0] || e[3] < box.low[1] ||
        e[1] > box.high[1])
        return false;
    const bool goes_right = e[2] >= e[0];
    const std::int64_t most = line_side(e, whole(box.low[0]), whole(goes_right ? box.high[1] : box.low[1]));
    const std::int64_t least = line_side(e, whole(box.high[0]), whole(goes_right ? box.low[1] : box.high[1]));
    return least <= 0 && most >= 0;
}

/// The box and what is so near to it along the axes, as far as coordinates go.
inline FixedBox enlarged(const FixedBox& box, std::uint32_t margin)
{
    FixedBox large;
    for (std::size_t k = 0; k < 2; ++k) {
        large.low[k] = box.low[k] - std::min(box.low[k], margin);
        large.high[k] = box.high[k] + std::min(most_coordinate - box.high[k], margin);
    }
    return large;
}

/// Is the squared distance from the edge less than that?
inline bool is_near(const FixedEdge& e, const TorusPoint<2>& p, std::uint64_t squared)
{
    const std::int64_t dx = whole(e[2]) - whole(e[0]), dy = whole(e[3]) - whole(e[1]);
    const std::int64_t x = whole(p[0]) - whole(e[0]), y = whole(p[1]) - whole(e[1]);
    const std::int64_t along = dx * x + dy * y, squared_length = dx * dx + dy * dy;
    if (along <= 0) return static_cast<std::uint64_t>(x * x + y * y) < squared;
    if (along >= squared_length) return static_cast<std::uint64_t>((x - dx) * (x - dx) + (y - dy) * (y - dy)) < squared;
    __extension__ using Wide = unsigned __int128;
    const auto across = static_cast<Wide>(std::abs(dx * y - dy * x));
    return across * across < static_cast<Wide>(squared) * static_cast<Wide>(squared_length);
}

/// Are all positions of a box so near to the edge? What is near is convex.
inline bool is_all_near(const FixedEdge& e, const FixedBox& box, std::uint64_t squared)
{
    return is_near(e, box.low, squared) && is_near(e, {box.high[0], box.low[1]}, squared) &&
           is_near(e, {box.low[0], box.high[1]}, squared) && is_near(e, box.high, squared);
}

}
