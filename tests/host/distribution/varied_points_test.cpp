// Points in regions whose minimum distance varies: what each method keeps of all pairs, by the formula itself; no room
// left; constant distances as a case; and what is refused.
#include "host/distribution/regions/varied_points.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/distribution/regions/region_points.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;

const DistributionPlace plain_varied{.engine = Engine::reference, .device = {}};

RegionPointSettings varied_settings(RegionMethod method, const std::string& region, const std::string& formula,
                                    std::size_t points = 0, KeptDistance between = KeptDistance::smaller)
{
    RegionPointSettings settings;
    settings.method = method;
    settings.place.region = region;
    settings.place.reading.is_planar = true;
    settings.place.varying.text = formula;
    settings.place.varying.between = between;
    if (points > 0) settings.place.points = points;
    return settings;
}

/// The least distance of all pairs over what they keep, in doubles, without anything of the laboratory.
template <typename Distance>
double least_ratio(const PointSet& points, bool is_mean, const Distance& distance)
{
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double a = distance(points[i][0], points[i][1]), b = distance(points[j][0], points[j][1]);
            const double gap = std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]);
            least = std::min(least, gap / (is_mean ? (a + b) / 2 : std::min(a, b)));
        }
    return least;
}

double number_of(const RegionDarts& darts, const std::string& key)
{
    for (const DistributionNumber& number : dart_numbers(darts))
        if (number.key == key) return number.value;
    ADD_FAILURE() << key;
    return 0;
}

class VariedMethods : public testing::TestWithParam<std::tuple<RegionMethod, KeptDistance>>
{
};

TEST_P(VariedMethods, KeepTheFormulaOfAllPairs)
{
    const auto [method, between] = GetParam();
    const bool is_mean = between == KeptDistance::mean;
    const auto formula = [](double x, double y) { return 1 + 4 * (x * x + y * y); };
    const RegionDarts made =
        make_region_points(varied_settings(method, "disk 0 0 1", "1+4*(x*x+y*y)", 400, between), 2, plain_varied);
    ASSERT_EQ(made.points.size(), 400U);
    const VariedSet& set = *made.varied;
    const double least = least_ratio(made.points, is_mean, formula);
    EXPECT_GE(least, set.scale * (1 - 1e-5)); // elimination has what was found at nodes
    EXPECT_LT(least, set.scale * 1.05);
    EXPECT_NEAR(set.least_as_typed, least / set.scale, 1e-6);
    if (method != RegionMethod::elimination) {
        EXPECT_GE(set.least, 1);
        EXPECT_GE(least, set.scale);
    }
    // Nearest points tell how dense the set is, over the densest packing.
    const double radius = number_of(made, "relative_radius");
    EXPECT_GT(radius, method == RegionMethod::elimination ? 0.55 : 0.69);
    EXPECT_LT(radius, method == RegionMethod::relaxation ? 0.9 : 0.8);
    for (std::size_t i = 0; i < made.points.size(); ++i)
        EXPECT_NEAR(set.distances[i], set.scale * formula(made.points[i][0], made.points[i][1]), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, VariedMethods,
                         testing::Combine(testing::Values(RegionMethod::darts, RegionMethod::relaxation,
                                                          RegionMethod::elimination),
                                          testing::Values(KeptDistance::smaller, KeptDistance::mean)));

/// Darts of one distance everywhere fill a region as much as those of kernels/dart_throwing.cl: 0.547 of a large plane.
TEST(VariedPoints, OfAConstantDistanceFillAsMuch)
{
    double constant = 0, varied = 0;
    RegionPointSettings settings = varied_settings(RegionMethod::darts, "rectangle 0 0 1 1", "");
    settings.place.min_distance = 0.05;
    for (const std::uint64_t seed : {1, 2})
        constant += static_cast<double>(make_region_points(settings, seed, plain_varied).points.size());
    settings = varied_settings(RegionMethod::darts, "rectangle 0 0 1 1", "0.05");
    for (const std::uint64_t seed : {1, 2}) {
        const RegionDarts darts = make_region_points(settings, seed, plain_varied);
        EXPECT_TRUE(darts.is_saturated);
        varied += static_cast<double>(darts.points.size());
    }
    // Numbers of saturated sets of 300 points vary by some 3: four standard errors of the difference of two sums.
    EXPECT_NEAR(varied, constant, 4 * 3 * std::sqrt(4));
}

/// The part of points in the half where distances are small is that of 1 / distance^2, in every prefix.
TEST(VariedPoints, AreAsDenseAsTheirDistancesInEveryPrefix)
{
    const RegionDarts made =
        make_region_points(varied_settings(RegionMethod::darts, "rectangle 0 0 1 1", "1+9*x", 2000), 5, plain_varied);
    const double expected = (1 - 1 / 5.5) / (1 - 1 / 10.0); // of the integral over x below 1/2
    for (const std::size_t count : {200, 600, 2000}) {
        double small = 0;
        for (std::size_t i = 0; i < count; ++i) small += made.points[i][0] < 0.5;
        // Points of dart throwing vary less than independent ones, whose standard error this is; the boundary's share
        // of denser places is larger where distances are large.
        const double error = std::sqrt(expected * (1 - expected) / static_cast<double>(count));
        EXPECT_NEAR(small / static_cast<double>(count), expected, 4 * error + 0.01) << count;
    }
}

/// The scale follows from the area in all distances, however thin the region is.
TEST(VariedPoints, HaveTheirScaleInThinRegions)
{
    for (const char* region : {"rectangle 0 0 20000 1", "POLYGON ((0 0, 12000 16000, 12000.6 16000.8, 0 1, 0 0))"}) {
        const RegionPointSettings settings = varied_settings(RegionMethod::darts, region, "3", 40);
        const auto land = region_land(settings.place);
        const double wanted = min_distance_for(settings.place.relative_radius, 40, 2) * std::sqrt(area_of(land->rest));
        EXPECT_NEAR(3 * varied_request(settings, land).scale / wanted, 1, 1e-4) << region;
    }
}

TEST(VariedPoints, KeepAwayFromObstacles)
{
    RegionPointSettings settings = varied_settings(RegionMethod::darts, "rectangle 0 0 10 10", "0.2+0.05*x");
    settings.place.obstacles = "POLYGON ((6 6, 8 6, 8 8, 6 8, 6 6))";
    settings.place.obstacle_distance = 1;
    const RegionDarts made = make_region_points(settings, 1, plain_varied);
    EXPECT_GT(made.points.size(), 300U);
    EXPECT_GE(least_ratio(made.points, false, [](double x, double) { return 0.2 + 0.05 * x; }), 1);
    for (std::size_t i = 0; i < made.points.size(); ++i) {
        const double x = made.points[i][0], y = made.points[i][1];
        EXPECT_GE(std::hypot(std::max({6 - x, 0.0, x - 8}), std::max({6 - y, 0.0, y - 8})), 1);
    }
}

TEST(VariedPoints, RefuseSteepDistancesAndWhatHasNoRoom)
{
    const auto refused = [](RegionMethod method, const std::string& formula, std::size_t points,
                            KeptDistance between = KeptDistance::smaller) {
        return message_of([&] {
            make_region_points(varied_settings(method, "rectangle 0 0 1 1", formula, points, between), 1, plain_varied);
        });
    };
    EXPECT_THAT(refused(RegionMethod::darts, "0.01+1.2*x", 0),
                HasSubstr("grows by up to 1.2 along a unit of length, near 0."));
    EXPECT_THAT(refused(RegionMethod::darts, "0.01+1.2*x", 0), HasSubstr("must be less than 1"));
    EXPECT_THAT(refused(RegionMethod::darts, "0.01+2.5*x", 0, KeptDistance::mean), HasSubstr("must be less than 2"));
    EXPECT_THAT(refused(RegionMethod::darts, "x > 0.5 ? 0.1 : 0.05", 0), HasSubstr("along a unit of length"));
    EXPECT_THAT(refused(RegionMethod::darts, "1e-7+x/10", 0), HasSubstr("must be at least"));
    EXPECT_THAT(refused(RegionMethod::darts, "-x", 0), HasSubstr("must be above 0"));
    EXPECT_THAT(refused(RegionMethod::darts, "1e-5+0.5*x", 0), HasSubstr("times as much: at most 32768 times"));
    EXPECT_THAT(refused(RegionMethod::darts, "1e-4+1.997*abs(x-0.5)", 0, KeptDistance::mean),
                HasSubstr("with the mean of both, at most 512 times where it grows as steeply"));
    RegionPointSettings dense = varied_settings(RegionMethod::darts, "rectangle 0 0 1 1", "1+x", 500);
    dense.place.relative_radius = 0.95;
    EXPECT_THAT(message_of([&] { make_region_points(dense, 1, plain_varied); }),
                HasSubstr("of 500 points: no further one fits; a relative radius of about"));
}

}
}
