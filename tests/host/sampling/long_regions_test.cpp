// Dart throwing in regions that are very long: in bricks of cells against that in cubes of them, and candidates by
// squares.
//
// Oracles are dense grids and Rényi's parking constant: cars of length 1 that
// park at random on a road leave it, when no further one fits, with 0.7475979 cars a unit of length.
#include "base/regions/region_text.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/regions/region_bricks.hpp"
#include "host/sampling/regions/region_candidates.hpp"
#include "tests/support/named_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

struct BrickCase
{
    std::string region;
    double min_distance;      ///< of the torus
    std::size_t points = 0;   ///< 0: to saturation
    bool is_in_space = false; ///< of space
};

void PrintTo(const BrickCase& c, std::ostream* out) { *out << c.region << ", distance " << c.min_distance; }

DartThrowingRequest brick_request(const BrickCase& c)
{
    DartThrowingRequest request;
    request.dimension = c.is_in_space ? 3 : 2;
    request.min_distance = c.min_distance;
    if (c.points > 0) request.points = c.points;
    request.stream = stream_key(7, Purpose::dart_throwing, 0);
    const CellHierarchy cells = cell_hierarchy(c.min_distance, request.dimension);
    if (c.is_in_space) {
        request.space = std::make_shared<const FixedSpace>(read_space_region(c.region));
        request.bricks = bricks_of(*request.space, cells, SIZE_MAX);
    } else {
        request.region = std::make_shared<const FixedRegion>(test::named_region(c.region));
        request.bricks = bricks_of(*request.region, cells, SIZE_MAX);
    }
    return request;
}

class DartsInBricks : public testing::TestWithParam<BrickCase>
{
};

TEST_P(DartsInBricks, AreThoseOfAllCells)
{
    DartThrowingRequest request = brick_request(GetParam());
    DartThrowingRequest dense = request;
    dense.bricks.reset();
    const PointSet expected = reference::throw_darts(dense);
    ASSERT_GT(expected.size(), 0U);
    EXPECT_EQ(reference::throw_darts(request), expected);
    for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds})
        for (const std::size_t group : {std::size_t{16}, std::size_t{0}})
            EXPECT_EQ(DartThrower(Device::open(), group, settling).throw_darts(request), expected);
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, DartsInBricks,
                         testing::Values(BrickCase{"rectangle 0 0 30 2", 0.06},
                                         BrickCase{"box 0 0 0 9 1 1", 0.08, 4, true}));

INSTANTIATE_TEST_SUITE_P(
    Shapes, DartsInBricks,
    testing::Values(BrickCase{"rectangle 0 0 3 2", 0.01}, BrickCase{"star60", 0.006},
                    BrickCase{"star4000", 0.004, 2000}, BrickCase{"rectangle 0 0 1000 1", 0.0007},
                    BrickCase{"disk 5 5 2", 0.02},
                    BrickCase{"MULTIPOLYGON (((0 0,1 0,0 1,0 0)),((90 90,91 90,91 91,90 90)))", 0.0009},
                    BrickCase{"POLYGON ((0 0, 900 700, 900 703, 0 3, 0 0))", 0.001},
                    BrickCase{"POLYGON ((0 0, 900 700, 900 703, 0 3, 0 0))", 0.001, 500},
                    BrickCase{"box 0 0 0 9 1 1", 0.02, 0, true}, BrickCase{"ball 0 0 0 1", 0.03, 200, true},
                    BrickCase{"solid 0 0 0 1 1 1 sin(9*x)+cos(8*y)+sin(7*z)-0.5", 0.04, 0, true}));

/// A road that is so narrow that its points are cars that park one behind the other: their number over its length.
TEST(DartsInLongRegions, LeaveRenyisShareOfARoad)
{
    constexpr double length = 100'000, parking = 0.7475979202, variance = 0.0381564;
    const DartThrowingRequest request = brick_request({"rectangle 0 0 100000 0.01", 1 / (length * 2)});
    const PointSet points = DartThrower(Device::open()).throw_darts(request);
    EXPECT_EQ(reference::throw_darts(request), points);
    // Middles of cars on a road of that length park on one that is a car longer; Rényi 1958 has the mean there.
    const double expected = parking * (length + 1) - (1 - parking);
    EXPECT_NEAR(static_cast<double>(points.size()), expected, 4 * std::sqrt(variance * length));
    std::vector<double> along;
    for (std::size_t i = 0; i < points.size(); ++i) along.push_back(points[i][0] * 2 * length);
    std::ranges::sort(along);
    for (std::size_t i = 1; i < along.size(); ++i) {
        ASSERT_GE(along[i] - along[i - 1], 1 - 1e-4);
        ASSERT_LT(along[i] - along[i - 1], 2 + 1e-4); // no further one fits
    }
}

/// Counts in equal parts of a slanting strip, of which a tenth lies in no square's half, are those of chance.
TEST(CandidatesOfLongRegions, AreUniform)
{
    const FixedRegion region(read_region("POLYGON ((0 0, 100000 70000, 100000 70010, 0 10, 0 0))"));
    RegionCandidates candidates(region, stream_key(3, Purpose::random_points, 0), CandidateArea::squares);
    constexpr std::size_t count = 100'000, parts = 50;
    const std::vector<TorusPoint<2>> places = candidates.next(count);
    ASSERT_EQ(places.size(), count);
    std::array<double, parts> along{}, across{};
    for (const TorusPoint<2>& place : places) {
        ASSERT_TRUE(region.contains_plainly(place));
        const auto [x, y] = region.own(place);
        ++along[static_cast<std::size_t>(std::min(x / 100'000 * parts, parts - 1.0))];
        ++across[static_cast<std::size_t>(std::clamp((y - 0.7 * x) / 10 * parts, 0.0, parts - 1.0))];
    }
    constexpr double expected = double{count} / parts;
    for (const auto& counts : {along, across}) {
        double chi_squared = 0;
        for (const double found : counts) chi_squared += (found - expected) * (found - expected) / expected;
        EXPECT_LT(chi_squared, 100); // of 49 degrees of freedom: once in 40,000 times
    }
    EXPECT_GT(candidates.share_of_darts(), 0.3);
    EXPECT_NEAR(candidates.share() * 100'000 * 70'010, 1e6, 1e6 * 0.02); // the area
}

}
}
