// Darts in regions in the regions' own units, and what is refused.
#include "host/distribution/regions/nearest_in_plane.hpp"
#include "host/distribution/regions/region_darts.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;

const DistributionPlace plain{.engine = Engine::reference, .device = {}};

DartSettings settings_of(const std::string& region)
{
    DartSettings settings;
    settings.region = region;
    return settings;
}

/// The least distance of any two points, as a user would compute it, and the mean of the least of each.
NearestDistances by_all_pairs(const PointSet& points)
{
    NearestDistances distances{HUGE_VAL, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest = HUGE_VAL;
        for (std::size_t j = 0; j < points.size(); ++j)
            if (j != i)
                nearest = std::min(nearest, std::sqrt(std::pow(points[i][0] - points[j][0], 2) +
                                                      std::pow(points[i][1] - points[j][1], 2)));
        distances.least = std::min(distances.least, nearest);
        distances.mean += nearest / static_cast<double>(points.size());
    }
    return distances;
}

/// Coordinates of a national grid have few digits after the point: distances are never below the one that is asked for.
TEST(RegionDartsOfOwnUnits, AreAsFarApartAsIsAsked)
{
    for (const char* region : {"rectangle 500000 5640000 500060 5640040", "disk -7 1e-3 30", "rectangle 0 0 60 40",
                               "rectangle 50000000 564000000 50000060 564000040"}) {
        DartSettings settings = settings_of(region);
        settings.min_distance = 1.5;
        const RegionDarts darts = throw_region_darts(settings, 3, plain);
        EXPECT_TRUE(darts.is_saturated);
        const NearestDistances found = by_all_pairs(darts.points), told = nearest_distances(darts.points);
        EXPECT_GE(found.least, 1.5) << region;
        EXPECT_LT(found.least, 1.5 * 1.01) << region;
        EXPECT_DOUBLE_EQ(told.least, found.least);
        EXPECT_NEAR(told.mean, found.mean, 1e-9);
    }
}

/// Saturated sets in a square without neighbours: 0.5471 of the area that disks of half the distance around points
/// cover if one counts the margin where these stick out. Zhang and Torquato 2013 have the density; a margin of half a
/// distance around the square is where the disks of points inside can reach.
TEST(RegionDartsOfOwnUnits, AreAsManyAsRandomSequentialAdditionHas)
{
    DartSettings settings = settings_of("rectangle 0 0 100 100");
    settings.min_distance = 1;
    const auto count = static_cast<double>(throw_region_darts(settings, 1, plain).points.size());
    const double density = 0.5470735 / (M_PI / 4);
    EXPECT_GT(count, density * 100 * 100);
    EXPECT_LT(count, density * 101 * 101);
}

TEST(RegionDartsOfOwnUnits, StopAtANumber)
{
    DartSettings settings = settings_of("POLYGON ((0 0, 300 0, 0 400, 0 0))");
    settings.points = 500;
    const RegionDarts darts = throw_region_darts(settings, 1, plain);
    ASSERT_EQ(darts.points.size(), 500U);
    EXPECT_FALSE(darts.is_saturated);
    // 0.7 of the densest packing of 500 points in 60,000 squared units.
    EXPECT_NEAR(darts.request.min_distance, 0.7 * std::sqrt(2 / std::sqrt(3.0) * 60'000 / 500), 1e-9);
    EXPECT_GE(nearest_distances(darts.points).least, darts.request.min_distance);
    for (std::size_t i = 0; i < 500; ++i) EXPECT_LE(darts.points[i][0] / 300 + darts.points[i][1] / 400, 1 + 1e-9);
    // A prefix is the set of fewer points at that distance; another seed has others.
    settings.min_distance = darts.request.min_distance;
    settings.points = 100;
    const PointSet fewer = throw_region_darts(settings, 1, plain).points;
    EXPECT_TRUE(std::ranges::equal(fewer.coordinates, std::span(darts.points.coordinates).first(200)));
    EXPECT_NE(throw_region_darts(settings, 2, plain).points, fewer);
}

TEST(RegionDartsOfOwnUnits, AreRefusedWhereThereIsNoRoom)
{
    DartSettings settings = settings_of("rectangle 0 0 30 20");
    settings.min_distance = 31;
    EXPECT_THAT(message_of([&] { throw_region_darts(settings, 1, plain); }),
                HasSubstr("31 is more than the region's longest side, 30: there is room for one point"));
    settings.min_distance = 1e-4;
    EXPECT_THAT(
        message_of([&] { throw_region_darts(settings, 1, plain); }),
        HasSubstr("a minimum distance of 0.0001 leaves room for more points in the region than there is memory for; at "
                  "least some 0."));
    settings.min_distance = 1e-6;
    EXPECT_THAT(
        message_of([&] { throw_region_darts(settings, 1, plain); }),
        HasSubstr("a minimum distance of 1e-06 is too short for a region of this extent, along which 2^31 positions "
                  "are told apart; at least 3.58e-06"));
    settings.min_distance = 25;
    settings.boundary = RegionBoundary::disks;
    EXPECT_THAT(message_of([&] { throw_region_darts(settings, 1, plain); }),
                HasSubstr("no room for a disk of diameter 25"));
    settings.boundary = RegionBoundary::inside;
    settings.min_distance = 3;
    settings.points = 500;
    EXPECT_THAT(message_of([&] { throw_region_darts(settings, 1, plain); }),
                testing::ContainsRegex("the region is saturated with [4-6][0-9] of 500 points: no further one fits; a "
                                       "minimum distance of about [01]\\.[0-9]+ can be reached"));
    settings.min_distance.reset();
    settings.relative_radius = 1;
    EXPECT_THAT(
        message_of([&] { throw_region_darts(settings, 1, plain); }),
        testing::ContainsRegex("of 500 points: no further one fits; a relative radius of about 0\\.[78][0-9]+"));
}

TEST(RegionDartsOfOwnUnits, AreTheSameByKernel)
{
    DartSettings settings = settings_of("disk 5 6 7");
    settings.min_distance = 0.2;
    const DistributionPlace device{.engine = Engine::opencl, .device = []() -> Device& {
                                       static Device opened = Device::open();
                                       return opened;
                                   }};
    EXPECT_EQ(throw_region_darts(settings, 5, device).points, throw_region_darts(settings, 5, plain).points);
}

}
}
