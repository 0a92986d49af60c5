// Point sets whose properties are known in advance.
#pragma once

#include "base/geometry/point_set.hpp"

#include <cmath>
#include <cstdint>
#include <random>

namespace poissonlab::test {

/// A double in [0, 1) with 53 random bits.
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// A multiple of 2^-32 in [0, 1).
inline double uniform_32(std::mt19937_64& random) { return static_cast<double>(random() >> 32) * 0x1p-32; }

/// Independent uniform points with 53-bit coordinates.
inline PointSet random_points(std::size_t count, int dimension, std::mt19937_64& random)
{
    PointSet points{dimension, std::vector<double>(count * static_cast<std::size_t>(dimension))};
    for (double& x : points.coordinates) x = uniform(random);
    return points;
}

/// Random points with corners and coordinates next to the borders among them.
inline PointSet random_points_with_borders(std::size_t count, int dimension, std::mt19937_64& random)
{
    PointSet points = random_points(count, dimension, random);
    const double border[] = {0.0, 1.0 - 0x1p-53, 0.5, 0x1p-60, 0.25, 0.5 - 0x1p-54};
    for (double& x : points.coordinates) {
        if (random() % 8 == 0) x = border[random() % 6];
    }
    return points;
}

/// Independent uniform points whose coordinates are multiples of 2^-32.
inline PointSet random_points_32(std::size_t count, int dimension, std::mt19937_64& random)
{
    PointSet points{dimension, std::vector<double>(count * static_cast<std::size_t>(dimension))};
    for (double& x : points.coordinates) x = uniform_32(random);
    return points;
}

/// Points within `width` of `clusters` random centres, around the torus.
inline PointSet clustered_points(std::size_t count, int dimension, std::size_t clusters, double width,
                                 std::mt19937_64& random)
{
    const PointSet centres = random_points(clusters, dimension, random);
    PointSet points{dimension, {}};
    for (std::size_t i = 0; i < count; ++i) {
        for (const double c : centres[random() % clusters]) {
            const double x = c + width * (uniform(random) - 0.5);
            const double wrapped = x - std::floor(x);
            points.coordinates.push_back(wrapped < 1.0 ? wrapped : 0.0);
        }
    }
    return points;
}

/// The n x n (x n) lattice with spacing 1/n.
inline PointSet square_lattice(int n, int dimension)
{
    PointSet points{dimension, {}};
    for (int z = 0; z < (dimension == 3 ? n : 1); ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                points.coordinates.push_back(static_cast<double>(x) / n);
                points.coordinates.push_back(static_cast<double>(y) / n);
                if (dimension == 3) points.coordinates.push_back(static_cast<double>(z) / n);
            }
        }
    }
    return points;
}

/// `columns` x `rows` points, odd rows shifted by half a column: hexagonal where rows / columns is
/// near 2 / sqrt 3.
inline PointSet staggered_lattice(int columns, int rows)
{
    PointSet points{2, {}};
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            points.coordinates.push_back((x + 0.5 * (y % 2)) / columns);
            points.coordinates.push_back(static_cast<double>(y) / rows);
        }
    }
    return points;
}

/// The face-centred cubic lattice of 4 n^3 points: the sites (i, j, k) / 2n with i + j + k even.
inline PointSet face_centred_cubic_lattice(int n)
{
    PointSet points{3, {}};
    for (int i = 0; i < 2 * n; ++i) {
        for (int j = 0; j < 2 * n; ++j) {
            for (int k = (i + j) % 2; k < 2 * n; k += 2) {
                for (const int c : {i, j, k}) points.coordinates.push_back(static_cast<double>(c) / (2 * n));
            }
        }
    }
    return points;
}

}
