// Distances of pairs over those that they are to keep: against all pairs.
#include "analysis/regions/kept_distances.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

TEST(KeptDistances, AreThoseOfAllPairs)
{
    std::mt19937 random(3);
    const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
    for (const bool is_mean : {false, true})
        for (const std::size_t count : {2, 7, 300}) {
            std::vector<TorusPoint<2>> points;
            std::vector<std::uint32_t> distances;
            for (std::size_t i = 0; i < count; ++i) {
                points.push_back({below(0x80000000u), below(0x10000000u)});
                distances.push_back(1 + below(0x4000000u));
            }
            const KeptDistances kept = kept_distances(points, distances, is_mean);
            ASSERT_EQ(kept.nearest.size(), count);
            bool are_kept = true;
            for (std::size_t i = 0; i < count; ++i) {
                double least = HUGE_VAL;
                for (std::size_t j = 0; j < count; ++j) {
                    if (i == j) continue;
                    const double distance =
                        std::hypot(double{1} * points[i][0] - points[j][0], double{1} * points[i][1] - points[j][1]);
                    const double a = distances[i], b = distances[j];
                    least = std::min(least, distance / (is_mean ? (a + b) / 2 : std::min(a, b)));
                }
                are_kept &= least >= 1;
                EXPECT_NEAR(kept.nearest[i], least, 1e-12 * least);
            }
            EXPECT_EQ(kept.are_kept, are_kept);
        }
}

/// One point keeps a million times the distance of the others, which are on a lattice of that: where each pair was
/// looked at, this would take minutes.
TEST(KeptDistances, OfAFewLargeOnesTakeNoTime)
{
    constexpr std::uint32_t side = 400, gap = 1000, large = 1'000'000'000;
    std::vector<TorusPoint<2>> points;
    std::vector<std::uint32_t> distances(side * side, gap);
    for (std::uint32_t i = 0; i < side * side; ++i) points.push_back({i % side * gap, i / side * gap});
    points.push_back({2'000'000'000, 0});
    distances.push_back(large);
    const KeptDistances kept = kept_distances(points, distances, true);
    EXPECT_TRUE(kept.are_kept);
    EXPECT_DOUBLE_EQ(kept.least(), 1);
    EXPECT_DOUBLE_EQ(kept.nearest.back(), (2'000'000'000.0 - (side - 1) * gap) / ((double{large} + gap) / 2));
    points.back()[0] = 400'000'000;
    EXPECT_FALSE(kept_distances(points, distances, true).are_kept);
}

TEST(KeptDistances, AreExactInTheLastPosition)
{
    const std::vector<TorusPoint<2>> points{{0, 0}, {3000000000u / 2, 2000000000u}}; // 2500000000 apart
    for (const std::uint32_t distance : {2147483647u, 2000000000u}) {
        EXPECT_TRUE(kept_distances(points, std::vector{distance, distance}, false).are_kept);
    }
    const std::vector<TorusPoint<2>> near{{5, 7}, {5 + 300000000u, 7 + 400000000u}}; // 500000000
    EXPECT_TRUE(kept_distances(near, std::vector{500000000u, 600000000u}, false).are_kept);
    EXPECT_FALSE(kept_distances(near, std::vector{500000001u, 600000000u}, false).are_kept);
    EXPECT_TRUE(kept_distances(near, std::vector{500000001u, 499999999u}, true).are_kept);
    EXPECT_FALSE(kept_distances(near, std::vector{500000001u, 500000000u}, true).are_kept);
    EXPECT_TRUE(std::isinf(kept_distances({}, {}, false).least()));
}

}
}
