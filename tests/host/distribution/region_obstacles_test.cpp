// Darts among obstacles in the region's own units: distances as users compute them, places without room by a Monte
// Carlo estimate, and what is refused.
#include "host/distribution/regions/region_darts.hpp"

#include "base/regions/obstacles.hpp"
#include "tests/support/errors.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;

const DistributionPlace on_host{.engine = Engine::reference, .device = {}};

using Corner = std::array<double, 2>;

double gap_between(const Corner& p, const Corner& a, const Corner& b)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], squared = dx * dx + dy * dy;
    const double part = squared == 0 ? 0 : ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / squared;
    const double at = std::clamp(part, 0.0, 1.0);
    return std::hypot(p[0] - a[0] - at * dx, p[1] - a[1] - at * dy);
}

/// Rectangles as obstacles, in which a place is or to which it has a distance.
double gap_from_rectangles(const Corner& p, const std::vector<std::array<double, 4>>& rectangles)
{
    double least = HUGE_VAL;
    for (const auto& [x0, y0, x1, y1] : rectangles)
        least =
            std::min(least, std::hypot(std::max({x0 - p[0], p[0] - x1, 0.0}), std::max({y0 - p[1], p[1] - y1, 0.0})));
    return least;
}

DartSettings among(const std::string& obstacles, double min_distance, std::optional<double> obstacle_distance = {})
{
    DartSettings settings;
    settings.region = "rectangle 500000 5640000 500060 5640040";
    settings.obstacles = obstacles;
    settings.min_distance = min_distance;
    settings.obstacle_distance = obstacle_distance;
    return settings;
}

/// Two that overlap, and one over the boundary; one beside the region, which matters where the distance reaches.
const std::vector<std::array<double, 4>> houses{{500010, 5640010, 500020, 5640020},
                                                {500015, 5640015, 500030, 5640018},
                                                {500050, 5640030, 500070, 5640050},
                                                {499990, 5640030, 499999, 5640035}};

std::string houses_as_text()
{
    std::string text = "MULTIPOLYGON (";
    for (const auto& [x0, y0, x1, y1] : houses)
        text += fmt::format("{}(({} {}, {} {}, {} {}, {} {}, {} {}))", text.back() == '(' ? "" : ",", x0, y0, x1, y0,
                            x1, y1, x0, y1, x0, y0);
    return text + ")";
}

/// Every random place that is a thousandth of the distance farther than it must be has a point nearer than it.
template <typename Gap>
void expect_saturation(const RegionDarts& darts, double obstacle_distance, const Gap& gap)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    const double spare = darts.request.min_distance / 500;
    int looked_at = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Corner p{500000 + 60 * unit(random), 5640000 + 40 * unit(random)};
        if (gap(p) < obstacle_distance + spare) continue;
        ++looked_at;
        double nearest = HUGE_VAL;
        for (std::size_t j = 0; j < darts.points.size(); ++j)
            nearest = std::min(nearest, std::hypot(darts.points[j][0] - p[0], darts.points[j][1] - p[1]));
        ASSERT_LT(nearest, darts.request.min_distance * (1 + 1e-6)) << p[0] << " " << p[1];
    }
    EXPECT_GT(looked_at, 5000);
}

TEST(DartsAmongHouses, KeepTheirDistanceAndLeaveNoRoom)
{
    const auto gap = [](const Corner& p) { return gap_from_rectangles(p, houses); };
    for (const double distance : {0.0, 0.7, 4.0}) {
        const RegionDarts darts = throw_region_darts(among(houses_as_text(), 1.5, distance), 2, on_host);
        EXPECT_TRUE(darts.is_saturated);
        for (std::size_t i = 0; i < darts.points.size(); ++i) {
            const double found = gap({darts.points[i][0], darts.points[i][1]});
            ASSERT_GT(found, 0);
            ASSERT_GE(found, distance);
        }
        expect_saturation(darts, distance, gap);
    }
    // Without a distance that of polygons is 0. What is left: 60 by 40 without 100 + 30 and 100, but for their overlap.
    const RegionDarts plain = throw_region_darts(among(houses_as_text(), 1.5), 2, on_host);
    EXPECT_EQ(plain.points, throw_region_darts(among(houses_as_text(), 1.5, 0), 2, on_host).points);
    EXPECT_NEAR(plain.request.region->area(), 2400 - (100 + 45 - 15) - 100, 1e-6);
}

TEST(DartsAmongTrees, KeepTheMinimumDistanceFromPointsUnlessToldOtherwise)
{
    const std::vector<Corner> trees{{500003, 5640003}, {500030, 5640020}, {500062, 5640041}};
    const std::string text = "MULTIPOINT ((500003 5640003), (500030 5640020), (500062 5640041))";
    const auto gap = [&](const Corner& p) {
        double least = HUGE_VAL;
        for (const Corner& tree : trees) least = std::min(least, std::hypot(p[0] - tree[0], p[1] - tree[1]));
        return least;
    };
    for (const std::optional<double> distance : {std::optional<double>{}, {6.0}, {0.0}}) {
        const RegionDarts darts = throw_region_darts(among(text, 3, distance), 4, on_host);
        for (std::size_t i = 0; i < darts.points.size(); ++i)
            ASSERT_GE(gap({darts.points[i][0], darts.points[i][1]}), distance.value_or(3));
        expect_saturation(darts, distance.value_or(3), gap);
    }
}

TEST(DartsAmongTracks, KeepAwayFromLines)
{
    const std::vector<Corner> track{{499900, 5640010}, {500020, 5640015}, {500040, 5640090}};
    const auto gap = [&](const Corner& p) {
        return std::min(gap_between(p, track[0], track[1]), gap_between(p, track[1], track[2]));
    };
    const std::string text = "LINESTRING (499900 5640010, 500020 5640015, 500040 5640090)";
    const RegionDarts darts = throw_region_darts(among(text, 2, 2.5), 4, on_host);
    for (std::size_t i = 0; i < darts.points.size(); ++i) ASSERT_GE(gap({darts.points[i][0], darts.points[i][1]}), 2.5);
    expect_saturation(darts, 2.5, gap);
    // Whole disks do not lie on it either.
    DartSettings disks = among(text, 2);
    disks.boundary = RegionBoundary::disks;
    const PointSet points = throw_region_darts(disks, 4, on_host).points;
    for (std::size_t i = 0; i < points.size(); ++i) ASSERT_GE(gap({points[i][0], points[i][1]}), 1);
}

TEST(DartsAmongObstaclesOfOwnUnits, AreRefusedWhereThereIsNoRoom)
{
    for (const auto& [settings, words] : std::initializer_list<std::pair<DartSettings, std::string>>{
             {among("rectangle 0 0 600000 6000000", 2), "they cover the region: nothing is left of it"},
             {among("POINT (500030 5640020)", 2, 59), "no room for a point among the obstacles"},
             {among("POINT (500030 5640020)", 2, 61),
              "a distance of 61 from them is more than the region's longest side, 60"}})
        EXPECT_THAT(message_of([&, &s = settings] { throw_region_darts(s, 1, on_host); }), HasSubstr(words));
}

}
}
