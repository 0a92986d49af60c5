// Nearest distances in the plane against all pairs, of even sets and of those that a grid does not suit.
#include "host/distribution/regions/nearest_in_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

/// Computes the least and the mean nearest distance by all pairs.
NearestDistances distances_by_pairs(const PointSet& points)
{
    NearestDistances distances{HUGE_VAL, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest = HUGE_VAL;
        for (std::size_t j = 0; j < points.size(); ++j)
            if (j != i)
                nearest = std::min(nearest, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
        distances.least = std::min(distances.least, nearest);
        distances.mean += nearest / static_cast<double>(points.size());
    }
    return distances;
}

struct NamedSet
{
    std::string name;
    PointSet points;
};

/// `count` random points in a box.
void add_random(PointSet& points, std::size_t count, std::array<double, 2> low, std::array<double, 2> extent)
{
    std::mt19937 random(static_cast<unsigned>(7 + points.size()));
    std::uniform_real_distribution<double> uniform;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 2; ++k) points.coordinates.push_back(low[k] + extent[k] * uniform(random));
}

NamedSet set_in_boxes(const std::string& name, std::span<const std::array<double, 4>> boxes, std::size_t each)
{
    NamedSet set{name, {2, {}}};
    for (const auto& [x, y, width, height] : boxes) add_random(set.points, each, {x, y}, {width, height});
    return set;
}

std::vector<NamedSet> sets_of_all_sorts()
{
    std::vector<NamedSet> sets{{"two points", {2, {1, 2, 4, 6}}},
                               {"the same point", {2, {3, 3, 3, 3, 3, 3}}},
                               {"a line", {2, {0, 0, 1, 1, 3, 3, 7, 7}}}};
    const std::array<std::array<double, 4>, 1> grid{{{564000, 5640000, 60, 40}}}, thin{{{0, 0, 1000, 0.01}}};
    sets.push_back(set_in_boxes("a box", grid, 2000));
    sets.push_back(set_in_boxes("a strip", thin, 2000));
    NamedSet slanting = set_in_boxes("a slanting strip", std::array<std::array<double, 4>, 1>{{{0, 0, 1e5, 1}}}, 2000);
    for (std::size_t i = 0; i < slanting.points.size(); ++i)
        slanting.points.coordinates[2 * i + 1] += slanting.points.coordinates[2 * i];
    sets.push_back(slanting);
    // Two heaps far from each other are too full for a grid; far islands of one point each leave it almost empty.
    sets.push_back(set_in_boxes("heaps", std::array<std::array<double, 4>, 2>{{{0, 0, 1, 1}, {1e6, 1e6, 1, 1}}}, 1000));
    std::vector<std::array<double, 4>> islands(3, {0, 0, 1, 1});
    islands.push_back({900, 800, 0, 0});
    islands.push_back({-700, 800, 0, 0});
    sets.push_back(set_in_boxes("islands", islands, 1));
    return sets;
}

TEST(NearestInPlane, IsWhatAllPairsSay)
{
    for (const NamedSet& set : sets_of_all_sorts()) {
        const NearestDistances told = nearest_distances(set.points), found = distances_by_pairs(set.points);
        EXPECT_DOUBLE_EQ(told.least, found.least) << set.name;
        EXPECT_NEAR(told.mean, found.mean, 1e-12 * found.mean * static_cast<double>(set.points.size())) << set.name;
    }
}

}
}
