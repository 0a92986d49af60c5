// Curves of a small set of points in a rectangle and in a polygon with a hole, against spatstat and survival.
#include "analysis/regions/region_curves.hpp"

#include "analysis/regions/region_distances.hpp"
#include "base/errors/errors.hpp"
#include "tests/analysis/regions/spatstat_numbers.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using test::spatstat_count;

class SpatstatCase
{
public:
    SpatstatCase(const PlaneRegion& region, const test::SpatstatNumbers& expected)
        : framed(region, "region"), numbers(expected), points(framed.framed({2, test::spatstat_points}, "points")),
          covariance(framed.boundary().edges())
    {
        distances.step = test::spatstat_reach / framed.side() / spatstat_count;
        distances.count = spatstat_count;
        distances.half_width = 0.15 * framed.unit_length() / std::sqrt(static_cast<double>(points.size()));
    }

    FramedRegion framed;
    const test::SpatstatNumbers& numbers;
    PointSet points;
    SetCovariance covariance;
    PairDistances distances;
};

void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double relative,
                 double absolute, const char* name)
{
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_NEAR(found[k], expected[k], std::max(relative * std::abs(expected[k]), absolute)) << name << " " << k;
}

class SpatstatTest : public testing::TestWithParam<bool>
{
protected:
    SpatstatCase at_hand = GetParam() ? SpatstatCase(test::spatstat_rectangle, test::spatstat_in_rectangle)
                                      : SpatstatCase(test::spatstat_polygon, test::spatstat_in_polygon);
};

TEST_P(SpatstatTest, PairsAreTheSame)
{
    const auto& [framed, numbers, points, covariance, distances] = at_hand;
    PairCurves curves = region_pairs(points, framed, covariance, distances);
    for (double& k : curves.k_translation) k *= framed.side() * framed.side();
    for (double& k : curves.k_isotropic) k *= framed.side() * framed.side();
    // spatstat's exact areas of polygons are those of its polygon clipper, whose corners are whole numbers.
    expect_near(curves.k_translation, numbers.k_translation, GetParam() ? 1e-13 : 1e-7, 1e-13, "K, translation");
    expect_near(curves.g_smooth, numbers.g, GetParam() ? 1e-11 : 1e-7, 1e-12, "g");
    expect_near(curves.k_isotropic, numbers.k_isotropic, 1e-10, 1e-13, "K, isotropic");
    // pcf() spreads pairs over a grid of 10 / 2560, and takes areas of polygons from pixels, 128 along an axis.
    expect_near(curves.g_smooth, numbers.pcf, GetParam() ? 3e-4 : 4e-3, 1e-3, "pcf");
}

TEST_P(SpatstatTest, DistancesAreTheSame)
{
    const auto& [framed, numbers, points, covariance, distances] = at_hand;
    const double share = framed.area() / (box_of(framed.polygons()).width() * box_of(framed.polygons()).height());
    const RegionPlaces places(framed, static_cast<std::size_t>(std::round(share * test::spatstat_places)), 1);
    const DistanceCurves curves = region_distances(points, framed, places, distances.step, distances.count);
    expect_near(curves.g, numbers.nearest, 0, 1e-12, "G");
    expect_near(curves.g, numbers.gest, 0, 1e-12, "Gest");
    // A place more or less in the box moves all others: the sequence must have the same length.
    expect_near(curves.f, numbers.empty_space, 0, 1e-12, "F");
    // 5,000 places: a share's error is some 0.007 where places are random, and less in a sequence.
    expect_near(curves.f, numbers.fest, 0, 0.01, "Fest");
}

/// Points on opposite borders have vectors that leave nothing of the region in common with itself: of two copies of a
/// set, one on each border, only pairs of the same border count.
TEST(RegionPairs, OfOppositeBordersAreLeftOut)
{
    const FramedRegion strip({{{{{0, 0}, {100, 0}, {100, 1}, {0, 1}}}}}, "strip");
    const SetCovariance covariance(strip.boundary().edges());
    PointSet low{2, {}}, both{2, {}};
    for (const double x : {1.0, 1.3, 20.5, 20.6, 21.4, 60.0, 99.9}) {
        low.coordinates.insert(low.coordinates.end(), {x, 0});
        both.coordinates.insert(both.coordinates.end(), {x, 0, x, 1});
    }
    const PairDistances distances{.step = 0.02 / strip.side(), .count = 75, .half_width = 0.3 / strip.side()};
    const PairCurves of_low = region_pairs(strip.framed(low, "low"), strip, covariance, distances);
    const PairCurves of_both = region_pairs(strip.framed(both, "both"), strip, covariance, distances);
    const auto n = static_cast<double>(low.size());
    const auto scaled = [&](std::vector<double> values) {
        for (double& value : values) value *= (n - 1) / (2 * n - 1);
        return values;
    };
    EXPECT_GT(of_low.k_translation.back(), 0);
    expect_near(of_both.k_translation, scaled(of_low.k_translation), 1e-12, 0, "K, translation");
    expect_near(of_both.g_smooth, scaled(of_low.g_smooth), 1e-12, 0, "g");
    expect_near(of_both.g_of_bin, scaled(of_low.g_of_bin), 1e-12, 0, "g of bins");
}

INSTANTIATE_TEST_SUITE_P(Windows, SpatstatTest, testing::Bool(),
                         [](const auto& window) { return window.param ? "Rectangle" : "Polygon"; });

TEST(ProductLimit, IsTheShareWhereAllIsSeen)
{
    EXPECT_EQ(product_limit({{0.5, 9}, {1.5, 9}, {1.5, 9}, {7, 9}}, 1, 3), (std::vector<double>{0.25, 0.75, 0.75}));
    // One of three is lost at 1.2; one of the two that are left ends.
    EXPECT_EQ(product_limit({{1.5, 9}, {3, 1.2}, {5, 9}}, 1, 3), (std::vector<double>{0, 0.5, 0.5}));
}

std::shared_ptr<const FramedRegion> polygon()
{
    return std::make_shared<const FramedRegion>(test::spatstat_polygon, "polygon");
}

double l_of(double k) { return std::sqrt(k / std::numbers::pi); }

TEST(RegionCurves, OfRandomPointsAreThoseOfFormulas)
{
    constexpr std::size_t n = 300;
    constexpr std::uint32_t sets = 30;
    const auto region = polygon();
    const RandomInRegion random(*region, nullptr);
    RegionCurves curves(region, nullptr, n, 0);
    for (std::uint32_t k = 0; k < sets; ++k) curves.add(random.points(n, 1000 + k), "set");
    const double lambda = n / region->own_area();
    for (const RegionCurveRow& row : curves.rows()) {
        const double r = row.distance, expected = 1 - std::exp(-lambda * std::numbers::pi * r * r);
        // Five standard errors, that of K by the pairs: sqrt(2 / (n lambda K)) of it, and those of shares by their
        // numbers of points; places are more and depend on each other.
        const double pairs = std::sqrt(2 / (n * lambda * std::numbers::pi * r * r * sets)) + 0.01;
        EXPECT_NEAR(row.of(RegionFunction::k) / (std::numbers::pi * r * r), 1, 5 * pairs) << r;
        EXPECT_NEAR(l_of(row.k_isotropic) / r, 1, 5 * pairs) << r;
        const double share = 5 * std::sqrt(expected * (1 - expected) / (n * sets)) + 1.0 / (n * sets);
        if (expected > 0.99) continue; // few are seen so far
        EXPECT_NEAR(row.of(RegionFunction::nearest), expected, 2 * share) << r;
        EXPECT_NEAR(row.of(RegionFunction::empty_space), expected, 2 * share + 1e-3) << r;
    }
}

TEST(RegionCurves, EnvelopeHoldsRandomPointsAndNotDarts)
{
    const auto region = polygon();
    const std::size_t n = test::spatstat_points.size() / 2;
    RegionCurves darts(region, nullptr, n, 39);
    darts.add(region->framed({2, test::spatstat_points}, "points"), "points");
    RegionCurves random(region, nullptr, n, 39);
    random.add(RandomInRegion(*region, nullptr).points(n, 500), "points");
    std::size_t left = 0, rows = 0;
    for (const RegionCurveRow& row : random.rows()) {
        const auto k = static_cast<std::size_t>(RegionFunction::k);
        left += row.value[k] < row.low[k] || row.value[k] > row.high[k];
        ++rows;
    }
    EXPECT_LT(left, rows / 4);
    const RegionCurveRow at_min_distance =
        darts.rows()[static_cast<std::size_t>(1 / (darts.distances().step * region->side())) - 1];
    EXPECT_EQ(at_min_distance.of(RegionFunction::nearest), 0);
    EXPECT_LT(at_min_distance.of(RegionFunction::nearest), at_min_distance.low[2]);
    EXPECT_GT(at_min_distance.of(RegionFunction::j), at_min_distance.high[4]);
}

TEST(RegionCurves, DoNotDependOnThreadsAndParts)
{
    const auto region = polygon();
    const RandomInRegion random(*region, nullptr);
    const auto all = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        RegionCurves curves(region, nullptr, 300, 2), more(region, nullptr, 300, 2);
        curves.add(random.points(300, 0), "a");
        more.add(random.points(300, 1), "b");
        curves.append(more);
        std::vector<double> numbers;
        for (const RegionCurveRow& row : curves.rows())
            for (std::size_t f = 0; f + 1 < region_functions; ++f) // J may be no number
                numbers.insert(numbers.end(), {row.value[f], row.low[f], row.high[f], row.k_isotropic});
        return numbers;
    };
    EXPECT_EQ(all(1), all(4));
}

/// Density 1 left of the middle, 3 right of it.
std::shared_ptr<const RegionDensity> two_halves(const FramedRegion& region)
{
    return std::make_shared<const RegionDensity>(density_of_values(2, 1, {1, 3}, "halves"), region);
}

TEST(RegionCurves, WithTheirDensityRandomPointsAreThoseOfFormulas)
{
    constexpr std::size_t n = 300;
    constexpr std::uint32_t sets = 30;
    const auto region = polygon();
    const auto density = two_halves(*region);
    const RandomInRegion random(*region, density.get());
    RegionCurves with(region, density, n, 0), without(region, nullptr, n, 0);
    for (std::uint32_t k = 0; k < sets; ++k) {
        with.add(random.points(n, k), "set");
        without.add(random.points(n, k), "set");
    }
    const RegionCurveRow last = with.rows().back(), biased = without.rows().back();
    const double circle = std::numbers::pi * last.distance * last.distance;
    EXPECT_NEAR(last.of(RegionFunction::k) / circle, 1, 0.02);
    EXPECT_GT(biased.of(RegionFunction::k) / circle, 1.1);
    EXPECT_NEAR(last.k_isotropic / circle, 1, 0.02);
}

TEST(RegionDensity, RefusesPointsWhereItIsNothing)
{
    const auto region = polygon();
    const RegionDensity density(density_of_values(2, 1, {0, 1}, "right half"), *region);
    try {
        density.intensities(region->framed({2, {50, 20, 10, 20}}, "trees"), *region, "trees");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).substr(0, 15), "trees: point 2,");
    }
}

}
}
