// Points on lines are held against Rényi's parking problem, all pairs by brute force, and places where one might be
// missing.
#include "host/distribution/regions/line_points.hpp"

#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using testing::Each;
using testing::HasSubstr;

using RoadPlace = std::array<double, 2>;

DartSettings on_lines(const std::string& region, double min_distance)
{
    DartSettings settings;
    settings.region = region;
    settings.reading.is_along = true;
    settings.min_distance = min_distance;
    return settings;
}

double street_distance(const RoadPlace& p, const RoadPlace& q)
{
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
}

std::vector<RoadPlace> street_places(const PointSet& points)
{
    std::vector<RoadPlace> places;
    for (std::size_t i = 0; i < points.size(); ++i) places.push_back({points[i][0], points[i][1]});
    return places;
}

double nearest_of(const std::vector<RoadPlace>& places, const RoadPlace& to)
{
    double least = HUGE_VAL;
    for (const RoadPlace& place : places)
        if (place != to) least = std::min(least, street_distance(place, to));
    return least;
}

/// Calls `check` with places along the lines, closer to each other than a thousandth of the distance.
template <class Check>
void for_places_along(const std::vector<RegionRing>& lines, double distance, const Check& check)
{
    for (const RegionRing& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (line[i - 1] == line[i]) continue;
            const double steps = std::ceil(1000 * street_distance(line[i - 1], line[i]) / distance);
            for (double step = 0; step <= steps; ++step)
                check(RoadPlace{line[i - 1][0] + (line[i][0] - line[i - 1][0]) * step / steps,
                                line[i - 1][1] + (line[i][1] - line[i - 1][1]) * step / steps});
        }
}

/// Cars of length 1 on a street of length x are 0.7475979 (x + 1) - 1 on average, and their variance is 0.0381564 of x
/// (Rényi 1958; Mackenzie 1962): points are their middles, so that the street is longer than the line by 1.
TEST(PointsOnLines, AreRenyisParkedCars)
{
    constexpr double length = 20'000;
    const RegionDarts made = throw_line_darts(on_lines("LINESTRING (500000 5640000, 520000 5640000)", 1), 5);
    const double mean = 0.7475979202 * (length + 2) - 1, deviation = std::sqrt(0.03815639 * (length + 1));
    EXPECT_NEAR(static_cast<double>(made.points.size()), mean, 4 * deviation);
    EXPECT_TRUE(made.is_saturated);
    std::vector<double> along;
    for (std::size_t i = 0; i < made.points.size(); ++i) along.push_back(made.points[i][0]);
    std::ranges::sort(along);
    EXPECT_LT(along.front() - 500'000, 1);
    EXPECT_LT(520'000 - along.back(), 1);
    for (std::size_t i = 1; i < along.size(); ++i) {
        ASSERT_GE(along[i] - along[i - 1], 1);
        ASSERT_LT(along[i] - along[i - 1], 2 + 1e-7);
    }
}

/// These lines have a crossing, a bend with a sharp angle, a loop, lines side by side, a dead end there and back, and
/// an edge twice.
const std::string streets = "GEOMETRYCOLLECTION (MULTILINESTRING ((0 0, 90 60), (0 60, 90 0, 5 3), (20 50, 20 50)), "
                            "LINESTRING (0 61, 90 61), LINESTRING (0 61.5, 90 61.5), LINESTRING (40 70, 70 80, 40 70), "
                            "LINESTRING (90 60, 0 0), POLYGON ((30 10, 60 10, 60 40, 30 10)))";

TEST(PointsOnLines, KeepTheirDistanceInThePlaneAndLeaveNoRoom)
{
    constexpr double distance = 1.5;
    const RegionDarts made = throw_line_darts(on_lines(streets, distance), 1);
    const std::vector<RoadPlace> places = street_places(made.points);
    const std::vector<RegionRing> lines = lines_of(read_region(streets, {.is_along = true}));
    EXPECT_GT(places.size(), 200U);
    for (const RoadPlace& place : places) {
        ASSERT_GE(nearest_of(places, place), distance);
        double off = HUGE_VAL;
        for_places_along(lines, distance,
                         [&](const RoadPlace& on) { off = std::min(off, street_distance(on, place)); });
        ASSERT_LT(off, distance * 0.5e-3 + 1e-9);
    }
    for_places_along(lines, distance, [&](const RoadPlace& on) {
        if (nearest_of(places, on) >= distance * (1 + 1e-9)) FAIL() << on[0] << " " << on[1];
    });
}

TEST(PointsOnLines, AreAsManyAsAreAskedFor)
{
    DartSettings settings = on_lines("disk 0 0 100", 1);
    settings.min_distance.reset();
    settings.points = 300;
    const RegionDarts made = throw_line_darts(settings, 2);
    EXPECT_EQ(made.points.size(), 300U);
    EXPECT_FALSE(made.is_saturated);
    EXPECT_NEAR(made.length, 2 * std::numbers::pi * 100, 2e-3);
    EXPECT_NEAR(made.sure_distance, 0.7 * made.length / 300, 1e-12);
    // A prefix is the set of fewer points at that distance; other seeds and realizations have others.
    settings.min_distance = made.sure_distance;
    settings.points = 10;
    const PointSet fewer = throw_line_darts(settings, 2).points;
    EXPECT_TRUE(std::ranges::equal(fewer.coordinates, std::span(made.points.coordinates).first(20)));
    EXPECT_NE(throw_line_darts(settings, 3).points, fewer);
    EXPECT_NE(throw_line_darts(settings, 2, 1).points, fewer);
    settings.points = 900;
    EXPECT_THAT(message_of([&] { throw_line_darts(settings, 1); }), HasSubstr("the lines are saturated with "));
}

/// Few points are uniform by length: a line three times as long has three quarters of them.
TEST(PointsOnLines, FallByLength)
{
    DartSettings settings = on_lines("MULTILINESTRING ((0 0, 0 30), (90 0, 90 90), (90 90, 90 0))", 1e-3);
    settings.points = 10'000;
    const std::vector<RoadPlace> places = street_places(throw_line_darts(settings, 4).points);
    const auto share =
        static_cast<double>(std::ranges::count(places, 0.0, [](const auto& p) { return p[0]; })) / 10'000;
    EXPECT_NEAR(share, 0.25, 4 * std::sqrt(0.25 * 0.75 / 10'000));
}

TEST(PointsOnLines, KeepAwayFromObstacles)
{
    DartSettings settings = on_lines("MULTILINESTRING ((0 0, 100 0), (0 50, 100 50))", 2);
    settings.obstacles = "GEOMETRYCOLLECTION (POLYGON ((20 -5, 40 -5, 40 5, 20 5, 20 -5)), POINT (60 1), "
                         "LINESTRING (80 -9, 80 9), POINT (5000 5000))";
    settings.obstacle_distance = 3;
    const RegionDarts made = throw_line_darts(settings, 1);
    EXPECT_NEAR(made.length, 200 - 26 - 6, 1e-2);
    EXPECT_GT(made.request.near_obstacles, 0U);
    for (const RoadPlace& place : street_places(made.points)) {
        if (place[1] != 0) continue;
        EXPECT_TRUE(place[0] <= 17 || place[0] >= 43) << place[0];
        EXPECT_GE(street_distance(place, {60, 1}), 3);
        EXPECT_GE(std::abs(place[0] - 80), 3);
    }
    settings.obstacles = "POLYGON ((-9 -9, 200 -9, 200 90, -9 90, -9 -9))";
    EXPECT_EQ(message_of([&] { throw_line_darts(settings, 1); }),
              "the lines have no room for a point among the obstacles");
}

TEST(PointsOnLines, KnowTheFeatureOfTheirLine)
{
    const RegionDarts made = throw_line_darts(on_lines(R"({"type": "FeatureCollection", "features": [
            {"type": "Feature", "id": "A1", "geometry": {"type": "LineString", "coordinates": [[0, 0], [500, 0]]}},
            {"type": "Feature", "geometry": null},
            {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[0, 9], [500, 9], [500, 99], [0, 9]]]}},
            {"type": "Feature", "id": 7, "geometry": {"type": "MultiLineString",
                "coordinates": [[[0, 200], [500, 200]], [[0, 300], [500, 300]]]}}]})",
                                                       5),
                                              1);
    ASSERT_EQ(made.features.size(), made.points.size());
    for (std::size_t i = 0; i < made.points.size(); ++i) {
        const double y = made.points[i][1];
        EXPECT_EQ(made.features[i], y == 0 ? "\"A1\"" : y >= 200 ? "7" : "2");
    }
}

TEST(PointsOnLines, TakeDrawings)
{
    const auto length = [](const std::string& text) {
        return length_of(lines_of(read_region(text, {.is_along = true})));
    };
    EXPECT_EQ(length("path M0 0 H10 V5"), 15);
    EXPECT_EQ(length("path M0 0 H10 V10 H0 Z M0 0 L3 4"), 45);
    EXPECT_NEAR(length("path M0 0 A5 5 0 0 1 10 0"), 5 * std::numbers::pi, 5e-3);
    const std::string drawing = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 99 99'><g transform='scale(2)'>"
                                "<line x1='0' y1='0' x2='3' y2='4'/><polyline points='0 0 1 0'/>"
                                "<path d='M5 5 h4 m1 1 h4'/><rect width='2' height='3'/></g></svg>";
    EXPECT_EQ(length_of(lines_of_svg_drawing(drawing, "a.svg")), 2 * (5 + 1 + 8 + 10));
}

TEST(PointsOnLines, SayWhatIsWrong)
{
    const auto message = [](const std::string& text, double distance) {
        return message_of([&] { throw_line_darts(on_lines(text, distance), 1); });
    };
    EXPECT_THAT(message("POINT (1 1)", 1), HasSubstr("has no line with a length that points could lie on"));
    EXPECT_THAT(message("LINESTRING (1 1, 1 1)", 1), HasSubstr("has no line with a length that points could lie on"));
    EXPECT_THAT(message("LINESTRING (0 0, 1 0)", 2), HasSubstr("2 is more than the lines' longest side, 1"));
    EXPECT_THAT(message("LINESTRING (0 0, 1 0)", 1e-9), HasSubstr("more than memory holds"));
    // A line as long as the distance has room for two.
    EXPECT_LE(throw_line_darts(on_lines("LINESTRING (0 0, 1 0)", 1), 1).points.size(), 2U);
}

}
}
