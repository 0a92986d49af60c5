// Closest pairs across the border: counts against all pairs, chances against closed forms, and no alarm for sets that
// are periodic.
#include "analysis/borders/border_pairs.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/relative_radius.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

using Random = std::mt19937_64;

double squared_distance_of(std::span<const double> a, std::span<const double> b, bool wraps)
{
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double difference = std::abs(a[k] - b[k]);
        sum += std::pow(wraps ? std::min(difference, 1 - difference) : difference, 2);
    }
    return sum;
}

/// Darts that keep a distance of all others: on the torus, or without wrapping.
PointSet darts(std::size_t count, int dimension, double radius, bool wraps, Random& random)
{
    const double least = min_distance_for(radius, count, dimension);
    std::uniform_real_distribution<double> coordinate;
    PointSet set{dimension, {}};
    while (set.size() < count) {
        std::vector<double> dart(static_cast<std::size_t>(dimension));
        for (double& c : dart) c = coordinate(random);
        bool is_free = true;
        for (std::size_t i = 0; is_free && i < set.size(); ++i)
            is_free = squared_distance_of(set[i], dart, wraps) >= least * least;
        if (is_free) set.coordinates.insert(set.coordinates.end(), dart.begin(), dart.end());
    }
    return set;
}

/// A point in each cell of a grid, up to `jitter` of the cell from its corner.
PointSet grid(int cells, int dimension, double jitter, Random& random)
{
    std::uniform_real_distribution<double> coordinate(0, jitter);
    PointSet set{dimension, {}};
    for (int z = 0; z < (dimension == 3 ? cells : 1); ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x)
                for (int k = 0; k < dimension; ++k)
                    set.coordinates.push_back(((k == 0 ? x : k == 1 ? y : z) + 0.1 + coordinate(random)) / cells);
    for (double& c : set.coordinates) c = c >= 1 ? c - 1 : c;
    return set;
}

PointSet rounded(PointSet set, double unit)
{
    for (double& c : set.coordinates) c = std::fmod(std::round(c / unit) * unit, 1.0);
    return set;
}

/// Copies of a few tiles of random points, chosen at random for a square of tiles.
PointSet tiled(int tiles, int kinds, std::size_t points, Random& random)
{
    std::vector<PointSet> all;
    for (int kind = 0; kind < kinds; ++kind) all.push_back(test::random_points(points, 2, random));
    PointSet set{2, {}};
    for (int y = 0; y < tiles; ++y)
        for (int x = 0; x < tiles; ++x) {
            const PointSet& tile = all[random() % all.size()];
            for (std::size_t i = 0; i < tile.size(); ++i) {
                set.coordinates.push_back((tile[i][0] + x) / tiles);
                set.coordinates.push_back((tile[i][1] + y) / tiles);
            }
        }
    return set;
}

double chance_of(const std::vector<PointSet>& sets, int tiles = 0)
{
    std::uint64_t pairs = 0;
    for (const PointSet& set : sets) pairs += closer_pairs_across(set, min_distance_in_window(set));
    return chance_of_pairs_across(pairs, sets.size(), sets.front().size(), sets.front().dimension, tiles);
}

TEST(BorderPairs, AreThoseOfAllPairsThatAreCloserThanInside)
{
    Random random(3);
    for (const int dimension : {2, 3})
        for (int set = 0; set < 20; ++set) {
            const PointSet points = darts(100, dimension, 0.6, false, random);
            const double inside = min_distance_in_window(points);
            std::vector<std::array<double, 3>> pairs;
            for (std::size_t i = 0; i < points.size(); ++i)
                for (std::size_t j = i + 1; j < points.size(); ++j)
                    if (const double d = std::sqrt(squared_distance_of(points[i], points[j], true)); d < 0.98 * inside)
                        pairs.push_back({d, static_cast<double>(i), static_cast<double>(j)});
            std::ranges::sort(pairs);
            std::vector<bool> is_taken(points.size());
            std::size_t expected = 0;
            for (const auto& [d, i, j] : pairs) {
                if (is_taken[static_cast<std::size_t>(i)] || is_taken[static_cast<std::size_t>(j)]) continue;
                is_taken[static_cast<std::size_t>(i)] = is_taken[static_cast<std::size_t>(j)] = true;
                ++expected;
            }
            EXPECT_EQ(closer_pairs_across(points, inside), expected) << dimension << "D, set " << set;
        }
}

TEST(BorderPairs, OfSetsWithoutPairsAreNone)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(closer_pairs_across(PointSet{2, {}}, infinity), 0U);
    EXPECT_EQ(closer_pairs_across(PointSet{2, {0.5, 0.5}}, infinity), 0U);
    EXPECT_EQ(closer_pairs_across(PointSet{2, {0.5, 0.5, 0.5, 0.5, 0.01, 0.5, 0.99, 0.5}}, 0), 0U) << "they coincide";
    EXPECT_EQ(closer_pairs_across(PointSet{2, {0.01, 0.5, 0.99, 0.5}}, 0.98), 1U);
}

TEST(BorderPairs, ChanceIsThatOfGeometricNumbers)
{
    // 10,000 points of the plane: a fiftieth of the closest pairs at most. One set: P(m) = p^m. Two sets: the sum of
    // two geometric numbers is m or more with the probability p^m (1 + m (1 - p)).
    const double p = 0.02;
    EXPECT_NEAR(chance_of_pairs_across(1, 1, 10'000, 2), p, 1e-12);
    EXPECT_NEAR(chance_of_pairs_across(3, 1, 10'000, 2) / std::pow(p, 3), 1, 1e-9);
    EXPECT_NEAR(chance_of_pairs_across(3, 2, 10'000, 2) / (std::pow(p, 3) * (1 + 3 * (1 - p))), 1, 1e-9);
    EXPECT_EQ(chance_of_pairs_across(0, 5, 10'000, 2), 1);
    EXPECT_EQ(chance_of_pairs_across(7, 1, 3, 2), 1) << "few points are all near the border";
    EXPECT_EQ(chance_of_pairs_across(7, 1, 0, 2), 1);
    EXPECT_NEAR(chance_of_pairs_across(2, 1, 1'000'000, 3), std::pow(0.03, 2), 1e-12);
    EXPECT_NEAR(chance_of_pairs_across(2, 1, 10'000, 2, 8), std::pow(0.25, 2), 1e-12) << "borders of tiles";
}

TEST(BorderPairs, OfPeriodicSetsRaiseNoAlarm)
{
    Random random(11);
    struct Kind
    {
        std::string name;
        std::function<PointSet()> make;
        int tiles = 0;
    };
    std::vector<Kind> kinds;
    for (const int dimension : {2, 3})
        for (const std::size_t n : {2, 3, 5, 10, 100, 1000})
            kinds.push_back({"random", [=, &random] { return test::random_points(n, dimension, random); }});
    for (const int cells : {3, 7, 16, 31}) {
        kinds.push_back({"jittered", [=, &random] { return grid(cells, 2, 1, random); }});
        kinds.push_back({"lattice", [=, &random] { return grid(cells, 2, 0, random); }});
        kinds.push_back({"rounded lattice", [=, &random] { return rounded(grid(cells, 2, 0, random), 0.001); }});
    }
    kinds.push_back({"jittered in space", [&random] { return grid(6, 3, 1, random); }});
    kinds.push_back({"lattice in space", [&random] { return grid(6, 3, 0, random); }});
    kinds.push_back({"tiles", [&random] { return tiled(4, 3, 20, random); }, 4});
    kinds.push_back({"tiles", [&random] { return tiled(2, 2, 60, random); }, 2});
    for (const Kind& kind : kinds)
        for (int series = 0; series < 100; ++series) {
            const std::vector<PointSet> sets{kind.make(), kind.make(), kind.make()};
            EXPECT_GT(chance_of(sets, kind.tiles), least_chance_across) << kind.name << ", " << sets.front().size();
        }
    for (int series = 0; series < 10; ++series) // darts take longer
        for (const int dimension : {2, 3})
            EXPECT_GT(chance_of({darts(200, dimension, 0.65, true, random)}), least_chance_across);
}

TEST(BorderPairs, OfDistancesThatEndAtTheBorderRaiseTheAlarm)
{
    // Of darts at 0.65 some 8 pairs in 200 points are across the border and closer than all inside: single sets may
    // have fewer than the five that the limit asks for, series do not.
    Random random(12);
    const auto series_of = [&](int sets, std::size_t points, int dimension) {
        std::vector<PointSet> series;
        for (int set = 0; set < sets; ++set) series.push_back(darts(points, dimension, 0.65, false, random));
        return series;
    };
    for (int series = 0; series < 5; ++series) {
        EXPECT_LT(chance_of(series_of(3, 200, 2)), least_chance_across);
        EXPECT_LT(chance_of(series_of(3, 400, 3)), least_chance_across);
        EXPECT_LT(chance_of(series_of(10, 40, 2)), least_chance_across) << "several small sets together";
    }
}

}
}
