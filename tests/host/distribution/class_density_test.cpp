// Densities of classes, and numbers of points by features: counts in bands against integrals, distances of all pairs by
// brute force, kernels against the plain algorithm, and what is refused.
#include "host/distribution/classes/class_points.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace poissonlab {
namespace {

const DistributionPlace density_place{.engine = Engine::reference, .device = {}};

constexpr int bands = 10;

/// Chi-square of counts in bands of equal width along x, from 0 to `width`; `integral` is that of the density up to x.
double chi_square(const PointSet& points, double width, const std::function<double(double)>& integral)
{
    std::array<double, bands> counts{};
    for (std::size_t i = 0; i < points.size(); ++i)
        ++counts[static_cast<std::size_t>(std::min(points[i][0] / width * bands, bands - 1.0))];
    double sum = 0;
    for (int b = 0; b < bands; ++b) {
        const double from = width * b / bands, to = width * (b + 1) / bands;
        const double expected = static_cast<double>(points.size()) * (integral(to) - integral(from)) / integral(width);
        sum += (counts[static_cast<std::size_t>(b)] - expected) * (counts[static_cast<std::size_t>(b)] - expected) /
               expected;
    }
    return sum;
}

void expect_distances(const ClassSet& set)
{
    const ClassedPoints own = set.in_units();
    const ClassDistances kept = set.kept();
    for (std::size_t i = 0; i < own.classes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(std::hypot(own.points[i][0] - own.points[j][0], own.points[i][1] - own.points[j][1]),
                      kept.at(own.classes[i], own.classes[j]))
                << i << ", " << j;
}

ClassSettings wide_settings()
{
    ClassSettings settings;
    settings.place.region = "rectangle 0 0 2 1";
    settings.points = {200, 400, 600};
    settings.densities = {"x", "exp(-2*x)", "7"};
    settings.relative_radius = 0.5;
    return settings;
}

/// Chi-square of 9 degrees of freedom is above 39.3 once in 10^5 times where points are independent; counts are nearer
/// to integrals because targets are evenly spread. A density of another class misses the bound by far.
TEST(ClassDensities, HaveTheirIntegralsInBands)
{
    const std::array<std::function<double(double)>, 3> integrals{
        [](double x) { return x * x; }, [](double x) { return 1 - std::exp(-2 * x); }, [](double x) { return x; }};
    constexpr double most = 39.3;
    const ClassSettings settings = wide_settings();
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const ClassSet set = throw_classes(settings, seed, density_place);
        EXPECT_EQ(set.points.counts(), settings.points);
        expect_distances(set);
        const ClassedPoints own = set.in_units();
        for (std::uint32_t i = 0; i < 3; ++i) {
            const double found = chi_square(own.of_class(i), 2, integrals[i]);
            EXPECT_LT(found, most) << "class " << i << ", seed " << seed;
            EXPECT_GT(chi_square(own.of_class(i), 2, integrals[(i + 1) % 3]), most) << i;
            EXPECT_LT(density_error(set, i), 0.02);
            sum += found / 9;
        }
    }
    EXPECT_LT(sum, 9) << "the mean of independent points";
}

/// Distances that leave no room where the density is largest: the error is said.
TEST(ClassDensities, SayWhereTheyAreFlattened)
{
    ClassSettings settings = wide_settings();
    settings.points = {300};
    settings.densities = {"exp(-8*x)"};
    settings.distances = {0.055};
    const ClassSet set = throw_classes(settings, 1, density_place);
    expect_distances(set);
    EXPECT_GT(density_error(set, 0), 0.02);
    EXPECT_THAT(density_notes(set), testing::ElementsAre(testing::HasSubstr("a sixteenth of the density has ")));
}

/// Units of a density do not matter, however large or small: powers of two change no digit.
TEST(ClassDensities, HaveAnyUnit)
{
    ClassSettings settings = wide_settings();
    settings.points = {100};
    settings.distances = {0.03};
    settings.densities = {"1 + x"};
    const ClassSet set = throw_classes(settings, 1, density_place);
    for (const char* unit : {"2^-900", "2^1021"}) {
        settings.densities = {std::string(unit) + "*(1 + x)"};
        EXPECT_EQ(throw_classes(settings, 1, density_place).points, set.points) << unit;
    }
    settings.densities = {"2^-1068*(1 + x)"}; // of a few digits, which divided cells would lose
    EXPECT_LT(density_error(throw_classes(settings, 1, density_place), 0), 0.05);
}

TEST(ClassDensities, LeavePlacesOfNoDensityEmpty)
{
    ClassSettings settings;
    settings.place.region = "disk 0 0 1";
    settings.points = {1, 2, 300};
    settings.densities = {"y > 0 ? 1 : 0", "x > 0.5 ? 1 : 0", "x > 0 ? 1 : 0"};
    settings.distances = {0.3, 0.2, 0.02};
    const ClassSet set = throw_classes(settings, 3, density_place);
    const ClassedPoints own = set.in_units();
    constexpr double cell = 2.0 / 512; // which densities are read in
    for (std::size_t i = 0; i < own.classes.size(); ++i) {
        const double at = own.classes[i] == 0 ? own.points[i][1] : own.points[i][0];
        EXPECT_GT(at, (own.classes[i] == 1 ? 0.5 : 0) - cell) << i;
    }
}

/// Parts of a star with obstacles, densities, relaxation.
TEST(ClassDensities, AreTheSameByKernels)
{
    for (const double factor : {1.0, 0.97}) {
        ClassSettings settings = wide_settings();
        settings.place.region = "formula -1 -1 1 1 1-x*x-y*y+0.3*sin(9*x)*y";
        settings.place.obstacles = "POLYGON ((-0.2 -0.2, 0.3 -0.1, 0 0.3, -0.2 -0.2))";
        settings.place.obstacle_distance = 0.05;
        settings.densities = {"exp(-4*x*x)", "1+x", "2+y"};
        settings.factor = factor;
        if (factor < 1) {
            settings.points = {10, 20, 30};
            settings.relative_radius = 0.9;
        }
        Device device = Device::open();
        const DistributionPlace kernels{Engine::opencl, [&]() -> Device& { return device; }};
        const ClassSet plain = throw_classes(settings, 2, density_place);
        EXPECT_EQ(plain.points, throw_classes(settings, 2, kernels).points);
        expect_distances(plain);
    }
}

struct ParkFile
{
    TemporaryFolder folder;
    std::filesystem::path file = folder.path() / "park.geojson";

    /// Two lawns of 40 by 30 and 20 by 30 beside each other, a bed of two parts, and a feature without a geometry.
    explicit ParkFile(const std::string& bed = R"("trees": 0, "shrubs": 7, "rate": 0.125)")
    {
        write_whole_file(file, R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "id": "west", "properties": {"trees": 5, "shrubs": 40, "rate": 0.01}, "geometry":
 {"type": "Polygon", "coordinates": [[[1000,0],[1040,0],[1040,30],[1000,30],[1000,0]]]}},
{"type": "Feature", "properties": {"trees": 1, "shrubs": 0, "rate": 0}, "geometry":
 {"type": "Polygon", "coordinates": [[[1040,0],[1060,0],[1060,30],[1040,30],[1040,0]]]}},
{"type": "Feature", "properties": {)" +
                                   bed + R"(}, "geometry": {"type": "MultiPolygon", "coordinates": [
 [[[1000,40],[1010,40],[1010,50],[1000,50],[1000,40]]], [[[1020,40],[1030,40],[1030,50],[1020,50],[1020,40]]]]}},
{"type": "Feature", "properties": {"trees": 0, "shrubs": 0, "rate": 0}, "geometry": null}]})");
    }

    ClassSettings settings() const
    {
        ClassSettings settings;
        settings.place.region = file.string();
        settings.features.points = {"trees", "shrubs"};
        return settings;
    }
};

/// Returns the feature of the park, which are rectangles.
std::size_t feature_at(double x, double y)
{
    if (y <= 30) return x <= 1040 ? 0 : 1;
    return y >= 40 && y <= 50 && (x <= 1010 || (x >= 1020 && x <= 1030)) ? 2 : 3;
}

using FeatureCounts = std::array<std::array<int, 2>, 4>;

FeatureCounts counts_in_features(const ClassSet& set)
{
    FeatureCounts counts{};
    const ClassedPoints own = set.in_units();
    const std::vector<std::string> ids = set.features();
    const std::array<std::string, 4> begins{"\"west\"", "1,", "2,", "none"};
    for (std::size_t i = 0; i < own.classes.size(); ++i) {
        const std::size_t feature = feature_at(own.points[i][0], own.points[i][1]);
        EXPECT_TRUE(ids[i].starts_with(begins[feature])) << ids[i];
        ++counts[feature][own.classes[i]];
    }
    return counts;
}

TEST(ClassFeatures, HaveTheirNumbers)
{
    const ParkFile park;
    ClassSettings settings = park.settings();
    Device device = Device::open();
    const DistributionPlace kernels{Engine::opencl, [&]() -> Device& { return device; }};
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const ClassSet set = throw_classes(settings, seed, density_place);
        EXPECT_EQ(counts_in_features(set), (FeatureCounts{{{5, 40}, {1, 0}, {0, 7}, {0, 0}}}));
        expect_distances(set);
        EXPECT_EQ(set.points, throw_classes(settings, seed, kernels).points);
    }
    // Areas are 1200, 600 and 200: 12, 0 and 25 points. Obstacles take 200 of the first, and 2 of its points.
    settings.features = {{}, {"rate"}};
    EXPECT_EQ(counts_in_features(throw_classes(settings, 1, density_place)),
              (FeatureCounts{{{12, 0}, {0, 0}, {25, 0}, {0, 0}}}));
    settings.place.obstacles = "POLYGON ((1000 0, 1020 0, 1020 10, 1000 10, 1000 0))";
    settings.densities = {"x - 1000"};
    EXPECT_EQ(counts_in_features(throw_classes(settings, 1, density_place)),
              (FeatureCounts{{{10, 0}, {0, 0}, {25, 0}, {0, 0}}}));
}

/// A feature of two polygons that overlap has the area of their union, and is no overlap of features.
TEST(ClassFeatures, MayHavePolygonsThatOverlap)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "beds.geojson";
    write_whole_file(file, R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"rate": 0.1}, "geometry": {"type": "MultiPolygon", "coordinates": [
 [[[1000,0],[1020,0],[1020,10],[1000,10],[1000,0]]], [[[1010,0],[1030,0],[1030,10],[1010,10],[1010,0]]]]}},
{"type": "Feature", "properties": {"rate": 0.001}, "geometry":
 {"type": "Polygon", "coordinates": [[[1030,0],[1050,0],[1050,10],[1030,10],[1030,0]]]}}]})");
    ClassSettings settings;
    settings.place.region = file.string();
    settings.features.densities = {"rate"};
    EXPECT_EQ(throw_classes(settings, 1, density_place).points.classes.size(), 30U); // 30 and 0.2
    settings.densities = {"x < 1003 ? 1 : 0"};
    settings.distances = {1.5};
    EXPECT_THAT(message_of([&] { throw_classes(settings, 1, density_place); }), testing::HasSubstr("is full with"));
    settings.densities = {"x < 1003 ? 1 : 0.1"};
    EXPECT_THAT(density_notes(throw_classes(settings, 1, density_place)),
                testing::ElementsAre(testing::HasSubstr("a sixteenth of the density has ")));
}

/// Densities of features that round to no point are not 0.
TEST(ClassFeatures, WithoutAPointAreRefused)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "few.geojson";
    write_whole_file(file, R"({"type": "Feature", "properties": {"few": 0.001}, "geometry": {"type": "Polygon",
"coordinates": [[[1000,0],[1020,0],[1020,10],[1000,10],[1000,0]]]}})");
    ClassSettings settings;
    settings.place.region = file.string();
    settings.features.densities = {"few"};
    EXPECT_EQ(message_of([&] { throw_classes(settings, 1, density_place); }),
              "few.geojson: no feature has points of class 0: few is 0 everywhere, or times the area less than half a "
              "point");
}

TEST(ClassFeatures, AreRefusedInOneLine)
{
    const auto message = [](const ParkFile& park, const std::function<void(ClassSettings&)>& change) {
        ClassSettings settings = park.settings();
        change(settings);
        return message_of([&] { throw_classes(settings, 1, density_place); });
    };
    const auto as_is = [](ClassSettings&) {};
    EXPECT_EQ(message(ParkFile(R"("trees": 1)"), as_is),
              "park.geojson: features[2]: has no property shrubs: must be a whole number from 0 to 134217728");
    for (const char* value : {"-1", "1.5", "\"2\"", "null", "[3]", "1e400", "134217729"})
        EXPECT_THAT(message(ParkFile(std::string(R"("trees": 1, "shrubs": )") + value), as_is),
                    testing::AnyOf(testing::MatchesRegex("park.geojson: features.2.: property shrubs = .*: must be a "
                                                         "whole number from 0 to 134217728"),
                                   testing::HasSubstr("is not JSON")))
            << value;
    const ParkFile park;
    EXPECT_THAT(message(park,
                        [](ClassSettings& s) {
                            s.distances = {30, 2};
                        }),
                testing::StartsWith("park.geojson: features[0]: class 0 is full with "));
    EXPECT_EQ(message(park,
                      [](ClassSettings& s) {
                          s.densities = {"1", "y > 35 ? 1 : 0"};
                      }),
              "y > 35 ? 1 : 0: is 0 everywhere in the region, or nearly");
    EXPECT_THAT(
        message(park,
                [](ClassSettings& s) {
                    s.densities = {"1", "x - 1020"};
                }),
        testing::MatchesRegex(
            "x - 1020: is -[0-9.]+ at 10[0-9.]+, [0-9.]+ in the region: must be a finite number of at least 0"));
    EXPECT_THAT(
        message(park,
                [](ClassSettings& s) {
                    s.densities = {"1", "sqrt(x - 1020)"};
                }),
        testing::MatchesRegex("sqrt.x - 1020.: is -?nan at .* in the region: must be a finite number of at least 0"));
    EXPECT_EQ(message(park, [](ClassSettings& s) { s.place.region = "rectangle 0 0 1 1"; }),
              "rectangle 0 0 1 1: has no features: a FeatureCollection of GeoJSON has some");
}

}
}
