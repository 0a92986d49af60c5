// Marks of sets are equal for a set and for the same one shifted, and for no other.
#include "analysis/measures/set_mark.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

SetMark mark_of(const PointSet& set)
{
    SetMarkSums sums;
    sums.add(set);
    return sums.mark(min_toroidal_distance(set), mean_nearest_distance(set));
}

PointSet shifted_by(PointSet set, const std::array<double, 3>& by)
{
    for (std::size_t i = 0; i < set.coordinates.size(); ++i) {
        double& c = set.coordinates[i];
        c += by[i % static_cast<std::size_t>(set.dimension)];
        c -= std::floor(c);
        if (c >= 1) c = 0;
    }
    return set;
}

class MarkedSets : public ::testing::TestWithParam<int>
{
};

TEST_P(MarkedSets, AreTheSameWhereverTheyLieAndInAnyOrder)
{
    std::mt19937_64 random(5);
    for (const std::size_t n : {1, 2, 3, 100, 20'000}) {
        const PointSet set = test::random_points(n, GetParam(), random);
        EXPECT_TRUE(are_same_set(mark_of(set), mark_of(set)));
        const PointSet other = shifted_by(set, {0.123456789, 0.987654321, 0.5000001});
        EXPECT_TRUE(are_same_set(mark_of(set), mark_of(other))) << n;
        PointSet turned{set.dimension, {}};
        const auto d = static_cast<std::ptrdiff_t>(set.dimension);
        for (std::ptrdiff_t i = static_cast<std::ptrdiff_t>(n) - 1; i >= 0; --i)
            turned.coordinates.insert(turned.coordinates.end(), set.coordinates.begin() + i * d,
                                      set.coordinates.begin() + (i + 1) * d);
        EXPECT_TRUE(are_same_set(mark_of(set), mark_of(turned))) << n;
    }
}

TEST_P(MarkedSets, DifferWhereOnePointDoes)
{
    std::mt19937_64 random(6);
    for (const std::size_t n : {2, 3, 100, 20'000}) {
        const PointSet set = test::random_points(n, GetParam(), random);
        PointSet other = set;
        other.coordinates.back() = 0.5 * other.coordinates.back();
        EXPECT_FALSE(are_same_set(mark_of(set), mark_of(other))) << n;
        EXPECT_FALSE(are_same_set(mark_of(set), mark_of(test::random_points(n, GetParam(), random)))) << n;
        EXPECT_FALSE(are_same_set(mark_of(set), mark_of(test::random_points(n + 1, GetParam(), random)))) << n;
    }
}

INSTANTIATE_TEST_SUITE_P(In, MarkedSets, ::testing::Values(2, 3), ::testing::PrintToStringParamName());

/// Mirror images have the same distances, and other spectra.
TEST(SetMarks, TellMirrorImagesApart)
{
    std::mt19937_64 random(7);
    const PointSet set = test::random_points(50, 2, random);
    PointSet mirrored = set;
    for (std::size_t i = 0; i < mirrored.coordinates.size(); i += 2)
        mirrored.coordinates[i] = mirrored.coordinates[i] > 0 ? 1 - mirrored.coordinates[i] : 0;
    EXPECT_FALSE(are_same_set(mark_of(set), mark_of(mirrored)));
}

/// All 2 x 2 arrangements of two tiles, which have equal distances where tiles keep away from their borders: seven
/// necklaces on a torus of 2 x 2, by counting them.
TEST(SetMarks, TellTilingsOfFewTilesApart)
{
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> inside(0.3, 0.7);
    std::array<std::vector<double>, 2> tiles;
    for (auto& tile : tiles)
        for (int i = 0; i < 20; ++i) tile.push_back(inside(random));
    std::vector<SetMark> marks;
    for (unsigned bits = 0; bits < 16; ++bits) {
        PointSet set{2, {}};
        for (unsigned place = 0; place < 4; ++place) {
            const auto& tile = tiles[bits >> place & 1U];
            for (std::size_t i = 0; i < tile.size(); i += 2)
                set.coordinates.insert(set.coordinates.end(),
                                       {(place % 2 + tile[i]) / 2, (place / 2 + tile[i + 1]) / 2});
        }
        const SetMark mark = mark_of(set);
        if (std::ranges::none_of(marks, [&](const SetMark& other) { return are_same_set(mark, other); }))
            marks.push_back(mark);
    }
    EXPECT_EQ(marks.size(), 7U);
}

}
}
