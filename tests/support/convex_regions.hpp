// Boxes, polygons and prisms as regions that points must not enter.
#pragma once

#include "host/sampling/cells/domain.hpp"

#include <array>
#include <cmath>
#include <span>

namespace poissonlab {

/// An axis-aligned box (2D: rectangle) with these half widths; a half width of 0.5 or more stands for no bound.
inline ConvexRegion box_region(const Vector& centre, const Vector& half_widths, int dimension)
{
    ConvexRegion region{centre, {}};
    for (int k = 0; k < dimension; ++k) {
        if (half_widths[k] >= 0.5) continue;
        for (const double sign : {1.0, -1.0}) {
            HalfSpace half_space{{}, half_widths[k]};
            half_space.normal[k] = sign;
            region.half_spaces.push_back(half_space);
        }
    }
    return region;
}

/// A convex polygon with counterclockwise vertices relative to the centre, and in 3D the prism over it: along `axis`
/// (0, 1 or 2), as far as half_height in both directions; vertices then hold the coordinates of the next two axes in
/// cyclic order. In 2D, `axis` is 2.
inline ConvexRegion polygon_region(const Vector& centre, std::span<const std::array<double, 2>> vertices, int axis = 2,
                                   double half_height = 1)
{
    ConvexRegion region{centre, {}};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto& a = vertices[i];
        const auto& b = vertices[(i + 1) % vertices.size()];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const double u = (b[1] - a[1]) / length;
        const double v = (a[0] - b[0]) / length;
        HalfSpace half_space{{}, u * a[0] + v * a[1]};
        half_space.normal[(axis + 1) % 3] = u;
        half_space.normal[(axis + 2) % 3] = v;
        region.half_spaces.push_back(half_space);
    }
    if (half_height >= 0.5) return region;
    for (const double sign : {1.0, -1.0}) {
        HalfSpace half_space{{}, half_height};
        half_space.normal[axis] = sign;
        region.half_spaces.push_back(half_space);
    }
    return region;
}

}
