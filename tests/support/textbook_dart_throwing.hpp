// Dart throwing as in the textbooks: random darts one by one over the whole torus, a cell grid only to find
// neighbours.
//
// No gap list, no batches, no Philox, doubles instead of fixed point: it shares nothing with the laboratory's
// code.
#pragma once

#include "base/geometry/point_set.hpp"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace poissonlab::test {

/// `count` points at least `min_distance` apart, 2D. Does not end when so many do not fit.
inline PointSet textbook_dart_throwing(std::size_t count, double min_distance, std::uint64_t seed)
{
    struct Point
    {
        double x = -1, y = -1; // -1: none
    };
    const int cells = static_cast<int>(std::ceil(std::sqrt(2.0) / min_distance));
    std::vector<Point> grid(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    const auto cell = [&](int i, int j) -> Point& {
        return grid[static_cast<std::size_t>((j + cells) % cells * cells + (i + cells) % cells)];
    };
    const auto wrapped = [](double difference) { return difference - std::round(difference); };

    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    PointSet points{2, {}};
    while (points.size() < count) {
        const Point dart{uniform(generator), uniform(generator)};
        const int i = static_cast<int>(dart.x * cells);
        const int j = static_cast<int>(dart.y * cells);
        bool free = true;
        for (int b = -2; b <= 2 && free; ++b) {
            for (int a = -2; a <= 2 && free; ++a) {
                const Point& other = cell(i + a, j + b);
                free = other.x < 0 || std::hypot(wrapped(other.x - dart.x), wrapped(other.y - dart.y)) >= min_distance;
            }
        }
        if (!free) continue;
        cell(i, j) = dart;
        points.coordinates.insert(points.coordinates.end(), {dart.x, dart.y});
    }
    return points;
}

}
