// Points of several classes on lines are held against Rényi's parking problem, all pairs by brute force, places where
// one might be missing, and numbers that were asked for.
#include "host/distribution/classes/class_lines.hpp"

#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;

ClassSettings on_paths(const std::string& region)
{
    ClassSettings settings;
    settings.place.region = region;
    settings.place.reading.is_along = true;
    return settings;
}

ClassSet thrown_on(const ClassSettings& settings, std::uint64_t seed = 1)
{
    return throw_classes(settings, seed, DistributionPlace{});
}

/// Paths that cross, run side by side, bend sharply and come back.
const std::string paths = "GEOMETRYCOLLECTION (MULTILINESTRING ((0 0, 90 60), (0 60, 90 0, 5 3)), "
                          "LINESTRING (0 61, 90 61), LINESTRING (0 61.5, 90 61.5), LINESTRING (40 70, 70 80, 40 70), "
                          "POLYGON ((30 10, 60 10, 60 40, 30 10)))";

double distance_of(const ClassedPoints& set, std::size_t i, double x, double y)
{
    const double right = set.points[i][0] - x, up = set.points[i][1] - y;
    return std::sqrt(right * right + up * up);
}

/// The least distance of each pair of classes, from all pairs of points.
ClassDistances least_by_pairs(const ClassedPoints& set)
{
    ClassDistances least(set.is_full.size());
    for (std::size_t a = 0; a < least.classes(); ++a)
        for (std::size_t b = 0; b <= a; ++b) least.set(a, b, INFINITY);
    for (std::size_t i = 0; i < set.classes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::size_t a = set.classes[i], b = set.classes[j];
            least.set(a, b, std::min(least.at(a, b), distance_of(set, i, set.points[j][0], set.points[j][1])));
        }
    return least;
}

/// Calls `check` with places along the lines, a thousandth of `step` apart at most.
template <class Check>
void for_each_place_of(const std::string& region, double step, const Check& check)
{
    const std::vector<RegionRing> lines = lines_of(read_region(region, {.is_along = true}));
    for (const RegionRing& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const double x = line[i][0] - line[i - 1][0], y = line[i][1] - line[i - 1][1];
            const double steps = std::ceil(1000 * std::hypot(x, y) / step);
            for (double k = 0; k <= steps; ++k) check(line[i - 1][0] + x * k / steps, line[i - 1][1] + y * k / steps);
        }
}

/// Cars of length 1 on a street of length x are 0.7475979 (x + 1) - 1 on average, with the variance 0.0381564 of x
/// (Rényi 1958; Mackenzie 1962). Classes that all keep one distance are such cars in several colours.
TEST(ClassesOnLines, OfOneDistanceAreRenyisParkedCars)
{
    constexpr double length = 20'000;
    const double mean = 0.7475979202 * (length + 2) - 1, deviation = std::sqrt(0.03815639 * (length + 1));
    for (const std::size_t classes : {1, 2, 3}) {
        ClassSettings settings = on_paths("LINESTRING (500000 5640000, 520000 5640000)");
        settings.matrix.assign(classes * classes, 1);
        for (const std::uint64_t seed : {1, 2}) {
            const ClassSet made = thrown_on(settings, seed);
            EXPECT_NEAR(static_cast<double>(made.points.points.size()), mean, 4 * deviation) << classes;
            EXPECT_EQ(made.size(), length);
            for (const std::size_t count : made.points.counts())
                EXPECT_NEAR(static_cast<double>(count), static_cast<double>(made.points.points.size() / classes), 1);
        }
    }
}

TEST(ClassesOnLines, KeepTheDistanceOfEachPairAndLeaveNoRoom)
{
    ClassSettings settings = on_paths(paths);
    settings.matrix = {9, 4, 1, 4, 3, 2.5, 1, 2.5, 2};
    for (const std::uint64_t seed : {1, 2, 3}) {
        const ClassSet made = thrown_on(settings, seed);
        const ClassedPoints& set = made.points;
        EXPECT_GT(set.points.size(), 150U);
        EXPECT_EQ(set.is_full, std::vector<bool>(3, true));
        const ClassDistances least = least_by_pairs(set);
        EXPECT_EQ(least, least_in_plane(set));
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b <= a; ++b) {
                EXPECT_GE(least.at(a, b), settings.matrix[3 * a + b]);
                EXPECT_LT(least.at(a, b), settings.matrix[3 * a + b] * 1.5);
            }
        std::size_t free = 0;
        for_each_place_of(paths, 9, [&](double x, double y) {
            for (std::size_t own = 0; own < 3; ++own) {
                bool is_free = true;
                for (std::size_t i = 0; is_free && i < set.classes.size(); ++i)
                    is_free = distance_of(set, i, x, y) >= settings.matrix[3 * own + set.classes[i]] * (1 + 1e-9);
                free += is_free;
            }
        });
        EXPECT_EQ(free, 0U);
    }
}

TEST(ClassesOnLines, AreAsManyAsAreAskedForAndFillEvenly)
{
    ClassSettings settings = on_paths("disk 0 0 100");
    settings.points = {30, 90};
    const ClassSet made = thrown_on(settings);
    EXPECT_EQ(made.points.counts(), settings.points);
    EXPECT_EQ(made.points.is_full, std::vector<bool>(2));
    // Densities along a line add up: the second class keeps the distance of both from the first one.
    const double length = made.size(), own = 0.62 * length / 90, other = 0.62 * length / 30;
    EXPECT_NEAR(made.kept().at(0, 0), other, 1e-9);
    EXPECT_NEAR(made.kept().at(0, 1), 1 / (1 / own + 1 / other), 1e-9);
    std::size_t first = 0;
    for (std::size_t i = 0; i < 120; ++i) {
        first += made.points.classes[i] == 0;
        EXPECT_NEAR(static_cast<double>(first), static_cast<double>(i + 1) / 4, 0.75);
    }
    EXPECT_EQ(thrown_on(settings).points, made.points);
    EXPECT_NE(thrown_on(settings, 2).points.points, made.points.points);
    settings.points.clear();
    settings.place.region = "LINESTRING (0 0, 1000 0)";
    settings.per_length = {0.01, 0.05};
    EXPECT_EQ(points_on_lines(settings), (std::vector<std::size_t>{10, 50}));
    settings.place.obstacles = "POLYGON ((200 -1, 700 -1, 700 1, 200 1, 200 -1))";
    EXPECT_EQ(points_on_lines(settings), (std::vector<std::size_t>{5, 25}));
}

TEST(ClassesOnLines, AreOfAllSizes)
{
    for (std::size_t count = 1; count <= 3; ++count) {
        ClassSettings settings = on_paths("LINESTRING (0 0, 10 0, 10 10)");
        settings.points.assign(count, count);
        settings.relative_radius = 0.3;
        for (std::uint64_t seed = 0; seed < 20; ++seed)
            EXPECT_EQ(thrown_on(settings, seed).points.counts(), settings.points);
    }
}

/// Too large distances are multiplied by a factor until there is room, and no sooner.
TEST(ClassesOnLines, RelaxTheirDistances)
{
    ClassSettings settings = on_paths("LINESTRING (0 0, 1000 0)");
    settings.points = {40, 80};
    settings.distances = {20, 10};
    EXPECT_THAT(message_of([&] { thrown_on(settings); }), HasSubstr("points: no further one fits; distances of about"));
    settings.factor = 0.97;
    const ClassSet made = thrown_on(settings);
    EXPECT_EQ(made.points.counts(), settings.points);
    const double steps = std::log(made.points.scale) / std::log(0.97);
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_GE(steps, 1);
    const ClassDistances least = least_by_pairs(made.points), kept = made.kept();
    double nearest = INFINITY; // over the pair's distance before the last step
    for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t b = 0; b <= a; ++b) {
            EXPECT_GE(least.at(a, b), kept.at(a, b));
            nearest = std::min(nearest, least.at(a, b) * 0.97 / kept.at(a, b));
        }
    EXPECT_LT(nearest, 1);
}

/// A few points are uniform by length: a line three times as long has three quarters of them.
TEST(ClassesOnLines, FallByLength)
{
    ClassSettings settings = on_paths("MULTILINESTRING ((0 0, 0 30), (90 0, 90 90))");
    settings.points = {4000, 4000};
    settings.distances = {1e-3, 1e-3};
    const ClassSet made = thrown_on(settings);
    for (std::uint32_t own = 0; own < 2; ++own) {
        const PointSet some = made.points.of_class(own);
        double left = 0;
        for (std::size_t i = 0; i < some.size(); ++i) left += some[i][0] == 0;
        EXPECT_NEAR(left / 4000, 0.25, 4 * std::sqrt(0.25 * 0.75 / 4000));
    }
}

TEST(ClassesOnLines, KeepAwayFromObstaclesAndKnowTheirFeature)
{
    ClassSettings settings = on_paths("MULTILINESTRING ((0 0, 100 0), (0 50, 100 50))");
    settings.distances = {3, 1};
    settings.place.obstacles = "GEOMETRYCOLLECTION (POLYGON ((20 -5, 40 -5, 40 5, 20 5, 20 -5)), POINT (60 1))";
    settings.place.obstacle_distance = 4;
    const ClassSet made = thrown_on(settings);
    EXPECT_NEAR(made.size(), 200 - 28, 1e-2);
    for (std::size_t i = 0; i < made.points.classes.size(); ++i) {
        const auto at = made.points.points[i];
        EXPECT_GE(std::hypot(at[0] - 60, at[1] - 1), 4);
        EXPECT_TRUE(at[1] == 50 || at[0] <= 16 || at[0] >= 44) << at[0];
    }
    const ClassSettings two = [] {
        ClassSettings features = on_paths(R"({"type": "FeatureCollection", "features": [
            {"type": "Feature", "id": "path", "geometry": {"type": "LineString", "coordinates": [[0, 0], [500, 0]]}},
            {"type": "Feature", "id": 7, "geometry": {"type": "LineString", "coordinates": [[0, 300], [500, 300]]}}]})");
        features.points = {10, 20};
        return features;
    }();
    const ClassSet known = thrown_on(two);
    const std::vector<std::string> features = known.features();
    ASSERT_EQ(features.size(), 30U);
    for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(features[i], known.points.points[i][1] == 0 ? "\"path\"" : "7");
}

/// The zigzag is five times as long as its longest side: the distance of which a radius is a part would be larger.
TEST(ClassesOnLines, HaveDerivedDistancesThatFit)
{
    ClassSettings settings = on_paths("LINESTRING (0 0, 1 1, 0 1, 1 0, 0 0.5, 1 0.5)");
    settings.points = {1, 1};
    settings.relative_radius = 1;
    settings.factor = 0.9;
    EXPECT_EQ(thrown_on(settings).points.points.size(), 2U);
}

/// The places of a column all have the same x.
TEST(ClassesOnLines, HaveTheLeastDistancesOfAllPairsInAColumn)
{
    ClassSettings settings = on_paths("LINESTRING (500000 5640000, 500000 5640200)");
    settings.distances = {0.7, 1.1, 3};
    const ClassedPoints set = thrown_on(settings).points;
    EXPECT_EQ(least_in_plane(set), least_by_pairs(set));
}

TEST(ClassesOnLines, SayWhatIsWrong)
{
    const auto message = [](const std::string& region, const std::vector<double>& distances,
                            const std::string& obstacles = "") {
        ClassSettings settings = on_paths(region);
        settings.distances = distances;
        settings.place.obstacles = obstacles;
        return message_of([&] { thrown_on(settings); });
    };
    EXPECT_THAT(message("POINT (1 1)", {1, 1}), HasSubstr("has no line with a length that points could lie on"));
    EXPECT_EQ(message("LINESTRING (0 0, 5 0)", {1, 6}),
              "6 is more than the lines' longest side, 5: there is room for one point of class 1");
    EXPECT_THAT(message("LINESTRING (0 0, 5 0)", {1, 1e-12}), HasSubstr("more than memory holds"));
    EXPECT_EQ(message("LINESTRING (0 0, 5 0)", {1, 2}, "POLYGON ((-1 -1, 6 -1, 6 1, -1 1, -1 -1))"),
              "the lines have no room for a point among the obstacles");
    ClassSettings covered = on_paths("LINESTRING (0 0, 5 0)"); // distances that shrink make no room either
    covered.points = {3, 3};
    covered.factor = 0.9;
    covered.place.obstacles = "POINT (2.5 0)";
    covered.place.obstacle_distance = 4;
    EXPECT_EQ(message_of([&] { thrown_on(covered); }), "the lines have no room for a point among the obstacles");
    ClassSettings rare = on_paths("LINESTRING (0 0, 5 0)");
    rare.per_length = {1, 1e-3};
    EXPECT_EQ(message_of([&] { points_on_lines(rare); }),
              "0.001 times the length of the lines, 5, gives class 1 0 points: must be from 1 to 134217728");
}

}
}
