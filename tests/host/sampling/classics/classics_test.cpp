// Point sets that every reader knows, against their definitions: nets, packings, brute force.
#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "host/sampling/classics/candidate_darts.hpp"
#include "host/sampling/classics/dense_packing.hpp"
#include "host/sampling/classics/low_discrepancy.hpp"
#include "host/sampling/classics/torus_grid.hpp"
#include "tests/support/brute_force.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace poissonlab {
namespace {

using Given = std::vector<std::pair<std::string, ParameterValue>>;

std::unique_ptr<Sampler> create(const SamplerSpec& spec, const SampleRequest& request, const Given& given = {})
{
    Parameters parameters(spec.parameters);
    for (const auto& [key, value] : given) parameters.set(key, value, {"test.toml", 1});
    return spec.create(parameters, request, Engine::reference, {});
}

/// The number of points in each box of a lattice of boxes, of those with any.
std::map<std::size_t, std::size_t> boxes_by_count(const PointSet& set, const std::vector<std::size_t>& boxes)
{
    std::map<std::vector<std::size_t>, std::size_t> counts;
    const auto dimension = static_cast<std::size_t>(set.dimension);
    for (std::size_t i = 0; i < set.size(); ++i) {
        std::vector<std::size_t> box;
        for (std::size_t k = 0; k < dimension; ++k)
            box.push_back(static_cast<std::size_t>(set.coordinates[i * dimension + k] * static_cast<double>(boxes[k])));
        ++counts[box];
    }
    std::map<std::size_t, std::size_t> result;
    for (const auto& [box, count] : counts) ++result[count];
    return result;
}

using testing::ElementsAre;
using testing::Pair;

/// A (0, m, 2)-net: each of all 2^m boxes of every shape has one point; in 3D, t = 1: boxes twice as large have two.
TEST(Sobol, IsANetHoweverItIsScrambled)
{
    for (const char* scrambling : {"nested", "none"}) {
        const Given given{{"scrambling", std::string(scrambling)}};
        constexpr std::size_t m = 10, points = 1 << m;
        const PointSet plane = create(sobol_sampler(), {points, 2, 5}, given)->sample(1);
        for (std::size_t a = 0; a <= m; ++a)
            EXPECT_THAT(boxes_by_count(plane, {std::size_t{1} << a, std::size_t{1} << (m - a)}),
                        ElementsAre(Pair(1, points)));
        const PointSet space = create(sobol_sampler(), {points, 3, 5}, given)->sample(1);
        for (std::size_t a = 0; a < m; ++a)
            for (std::size_t b = 0; a + b < m; ++b)
                EXPECT_THAT(boxes_by_count(
                                space, {std::size_t{1} << a, std::size_t{1} << b, std::size_t{1} << (m - 1 - a - b)}),
                            ElementsAre(Pair(2, points / 2)));
    }
}

/// The numbers that Joe and Kuo's direction numbers give, in the order of indices.
TEST(Sobol, BeginsAsPublished)
{
    const PointSet set = create(sobol_sampler(), {8, 3, 1}, {{"scrambling", std::string("none")}})->sample(0);
    EXPECT_THAT(set.coordinates, ElementsAre(0, 0, 0, 0.5, 0.5, 0.5, 0.25, 0.75, 0.75, 0.75, 0.25, 0.25, 0.125, 0.625,
                                             0.375, 0.625, 0.125, 0.875, 0.375, 0.375, 0.625, 0.875, 0.875, 0.125));
}

TEST(Halton, HasOnePointInEachBoxOfItsBases)
{
    for (const char* scrambling : {"nested", "none"}) {
        const Given given{{"scrambling", std::string(scrambling)}};
        const PointSet plane = create(halton_sampler(), {5184, 2, 5}, given)->sample(1);
        EXPECT_THAT(boxes_by_count(plane, {64, 81}), ElementsAre(Pair(1, 5184)));
        const PointSet space = create(halton_sampler(), {5400, 3, 5}, given)->sample(1);
        EXPECT_THAT(boxes_by_count(space, {8, 27, 25}), ElementsAre(Pair(1, 5400)));
    }
    // Radical inverses in bases 2, 3 and 5, rounded up to 2^-32.
    const PointSet first = create(halton_sampler(), {8, 3, 1}, {{"scrambling", std::string("none")}})->sample(0);
    EXPECT_EQ(first[1][1], std::ldexp(0x55555556U, -32));
    EXPECT_EQ(first[6][0], std::ldexp(0x60000000U, -32));
    EXPECT_EQ(first[7][2], std::ldexp(0x70A3D70BU, -32));
}

TEST(LowDiscrepancy, ScramblingIsOneOfItsRealization)
{
    for (const SamplerSpec& spec : {sobol_sampler(), halton_sampler()}) {
        const auto sampler = create(spec, {256, 2, 5});
        EXPECT_EQ(sampler->sample(3), create(spec, {256, 2, 5})->sample(3));
        EXPECT_NE(sampler->sample(3), sampler->sample(4));
        EXPECT_NE(create(spec, {256, 2, 6})->sample(3), sampler->sample(3));
        EXPECT_FALSE(spec.is_deterministic(Parameters(spec.parameters)));
        // Each coordinate of one point is uniform over realizations: its mean is 1/2 within five errors.
        double sum = 0;
        for (std::uint32_t r = 0; r < 1000; ++r) sum += sampler->sample(r).coordinates[21];
        EXPECT_NEAR(sum / 1000, 0.5, 5 * std::sqrt(1.0 / 12 / 1000));
    }
}

TEST(Hexagonal, IsTheDensestPackingThatFits)
{
    for (const std::size_t points : {12, 100, 1024, 1999, 16384, 100000}) {
        const PointSet set = create(hexagonal_sampler(), {points, 2, 1})->sample(0);
        EXPECT_NEAR(static_cast<double>(set.size()), static_cast<double>(points), 0.1 * static_cast<double>(points));
        EXPECT_EQ(hexagonal_sampler().most_points({}, {points, 2, 1}), set.size());
        const double radius = relative_radius(min_toroidal_distance(set), set.size(), 2);
        EXPECT_GT(radius, points < 50 ? 0.9 : 0.965) << points;
    }
    const PointSet cubes = create(hexagonal_sampler(), {500, 3, 1})->sample(0);
    EXPECT_EQ(cubes.size(), 500U); // 4 * 5^3
    EXPECT_NEAR(relative_radius(test::brute_force_min_distance(cubes), 500, 3), 1, 1e-8);
}

/// The squared distance of the nearest of some points.
std::uint64_t brute_force_squared(const std::vector<TorusPosition>& points, const TorusPosition& place)
{
    std::uint64_t least = UINT64_MAX;
    for (const TorusPosition& point : points) least = std::min(least, squared_torus_distance(point, place));
    return least;
}

TEST(TorusGrid, FindsTheNearestPoint)
{
    std::mt19937 random(1);
    for (const int dimension : {2, 3}) {
        for (const std::size_t points : {0, 1, 2, 7, 30, 300}) {
            TorusGrid grid(points, dimension);
            std::vector<TorusPosition> all;
            const auto word = [&] { return static_cast<std::uint32_t>(random()); };
            const auto anywhere = [&] { return TorusPosition{word(), word(), dimension == 3 ? word() : 0U}; };
            for (std::size_t i = 0; i < points; ++i) grid.add(all.emplace_back(anywhere()));
            const SortedTorus sorted(all, dimension);
            for (int i = 0; i < 200; ++i) {
                const TorusPosition place = anywhere();
                const std::uint64_t expected = brute_force_squared(all, place);
                ASSERT_EQ(grid.squared_nearest(place), expected);
                ASSERT_EQ(sorted.squared_nearest(place), expected);
                if (points == 0) continue;
                const std::uint64_t enough = expected + expected / 8;
                ASSERT_LE(sorted.squared_nearest(place, enough), enough);
                ASSERT_GE(sorted.squared_nearest(place, enough), expected);
                ASSERT_EQ(grid.squared_nearest_below(place, enough), expected);
                ASSERT_EQ(grid.squared_nearest_below(place, expected / 2), expected / 2);
                const auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(expected)));
                ASSERT_FALSE(grid.is_near(place, root - root / 1000));
                ASSERT_TRUE(grid.is_near(place, root + root / 1000 + 2));
            }
        }
    }
}

/// Makes sets without grids and rounds: each point is the first of the farthest candidates. The program's rounds have
/// some points each, or end among the candidates of a point.
TEST(BestCandidate, IsWhatItSays)
{
    using Case = std::tuple<int, std::uint32_t, std::uint32_t, bool>; // dimension, points, candidates, do they grow?
    for (const auto& [dimension, count, candidates, grows] :
         {Case{2, 1500, 3, false}, Case{3, 600, 20, false}, Case{2, 150, 5, true}, Case{2, 18, 40'000, true}}) {
        const PointSet set = create(best_candidate_sampler(), {count, dimension, 3},
                                    {{"candidates", std::int64_t{candidates}}, {"grows", grows}})
                                 ->sample(1);
        const StreamKey stream = stream_key(3, Purpose::best_candidate, 1);
        std::vector<TorusPosition> points;
        for (std::uint32_t i = 0; i < count; ++i) {
            TorusPosition best{};
            std::uint64_t farthest = 0;
            for (std::uint32_t k = 0; k < (grows ? std::max(1u, i) : 1u) * candidates; ++k) {
                const auto words = philox({i, k, 0, 0}, stream);
                const TorusPosition candidate{words[0], words[1], dimension == 3 ? words[2] : 0};
                const std::uint64_t nearest = brute_force_squared(points, candidate);
                if (k > 0 && nearest <= farthest) continue;
                best = candidate;
                farthest = nearest;
            }
            points.push_back(best);
        }
        EXPECT_EQ(set, point_set_of(points, dimension)) << count;
    }
}

/// More candidates are farther apart, and growing numbers of them keep later points as good as the first.
TEST(BestCandidate, GetsBetterWithCandidates)
{
    const auto radius = [](std::int64_t candidates, bool grows) {
        const PointSet set =
            create(best_candidate_sampler(), {500, 2, 3}, {{"candidates", candidates}, {"grows", grows}})->sample(2);
        EXPECT_EQ(set.size(), 500U);
        return relative_radius(test::brute_force_min_distance(set), 500, 2);
    };
    EXPECT_LT(radius(1, false), 0.2);
    EXPECT_GT(radius(20, false), radius(1, false));
    EXPECT_GT(radius(2, true), 0.5);
}

TEST(Bridson, KeepsItsDistanceAndIsNearlyFull)
{
    for (const int dimension : {2, 3}) {
        const double distance = dimension == 2 ? 0.04 : 0.12;
        const auto sampler = create(bridson_sampler(), {1, dimension, 3}, {{"min_distance", distance}});
        for (std::uint32_t realization = 0; realization < 3; ++realization) {
            const PointSet set = sampler->sample(realization);
            EXPECT_GE(test::brute_force_min_distance(set), distance);
            // Random sequential addition ends at the covered fraction of saturation, which this comes near to.
            const double covered = covered_fraction(distance, set.size(), dimension);
            EXPECT_GT(covered, 0.75 * saturation_covered_fraction(dimension));
            EXPECT_LT(covered, 1.05 * saturation_covered_fraction(dimension));
        }
        EXPECT_NE(sampler->sample(0), sampler->sample(1));
        EXPECT_EQ(sampler->sample(1), sampler->sample(1));
    }
}

TEST(Bridson, ComesNearTheNumberThatIsAskedFor)
{
    EXPECT_NEAR(static_cast<double>(create(bridson_sampler(), {4096, 2, 3})->sample(0).size()), 4096, 82);
    EXPECT_NEAR(static_cast<double>(create(bridson_sampler(), {4096, 3, 3})->sample(0).size()), 4096, 160);
}

}
}
