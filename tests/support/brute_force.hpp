// Oracles that are slow and obvious: every pair, every term, in long double.
#pragma once

#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace poissonlab::test {

/// The smallest toroidal distance over all pairs. For coordinates that are multiples of 2^-32 differences,
/// squares and sums are exact (64 bits of mantissa), so that the result is rounded twice only: in the root
/// and to double.
inline double brute_force_min_distance(const PointSet& points)
{
    long double least = std::numeric_limits<long double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            long double squared = 0;
            for (std::size_t k = 0; k < points[i].size(); ++k) {
                const long double direct = std::abs(static_cast<long double>(points[i][k]) - points[j][k]);
                const long double shortest = std::min(direct, 1 - direct);
                squared += shortest * shortest;
            }
            least = std::min(least, squared);
        }
    }
    return static_cast<double>(std::sqrt(least));
}

/// sum_j exp(-2 pi i f.x_j), term by term. f.x_j is reduced modulo 1 axis by axis: for |f| < 2^11 products of
/// an integer and a double are exact, so the error is some 2^-63 a term.
inline std::complex<long double> brute_force_transform(const PointSet& points, const std::array<int, 3>& frequency)
{
    std::complex<long double> sum = 0;
    for (std::size_t j = 0; j < points.size(); ++j) {
        long double turn = 0;
        for (std::size_t k = 0; k < points[j].size(); ++k) {
            const long double product = static_cast<long double>(frequency[k]) * points[j][k];
            turn += product - std::floor(product);
        }
        const long double angle = -2 * std::numbers::pi_v<long double> * turn;
        sum += std::complex<long double>(std::cos(angle), std::sin(angle));
    }
    return sum;
}

/// The power |transform|^2 / N at one frequency.
inline double brute_force_power(const PointSet& points, const std::array<int, 3>& frequency)
{
    return static_cast<double>(std::norm(brute_force_transform(points, frequency)) /
                               static_cast<long double>(points.size()));
}

}
