// Voronoi cells as convex polygons that neighbours cut, for the plain twins of kernels that use
// kernels/common/polygon.clh: the same operations in the same order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// A corner of a polygon, relative to its site.
struct CutVertex
{
    double x, y;
    std::uint32_t neighbour; ///< whose bisector the edge after the corner is part of
};
using CutPolygon = std::vector<CutVertex>; ///< convex, counterclockwise

inline constexpr std::uint32_t no_neighbour = UINT32_MAX;
inline constexpr std::size_t max_cut_vertices = 32; ///< cells that come to have more are given up

/// A square with sides of twice a length.
inline CutPolygon square_around(double length)
{
    return {{length, length, no_neighbour},
            {-length, length, no_neighbour},
            {-length, -length, no_neighbour},
            {length, -length, no_neighbour}};
}

/// The places p with p . (x, y) <= offset.
inline CutPolygon without_half_plane(const CutPolygon& polygon, double x, double y, double offset,
                                     std::uint32_t neighbour)
{
    const auto height = [&](const CutVertex& vertex) { return vertex.x * x + vertex.y * y - offset; };
    CutPolygon rest;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const CutVertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double above_a = height(a), above_b = height(b);
        const bool is_kept = !(above_a > 0);
        if (is_kept) rest.push_back(a);
        if (is_kept == !(above_b > 0)) continue;
        const double part = above_a / (above_a - above_b);
        rest.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), is_kept ? neighbour : a.neighbour});
    }
    return rest;
}

/// The cut keeps the part of the polygon that is not nearer to a neighbour at (x, y) than to the site.
inline CutPolygon without_side(const CutPolygon& polygon, double x, double y, std::uint32_t neighbour)
{
    return without_half_plane(polygon, x, y, (x * x + y * y) / 2, neighbour);
}

inline double squared_radius_of(const CutPolygon& polygon)
{
    double largest = 0;
    for (const CutVertex& vertex : polygon) largest = std::max(largest, vertex.x * vertex.x + vertex.y * vertex.y);
    return largest;
}

}
