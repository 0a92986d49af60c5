// Relaxation dart throwing as its authors describe it: random darts one by one, each against every point.
//
// No grid, no Philox, doubles instead of fixed point: it shares nothing with the laboratory's code.
#pragma once

#include "base/geometry/point_set.hpp"

#include <cmath>
#include <cstddef>
#include <random>

namespace poissonlab::test {

/// `count` points in 2D. The radius is multiplied by `factor` after `attempts` failures in a row.
inline PointSet textbook_relaxation_dart_throwing(std::size_t count, double initial_radius, double factor, int attempts,
                                                  std::uint64_t seed)
{
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    PointSet points{2, {}};
    double radius = initial_radius;
    int failures = 0;
    while (points.size() < count) {
        const double x = uniform(generator);
        const double y = uniform(generator);
        bool free = true;
        for (std::size_t i = 0; i < points.size() && free; ++i) {
            const double dx = std::abs(x - points[i][0]);
            const double dy = std::abs(y - points[i][1]);
            const double wrapped_x = dx < 0.5 ? dx : 1 - dx;
            const double wrapped_y = dy < 0.5 ? dy : 1 - dy;
            free = wrapped_x * wrapped_x + wrapped_y * wrapped_y >= 4 * radius * radius;
        }
        if (free) {
            points.coordinates.insert(points.coordinates.end(), {x, y});
            failures = 0;
        } else if (++failures == attempts) {
            radius *= factor;
            failures = 0;
        }
    }
    return points;
}

}
