// Dart throwing and relaxation dart throwing in regions of space: kernels against references, distances, what is
// inside, and saturation by places that are looked at one by one.
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

constexpr const char* wave_solid = "solid 0 0 0 1 1 1 sin(9*x)+cos(8*y)+sin(7*z)-0.5";

/// Little surface, so that margins take no time.
constexpr const char* small_solid = "solid -4 -4 -4 4 4 4 1-x*x-y*y-z*z";

struct SpaceDartCase
{
    std::string region;
    double min_distance;    ///< of the torus
    std::size_t points;     ///< 0: to saturation
    bool has_balls = false; ///< inside whole
    bool has_block = false; ///< darts fall into half of the cells along each axis alone
};

void PrintTo(const SpaceDartCase& c, std::ostream* out)
{
    *out << c.region << ", distance " << c.min_distance << ", " << c.points << " points"
         << (c.has_balls ? ", balls" : "");
}

DartThrowingRequest space_request_of(const SpaceDartCase& c)
{
    DartThrowingRequest request;
    request.dimension = 3;
    request.min_distance = c.min_distance;
    if (c.points > 0) request.points = c.points;
    request.stream = stream_key(7, Purpose::dart_throwing, 0);
    request.space =
        std::make_shared<const FixedSpace>(read_space_region(c.region), c.has_balls ? c.min_distance / 2 : 0);
    if (c.has_block) request.block = DartBlock{{}, cell_hierarchy(c.min_distance, 3).size / 2 + 2};
    return request;
}

std::vector<TorusPoint<3>> space_positions_of(const PointSet& points)
{
    std::vector<TorusPoint<3>> positions;
    for (std::size_t i = 0; i < points.size(); ++i)
        positions.push_back({static_cast<std::uint32_t>(points[i][0] * 0x1p32),
                             static_cast<std::uint32_t>(points[i][1] * 0x1p32),
                             static_cast<std::uint32_t>(points[i][2] * 0x1p32)});
    return positions;
}

class SpaceDartSets : public testing::TestWithParam<SpaceDartCase>
{
};

TEST_P(SpaceDartSets, AreThoseOfTheReferenceInTheRegionAndFarEnoughApart)
{
    const DartThrowingRequest request = space_request_of(GetParam());
    const PointSet expected = reference::throw_darts(request);
    ASSERT_GT(expected.size(), 0U);
    if (request.points) {
        EXPECT_EQ(expected.size(), *request.points);
    }
    for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds})
        EXPECT_EQ(DartThrower(Device::open(), 0, settling).throw_darts(request), expected);
    const std::vector<TorusPoint<3>> places = space_positions_of(expected);
    const std::uint64_t squared = squared_threshold(request.min_distance);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_TRUE(request.space->contains(places[i])) << i;
        for (std::size_t j = 0; j < i; ++j) ASSERT_GE(squared_distance<3>(places[i], places[j]), squared);
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, SpaceDartSets,
                         testing::Values(SpaceDartCase{"ball 0 0 0 1", 0.4, 0}, SpaceDartCase{wave_solid, 0.4, 2}));

INSTANTIATE_TEST_SUITE_P(
    Shapes, SpaceDartSets,
    testing::Values(SpaceDartCase{"box 0 0 0 3 2 1", 0.05, 0}, SpaceDartCase{"box 0 0 0 3 2 1", 0.05, 0, false, true},
                    SpaceDartCase{"box 0 0 0 3 2 1", 0.05, 0, true}, SpaceDartCase{"box 0 0 0 900 1 1", 0.02, 0},
                    SpaceDartCase{"ball 0 0 0 1", 0.04, 0}, SpaceDartCase{"ball 0 0 0 1", 0.04, 0, true, true},
                    SpaceDartCase{"ball 0 0 0 1", 0.03, 300}, SpaceDartCase{wave_solid, 0.04, 0},
                    SpaceDartCase{small_solid, 0.02, 0, true, true}, SpaceDartCase{wave_solid, 0.2, 0},
                    SpaceDartCase{wave_solid, 0.02, 400, false, true}));

/// Each of many places inside has a point nearer than the distance; without the last point, the place where it lies has
/// none.
TEST(SpaceDartSaturation, LeavesNothingUncoveredInside)
{
    for (const SpaceDartCase& c : {SpaceDartCase{"box 0 0 0 3 2 1", 0.05, 0},
                                   {"ball 0 0 0 1", 0.06, 0},
                                   {"ball 0 0 0 1", 0.05, 0, true},
                                   {wave_solid, 0.06, 0}}) {
        const DartThrowingRequest request = space_request_of(c);
        const std::vector<TorusPoint<3>> points = space_positions_of(reference::throw_darts(request));
        const std::uint64_t squared = squared_threshold(request.min_distance);
        const auto is_covered = [&](const TorusPoint<3>& place, std::size_t count) {
            return std::any_of(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count),
                               [&](const auto& point) { return squared_distance<3>(point, place) < squared; });
        };
        std::mt19937 random(2);
        int looked_at = 0;
        for (int i = 0; i < 40'000; ++i) {
            TorusPoint<3> place;
            for (std::uint32_t& coordinate : place) coordinate = static_cast<std::uint32_t>(random()) >> 1;
            if (!request.space->contains(place)) continue;
            ++looked_at;
            ASSERT_TRUE(is_covered(place, points.size())) << c.region;
        }
        EXPECT_GT(looked_at, 2000) << c.region;
        EXPECT_FALSE(is_covered(points.back(), points.size() - 1));
    }
}

TEST(SpaceDartRuns, DoNotDependOnWorkGroupsAndThreads)
{
    const DartThrowingRequest request = space_request_of({wave_solid, 0.03, 0});
    const PointSet expected = reference::throw_darts(request);
    for (const unsigned threads : {1u, 2u})
        for (const std::size_t group : {7u, 128u})
            EXPECT_EQ(DartThrower(Device::open({}, threads), group).throw_darts(request), expected);
}

TEST(SpaceRelaxation, IsThatOfTheReferenceAndInside)
{
    RelaxationDartThrower thrower(Device::open()), other_groups(Device::open({}, 1), 7);
    for (const char* region : {"box 0 0 0 3 2 1", "ball 0 0 0 1", wave_solid}) {
        RelaxationDartThrowingRequest request;
        request.dimension = 3;
        request.points = 300;
        request.initial_radius = 0.1;
        request.attempts = 700;
        request.stream = stream_key(3, Purpose::relaxation_dart_throwing, 0);
        request.space = std::make_shared<const FixedSpace>(read_space_region(region));
        const RelaxationDarts expected = reference::throw_relaxation_darts(request);
        EXPECT_EQ(thrower.throw_darts(request), expected) << region;
        EXPECT_EQ(other_groups.throw_darts(request), expected) << region;
        const std::vector<TorusPoint<3>> places = space_positions_of(expected.points);
        for (const TorusPoint<3>& place : places) EXPECT_TRUE(request.space->contains(place));
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                ASSERT_GE(squared_distance<3>(places[i], places[j]), squared_threshold(2 * expected.radius));
    }
}

}
}
