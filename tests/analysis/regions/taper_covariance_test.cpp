// The covariance of rings by tapers, against sums over sine tapers by numpy and against the spread of random points.
#include "analysis/regions/taper_covariance.hpp"

#include "analysis/regions/random_in_region.hpp"
#include "base/regions/region_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

FramedRegion framed(const char* text) { return {read_region(text), "region"}; }

/// Sums over sine tapers with transforms in closed form, and over rings of whole frequencies, by numpy. Those of the
/// grid differ by their squares of 1/128: (pi / 128)^2 of the highest, which has three half waves, is 0.5 %, in the
/// powers of few.
TEST(TaperCovariance, OfASquareIsThatOfNumpy)
{
    const RegionTapers tapers(framed("rectangle 0 0 7 7"), 8);
    const TaperCovariance covariance(tapers);
    EXPECT_NEAR(covariance.at(0, 0), 0.125, 1e-12);
    EXPECT_NEAR(covariance.at(1, 0), 0.08527832974, 1e-4);
    EXPECT_NEAR(covariance.at(0, -1), 0.08527832974, 1e-4);
    EXPECT_NEAR(covariance.at(1, -1), 0.06438356961, 1e-4);
    EXPECT_NEAR(covariance.at(-2, 0), 0.04368175895, 1e-4);
    EXPECT_NEAR(covariance.at(0, 3), 0.01145412067, 1e-4);
    EXPECT_EQ(covariance.at(covariance.reach() + 1, 0), 0);
    const RingCovariance rings = covariance.of_rings(256, 1);
    ASSERT_EQ(rings.rings(), 127);
    const std::map<std::pair<std::size_t, std::size_t>, double> numpy{
        {{1, 1}, 0.12576490},   {{2, 2}, 0.06374210},  {{3, 3}, 0.04377403},   {{8, 8}, 0.01580627},
        {{8, 9}, 0.01077520},   {{8, 10}, 0.00482935}, {{20, 20}, 0.00641430}, {{20, 21}, 0.00457219},
        {{21, 20}, 0.00457219}, {{40, 40}, 0.00316347}};
    for (const auto& [pair, value] : numpy)
        EXPECT_NEAR(rings.of(pair.first - 1, pair.second - 1), value, 5e-3 * value) << pair.first << ' ' << pair.second;
    EXPECT_EQ(rings.of(3, 100), 0);
    // Beyond what is summed, the level of rings 60 to 99 by numpy, 0.3968 of the variance of 2 / samples, which differs
    // by 0.014 from ring to ring.
    EXPECT_NEAR(rings.of(109, 109), 0.3968 / (3.14159265 * 110), 0.015 / (3.14159265 * 110));
}

TEST(TaperCovariance, OfWideRingsIsThatOfTheirSums)
{
    const RegionTapers tapers(framed("rectangle 0 0 4 1"), 4);
    const TaperCovariance covariance(tapers);
    const RingCovariance single = covariance.of_rings(64, 1), wide = covariance.of_rings(64, 3);
    // Ring 2 of three has rings 4, 5 and 6 of one, by their frequencies.
    const auto frequencies = [](int ring) {
        int count = 0;
        for (int v = -ring - 1; v <= ring + 1; ++v)
            for (int u = -ring - 1; u <= ring + 1; ++u) count += std::lround(std::hypot(u, v)) == ring;
        return static_cast<double>(count);
    };
    double sum = 0, all = 0;
    for (int a = 4; a <= 6; ++a) {
        all += frequencies(a);
        for (int b = 4; b <= 6; ++b)
            sum += frequencies(a) * frequencies(b) *
                   single.of(static_cast<std::size_t>(a - 1), static_cast<std::size_t>(b - 1));
    }
    EXPECT_NEAR(wide.of(1, 1), sum / (all * all), 1e-9 * wide.of(1, 1));
}

TEST(RingCovariance, GivesTheErrorsOfLinearStatistics)
{
    const RingCovariance covariance({{0.04, 0.01}, {0.09, -0.02}, {0.01}});
    const std::vector<double> power{1, 2, 4};
    const std::vector<double> errors = covariance.errors(power);
    EXPECT_NEAR(errors[1], 0.6, 1e-14);
    // (3 p0 - p1 + p2): 9 0.04 + 4 0.09 + 16 0.01 - 2 3 2 0.01 - 2 2 4 (-0.02) = 1.08
    EXPECT_NEAR(covariance.error_of(power, [](const auto& p) { return 3 * p[0] - p[1] + p[2]; }), std::sqrt(1.08),
                1e-12);
    EXPECT_EQ(covariance.error_of(power, [](const auto&) { return 2.0; }), 0);
}

/// The errors of one set agree with the spread over random sets: in rings they are 0.87 to 1 of it, because the powers
/// of a few points are slightly more correlated than chance says. With more points the difference is smaller.
void expect_spread(const std::shared_ptr<const FramedRegion>& region, std::size_t n)
{
    constexpr std::size_t count = 6, sets = 300;
    const auto tapers = std::make_shared<const RegionTapers>(*region, count);
    const RandomInRegion random(*region, nullptr);
    TaperedPeriodogram periodogram(region, tapers, 64, false);
    std::vector<std::vector<double>> curves;
    for (std::uint32_t set = 0; set < sets; ++set) {
        std::vector<double> mean;
        for (std::size_t k = 0; k < count; ++k) {
            HalfSpectrum power;
            periodogram.compute(random.points(n, set), k, power);
            const std::vector<double> curve = radial_means(power);
            mean.resize(curve.size());
            for (std::size_t b = 0; b < curve.size(); ++b) mean[b] += curve[b] / count;
        }
        curves.push_back(mean);
    }
    const RingCovariance covariance = TaperCovariance(*tapers).of_rings(64, 1);
    ASSERT_EQ(covariance.rings(), curves.front().size());
    for (const std::size_t from : {2, 8, 16}) {
        double ratio = 0;
        for (std::size_t b = from; b < from + 8; ++b) {
            double sum = 0, squares = 0;
            for (const auto& curve : curves) sum += curve[b], squares += curve[b] * curve[b];
            const double mean = sum / sets, variance = (squares - sets * mean * mean) / (sets - 1);
            ratio += covariance.of(b, b) * mean * mean / variance / 8;
        }
        // A variance of 300 values is known to 8 %, those of rings beside each other have much in common.
        EXPECT_GT(std::sqrt(ratio), 0.8) << from;
        EXPECT_LT(std::sqrt(ratio), 1.25) << from;
    }
}

TEST(TaperCovariance, IsTheSpreadOfRandomSets)
{
    expect_spread(std::make_shared<const FramedRegion>(framed("POLYGON ((0 0, 3 0, 3 1, 1 1, 1 3, 0 3, 0 0))")), 200);
}

/// In a strip products of tapers reach almost 50 frequencies along each axis, farther than direct sums go.
TEST(TaperCovariance, IsTheSpreadOfRandomSetsInAStrip)
{
    expect_spread(std::make_shared<const FramedRegion>(framed("POLYGON ((0 0, 240 320, 239.2 320.6, -0.8 0.6, 0 0))")),
                  2000);
}

}
}
