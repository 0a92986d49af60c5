// Kernel and reference repulsion give the same bytes, whatever the device is told; points end where closed
// forms say; the minimum distance is what a loop over all pairs finds.
#include "host/sampling/repulsion.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/convex_regions.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

/// Differences of coordinates are rounded by 2^-53 at most, twice, the root by less.
constexpr double rounding = 0x1p-51;

/// Octagons at the corners of 1/2 tiles and the strips between them (they overlap the octagons): the regions
/// of an interior's construction.
Domain tile_domain(double r, int dimension)
{
    const double a = r * (1 + std::sqrt(2.0));
    const std::vector<std::array<double, 2>> octagon{{a, -r}, {a, r},   {r, a},   {-r, a},
                                                     {-a, r}, {-a, -r}, {-r, -a}, {r, -a}};
    Domain domain;
    domain.forbidden.push_back(polygon_region({0, 0, 0}, octagon, 2, 1));
    domain.forbidden.push_back(box_region({0, 0, 0}, {0.5, r, 0.5}, dimension));
    domain.forbidden.push_back(box_region({0, 0, 0}, {r, 0.5, 0.5}, dimension));
    return domain;
}

/// The depth of a point in the regions, at most.
double depth_in(const Domain& domain, std::span<const double> point)
{
    double deepest = 0;
    for (const ConvexRegion& region : domain.forbidden) {
        double depth = 1;
        for (const HalfSpace& half_space : region.half_spaces) {
            double height = -half_space.offset;
            for (std::size_t k = 0; k < point.size(); ++k) {
                const double difference = point[k] - region.centre[k];
                height += half_space.normal[k] * (difference - std::rint(difference));
            }
            depth = std::min(depth, -height);
        }
        deepest = std::max(deepest, depth);
    }
    return deepest;
}

/// The smallest distance of all pairs, and of a point to its images.
double all_pairs_distance(const PointSet& points) { return std::min(1.0, test::brute_force_min_distance(points)); }

struct RepulsionCase
{
    int dimension;
    std::size_t points;
    double min_distance; ///< negative: a relative radius
    std::size_t passes;
    int fixed_percent;
    bool has_regions;
    int seed;
};

void PrintTo(const RepulsionCase& c, std::ostream* out)
{
    *out << c.dimension << "D, " << c.points << " points, distance " << c.min_distance << ", " << c.passes
         << " passes, " << c.fixed_percent << " % fixed, " << (c.has_regions ? "regions" : "no regions");
}

class RepulsionCases : public ::testing::TestWithParam<RepulsionCase>
{
};

TEST_P(RepulsionCases, KernelGivesTheReferencesBytesWithinTheDomain)
{
    const RepulsionCase& c = GetParam();
    std::mt19937_64 random(static_cast<unsigned>(c.seed));
    const PointSet start = test::random_points(c.points, c.dimension, random);
    Domain domain = c.has_regions ? tile_domain(0.07, c.dimension) : Domain{};
    if (c.fixed_percent > 0) {
        for (std::size_t i = 0; i < c.points; ++i)
            domain.is_fixed.push_back(random() % 100 < static_cast<unsigned>(c.fixed_percent));
    }
    const double distance =
        c.min_distance > 0 ? c.min_distance : min_distance_for(-c.min_distance, c.points, c.dimension);
    const RepulsionRequest request{std::min(distance, 1.0), c.passes};

    const RepulsionResult expected = reference::repel(start, domain, request);
    const RepulsionResult made = Repulsion(Device::open()).repel(start, domain, request);
    EXPECT_EQ(made.passes, expected.passes);
    EXPECT_EQ(made.min_distance, expected.min_distance);
    ASSERT_EQ(made.points, expected.points);

    EXPECT_NEAR(made.min_distance, all_pairs_distance(made.points), rounding);
    EXPECT_GE(made.min_distance, std::min(1.0, all_pairs_distance(start)) - rounding);
    EXPECT_TRUE(made.passes == request.passes || made.min_distance >= request.min_distance);
    for (std::size_t i = 0; i < c.points; ++i) {
        const bool is_fixed = !domain.is_fixed.empty() && domain.is_fixed[i];
        for (std::size_t k = 0; k < start[i].size(); ++k) {
            EXPECT_TRUE(made.points[i][k] >= 0 && made.points[i][k] < 1);
            if (is_fixed) {
                EXPECT_EQ(made.points[i][k], start[i][k]);
            }
        }
        // Random points start inside of regions as well; they must not get deeper.
        EXPECT_LE(depth_in(domain, made.points[i]), depth_in(domain, start[i]) + 1e-13);
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, RepulsionCases,
                         ::testing::Values(RepulsionCase{2, 1, 1, 5, 0, false, 1},
                                           RepulsionCase{2, 3, 1, 5, 0, false, 4},
                                           RepulsionCase{2, 20, -0.8, 4, 20, true, 5},
                                           RepulsionCase{3, 15, -0.7, 4, 20, true, 15}));

INSTANTIATE_TEST_SUITE_P(
    Sizes, RepulsionCases,
    ::testing::Values(RepulsionCase{2, 2, -0.9, 50, 0, false, 2}, RepulsionCase{2, 3, -0.8, 50, 0, false, 3},
                      RepulsionCase{2, 60, -0.7, 400, 0, false, 6}, RepulsionCase{2, 500, 1e-9, 3, 0, false, 7},
                      RepulsionCase{2, 500, -0.75, 60, 10, false, 8}, RepulsionCase{2, 200, -0.6, 60, 10, true, 9},
                      RepulsionCase{2, 3000, -0.7, 20, 0, true, 10},
                      // The distance is larger than any set's.
                      RepulsionCase{2, 40, 0.5, 6, 0, false, 11}, RepulsionCase{2, 50, 1, 3, 10, true, 12},
                      RepulsionCase{3, 1, 0.5, 5, 0, false, 13}, RepulsionCase{3, 2, 1, 5, 0, false, 14},
                      RepulsionCase{3, 60, -0.7, 100, 0, false, 16}, RepulsionCase{3, 300, -0.6, 40, 10, true, 17},
                      RepulsionCase{3, 1000, -0.7, 20, 0, false, 18},
                      RepulsionCase{2, 100, -0.5, 400, 100, false, 19}));

/// One pass by its definition: every pair in every image of the torus that may matter.
PointSet pushed_by_all_images(const PointSet& start, double min_distance)
{
    const double t = min_distance * 1.0005;
    const int images = 2;
    const int images_z = start.dimension == 3 ? images : 0;
    PointSet moved = start;
    for (std::size_t i = 0; i < start.size(); ++i) {
        Vector sum{};
        for (std::size_t j = 0; j < start.size(); ++j) {
            if (j == i) continue;
            for (int z = -images_z; z <= images_z; ++z) {
                for (int y = -images; y <= images; ++y) {
                    for (int x = -images; x <= images; ++x) {
                        const std::array<int, 3> image{x, y, z};
                        Vector away{};
                        for (std::size_t k = 0; k < start[i].size(); ++k)
                            away[k] = start[i][k] - start[j][k] - image[k];
                        const double distance = std::hypot(away[0], away[1], away[2]);
                        for (double& component : away) component *= std::max(0.0, t - distance) / 2 / distance;
                        for (std::size_t k = 0; k < 3; ++k) sum[k] += away[k];
                    }
                }
            }
        }
        const double length = std::hypot(sum[0], sum[1], sum[2]);
        const double scale = length > std::min(t, 1.0) ? std::min(t, 1.0) / length : 1;
        for (std::size_t k = 0; k < start[i].size(); ++k) {
            double& x = moved.coordinates[i * start[i].size() + k];
            x += scale * sum[k];
            x -= std::floor(x);
        }
    }
    return moved;
}

TEST(Repulsion, OnePassPushesEveryPairAndImage)
{
    std::mt19937_64 random(7);
    int compared = 0;
    for (int i = 0; i < 600; ++i) {
        const int dimension = 2 + i % 2;
        const PointSet start = test::random_points(2 + random() % 8, dimension, random);
        const double distance = std::array{0.1, 0.3, 0.49, 0.6, 0.9, 1.0}[i / 2 % 6];
        const auto made = reference::repel(start, {}, {distance, 1});
        if (made.points == start) continue; // was good, or did not get better
        ++compared;
        const PointSet expected = pushed_by_all_images(start, distance);
        for (std::size_t c = 0; c < start.coordinates.size(); ++c) {
            const double difference = made.points.coordinates[c] - expected.coordinates[c];
            // Some hundred pushes of up to 1, of which each is rounded a few times; close pairs lose digits.
            EXPECT_NEAR(difference - std::rint(difference), 0, 1e-12);
        }
    }
    EXPECT_GT(compared, 150);
}

TEST(Repulsion, TwoPointsShareWhatTheyLack)
{
    const PointSet start{2, {0.45, 0.5, 0.55, 0.5}};
    const auto result = reference::repel(start, {}, {0.2});
    EXPECT_EQ(result.passes, 1);
    // They end at a distance of 0.2001 around the same middle.
    EXPECT_NEAR(result.points[0][0], 0.5 - 0.10005, rounding);
    EXPECT_NEAR(result.points[1][0], 0.5 + 0.10005, rounding);
    EXPECT_NEAR(result.min_distance, 0.2001, rounding);
    EXPECT_EQ(result.points[0][1], 0.5);
}

TEST(Repulsion, AcrossTheBorderAsWell)
{
    const auto result = reference::repel({2, {0.99, 0.02, 0.03, 0.99}}, {}, {0.1});
    EXPECT_EQ(result.passes, 1);
    EXPECT_NEAR(result.min_distance, 0.1 * 1.0005, rounding);
    const double lack = (0.10005 - 0.05) / 2;
    EXPECT_NEAR(result.points[0][0], 0.99 - 0.8 * lack, rounding);
    EXPECT_NEAR(result.points[0][1], 0.02 + 0.6 * lack, rounding);
}

TEST(Repulsion, AFreePointTakesAllOfWhatAFixedOneLacks)
{
    Domain domain;
    domain.is_fixed = {0, 1};
    const auto result = reference::repel({2, {0.45, 0.5, 0.55, 0.5}}, domain, {0.2});
    EXPECT_EQ(result.passes, 1);
    EXPECT_NEAR(result.points[0][0], 0.55 - 0.2001, rounding);
    EXPECT_EQ(result.points[1][0], 0.55);
}

TEST(Repulsion, BetweenTwoFixedPointsOnlyNearOnesPush)
{
    Domain domain;
    domain.is_fixed = {1, 0, 1};
    const PointSet start{2, {0.4, 0.5, 0.45, 0.5, 0.6, 0.5}};
    const auto enough = reference::repel(start, domain, {0.09});
    EXPECT_EQ(enough.passes, 1);
    EXPECT_NEAR(enough.points[1][0], 0.4 + 0.09 * 1.0005, rounding);

    // Too much to ask for: pushed away from the one, it comes near the other.
    const auto one = reference::repel(start, domain, {0.12, 1});
    EXPECT_NEAR(one.points[1][0], 0.4 + 0.12 * 1.0005, rounding);
    EXPECT_NEAR(one.min_distance, 0.2 - 0.12 * 1.0005, rounding);
}

TEST(Repulsion, OfThreeInARowTheMiddleStays)
{
    const auto result = reference::repel({2, {0.4, 0.5, 0.5, 0.5, 0.6, 0.5}}, {}, {0.15, 1});
    const double lack = 0.15 * 1.0005 - 0.1;
    EXPECT_NEAR(result.points[0][0], 0.4 - lack / 2, rounding);
    EXPECT_NEAR(result.points[1][0], 0.5, rounding);
    EXPECT_NEAR(result.points[2][0], 0.6 + lack / 2, rounding);
}

TEST(Repulsion, TheBestOfAllPassesIsKept)
{
    // A fixed pair cannot get better, and what is good enough is left alone.
    Domain domain;
    domain.is_fixed = {1, 1};
    const PointSet pair{2, {0.45, 0.5, 0.55, 0.5}};
    const auto stuck = Repulsion(Device::open()).repel(pair, domain, {0.2, 7});
    EXPECT_EQ(stuck.points, pair);
    EXPECT_EQ(stuck.passes, 7);
    const auto good = Repulsion(Device::open()).repel(pair, {}, {0.05});
    EXPECT_EQ(good.points, pair);
    EXPECT_EQ(good.passes, 0);
    EXPECT_NEAR(good.min_distance, 0.1, rounding);
}

TEST(Repulsion, CoincidentPointsAreTornApart)
{
    Repulsion repulsion(Device::open());
    for (const int dimension : {2, 3}) {
        const auto d = static_cast<std::size_t>(dimension);
        const auto pair = repulsion.repel({dimension, std::vector<double>(2 * d, 0.5)}, {}, {0.3});
        EXPECT_EQ(pair.passes, 1);
        EXPECT_NEAR(pair.points[0][0], 0.5 - 0.15 * 1.0005, rounding);
        for (const std::size_t n : {3u, 50u}) {
            const PointSet start{dimension, std::vector<double>(n * d, 0.25)};
            const auto made = repulsion.repel(start, {}, {0.01});
            EXPECT_EQ(made, reference::repel(start, {}, {0.01}));
            EXPECT_GE(made.min_distance, n == 3 ? 0.01 : 0.005); // long chains take more passes
            EXPECT_NEAR(made.min_distance, all_pairs_distance(made.points), rounding);
        }
    }
}

TEST(Repulsion, TakesDartThrowingFurther)
{
    for (const int dimension : {2, 3}) {
        DartThrowingRequest darts;
        darts.dimension = dimension;
        darts.points = 1024;
        darts.min_distance = min_distance_for(0.75, 1024, dimension);
        darts.stream = stream_key(1, Purpose::dart_throwing, 0);
        const PointSet start = DartThrower(Device::open()).throw_darts(darts);
        ASSERT_EQ(start.size(), 1024);
        const double distance = min_distance_for(0.80, 1024, dimension);
        const auto made = Repulsion(Device::open()).repel(start, {}, {distance});
        RecordProperty("passes", static_cast<int>(made.passes));
        EXPECT_LT(made.passes, 400);
        EXPECT_GE(made.min_distance, distance);
        EXPECT_NEAR(made.min_distance, test::brute_force_min_distance(made.points), rounding);
    }
}

TEST(RepulsionOnDevices, WorkGroupsAndThreadsChangeNothing)
{
    std::mt19937_64 random(3);
    for (const int dimension : {2, 3}) {
        const PointSet start = test::random_points(700, dimension, random);
        Domain domain = tile_domain(0.05, dimension);
        for (std::size_t i = 0; i < start.size(); ++i) domain.is_fixed.push_back(i % 9 == 0);
        const RepulsionRequest request{min_distance_for(0.7, 700, dimension), 25};
        const RepulsionResult expected = reference::repel(start, domain, request);
        for (const unsigned threads : {1u, 2u}) {
            for (const std::size_t group : {1u, 16u, 64u}) {
                EXPECT_EQ(Repulsion(Device::open({}, threads), group).repel(start, domain, request), expected)
                    << threads << " threads, groups of " << group;
            }
        }
    }
}

TEST(RepulsionOnDevices, ReusedBuffersKeepNothingOfEarlierSets)
{
    Repulsion repulsion(Device::open());
    std::mt19937_64 random(4);
    for (const auto& [dimension, n] : {std::pair(2, 300u), {2, 300u}, {3, 300u}, {2, 40u}, {2, 300u}}) {
        const PointSet start = test::random_points(n, dimension, random);
        const RepulsionRequest request{min_distance_for(0.7, n, dimension), 10};
        EXPECT_EQ(repulsion.repel(start, {}, request), reference::repel(start, {}, request));
    }
}

}
}
