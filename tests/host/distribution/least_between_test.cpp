// Least distances of one set from another, against all pairs.
#include "host/distribution/classes/class_points.hpp"

#include "analysis/measures/distance_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

PointSet random_set(std::mt19937_64& random, int dimension, std::size_t points, double extent)
{
    PointSet set{dimension, {}};
    for (std::size_t i = 0; i < points * static_cast<std::size_t>(dimension); ++i)
        set.coordinates.push_back(std::floor(extent * 0x1p32 * static_cast<double>(random() >> 11) * 0x1p-53) *
                                  0x1p-32);
    return set;
}

double by_all_pairs(const PointSet& a, const PointSet& b)
{
    double least = INFINITY;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            double squared = 0;
            for (std::size_t k = 0; k < a[i].size(); ++k) {
                const double d = a[i][k] - b[j][k], shortest = d - std::round(d);
                squared += shortest * shortest;
            }
            least = std::min(least, squared);
        }
    return std::sqrt(least);
}

TEST(LeastDistanceBetween, IsThatOfAllPairs)
{
    std::mt19937_64 random(9);
    for (const int dimension : {2, 3})
        for (const std::size_t few : {1, 2, 7, 40})
            for (const std::size_t many : {1, 3, 100, 700})
                for (const double extent : {1.0, 0.05}) { // clustered sets leave most cells empty
                    const PointSet a = random_set(random, dimension, few, extent);
                    const PointSet b = random_set(random, dimension, many, 1);
                    EXPECT_NEAR(least_distance_between(a, b), by_all_pairs(a, b), 1e-12);
                    EXPECT_EQ(least_distance_between(a, b), least_distance_between(b, a));
                }
    EXPECT_EQ(least_distance_between({2, {}}, {2, {0.5, 0.5}}), INFINITY);
    EXPECT_EQ(least_distance_between({2, {0.5, 0.5}}, {2, {0.5, 0.5}}), 0);
}

}
}
