// Periodic rectangles and boxes for tests, by the definitions alone.
#pragma once

#include "base/geometry/periodic_box.hpp"
#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace poissonlab::test {

/// The boxes that tests go through: a rectangle of 2 x 1, one that stands, and two in space.
inline std::vector<std::vector<double>> sides_of_boxes() { return {{2, 1}, {0.7, 7.7}, {3, 1, 2}, {10, 10, 45}}; }

/// The distance of two points in lengths of the box.
inline double distance_in(const PeriodicBox& box, const PointSet& points, std::size_t i, std::size_t j)
{
    double squared = 0;
    for (std::size_t k = 0; k < points[i].size(); ++k) {
        const double along = std::abs(points[i][k] - points[j][k]);
        squared += std::pow(box.sides[k] * std::min(along, 1 - along), 2);
    }
    return std::sqrt(squared);
}

/// Two copies of a square torus side by side along x, which a box of 2 x 1 (x 1) holds.
inline PointSet two_copies(const PointSet& points)
{
    PointSet both{points.dimension, {}};
    for (const double shift : {0.0, 0.5})
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t k = 0; k < points[i].size(); ++k)
                both.coordinates.push_back(k == 0 ? points[i][0] / 2 + shift : points[i][k]);
    return both;
}

}
