#include "analysis/measures/pair_correlation.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/torus_ball.hpp"
#include "base/errors/errors.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/set_features.hpp"
#include "tests/support/textbook_dart_throwing.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace poissonlab {
namespace {

using namespace test;

std::vector<PairCorrelationBin> pair_correlation(const PointSet& points, double end, std::size_t bins)
{
    PairCorrelationEstimate estimate(points.dimension, end, bins);
    estimate.add(points);
    return estimate.mean();
}

TEST(PairCorrelation, CountsEveryPairAsAllPairsDo)
{
    std::mt19937_64 random(1);
    for (const int d : {2, 3}) {
        for (const std::size_t n : {2, 3, 17, 300, 1500}) {
            for (const double end : {0.02, 0.11, 0.3, largest_toroidal_distance(d)}) {
                const PointSet points = random_points(n, d, random);
                const auto expected = pairs_by_distance(points, 0, end, 37);
                const auto bins = pair_correlation(points, end, 37);
                ASSERT_EQ(bins.size(), 37u);
                // A pair may change its bin by rounding, with a chance of some 1e-10 here.
                for (std::size_t k = 0; k < 37; ++k) EXPECT_EQ(bins[k].pairs, expected[k]) << n << " " << end;
            }
        }
    }
}

TEST(PairCorrelation, OfClustersCountsEveryPairAsWell)
{
    std::mt19937_64 random(2);
    for (const int d : {2, 3}) {
        const PointSet points = clustered_points(800, d, 3, 0.05, random);
        const auto expected = pairs_by_distance(points, 0, 0.2, 20);
        const auto bins = pair_correlation(points, 0.2, 20);
        for (std::size_t k = 0; k < 20; ++k) EXPECT_EQ(bins[k].pairs, expected[k]);
    }
}

TEST(PairCorrelation, OfIndependentPointsIsOneUpToTheLargestDistance)
{
    // g is without bias for uniform points, at distances where balls overlap themselves too.
    std::mt19937_64 random(3);
    for (const int d : {2, 3}) {
        constexpr std::size_t count = 30;
        PairCorrelationEstimate estimate(d, largest_toroidal_distance(d), count);
        for (int i = 0; i < 40; ++i) estimate.add(random_points(400, d, random));
        for (const PairCorrelationBin& bin : estimate.mean()) {
            // Pairs are Poisson distributed: a known standard error, better than one from 40 sets. The last
            // bins hold few pairs, and a normal law holds for more than some 100 in all only.
            const double inner = bin.distance - 0.5 * largest_toroidal_distance(d) / count;
            const double outer = bin.distance + 0.5 * largest_toroidal_distance(d) / count;
            const double shell = torus_ball_volume(outer, d) - torus_ball_volume(inner, d);
            const double expected_pairs = 40 * 400 * 399 / 2.0 * shell;
            if (expected_pairs < 100) continue;
            EXPECT_NEAR(bin.value, 1, z_bound(2 * count) / std::sqrt(expected_pairs)) << bin.distance;
        }
    }
}

TEST(PairCorrelation, IsZeroBelowTheMinimumDistance)
{
    const double min_distance = 0.02;
    const PointSet points = textbook_dart_throwing(1000, min_distance, 4);
    const auto bins = pair_correlation(points, 0.1, 50); // 10 bins below
    for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(bins[k].value, 0);
    EXPECT_GT(bins[10].value, 1);
}

TEST(PairCorrelation, OfALatticeHasItsShells)
{
    // 20 x 20: 4 neighbours at 0.05, 4 at 0.0707, 4 at 0.1, 8 at 0.1118. Bins of 0.012 hold no edge there.
    const auto bins = pair_correlation(square_lattice(20, 2), 0.12, 10);
    const std::vector<double> neighbours{0, 0, 0, 0, 4, 4, 0, 0, 4, 8};
    for (std::size_t k = 0; k < 10; ++k) {
        const double w = 0.012, inner = static_cast<double>(k) * w;
        const double ring = std::numbers::pi * (2 * inner + w) * w;
        EXPECT_EQ(bins[k].pairs, 200 * neighbours[k]);
        EXPECT_NEAR(bins[k].value, neighbours[k] / (399 * ring), 1e-12);
    }
}

TEST(PairCorrelation, HasTheStandardErrorOfItsSets)
{
    const PointSet one{2, {0.1, 0.1, 0.15, 0.1}}, none{2, {0.1, 0.1, 0.6, 0.1}};
    PairCorrelationEstimate estimate(2, 0.1, 1);
    estimate.add(one);
    EXPECT_EQ(estimate.mean()[0].standard_error, 0);
    estimate.add(none);
    // Values a = 1 / (pi 0.1^2) and 0: mean a/2, sample deviation a / sqrt 2, standard error a / 2.
    const double a = 1 / (std::numbers::pi * 0.01);
    EXPECT_NEAR(estimate.mean()[0].value, a / 2, 1e-13 * a);
    EXPECT_NEAR(estimate.mean()[0].standard_error, a / 2, 1e-13 * a);
    EXPECT_EQ(estimate.mean()[0].pairs, 0.5);
}

TEST(PairCorrelation, DoesNotDependOnTheNumberOfThreads)
{
    std::mt19937_64 random(5);
    const PointSet points = random_points(5000, 2, random);
    const auto several = pair_correlation(points, 0.1, 64);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    const auto one = pair_correlation(points, 0.1, 64);
    for (std::size_t k = 0; k < 64; ++k) EXPECT_EQ(several[k].value, one[k].value);
}

TEST(PairCorrelation, RejectsWhatHasNoMeaning)
{
    EXPECT_THROW(PairCorrelationEstimate(4, 0.1, 10), InputError);
    EXPECT_THROW(PairCorrelationEstimate(2, 0.0, 10), InputError);
    EXPECT_THROW(PairCorrelationEstimate(2, 0.71, 10), InputError);
    EXPECT_THROW(PairCorrelationEstimate(3, std::nan(""), 10), InputError);
    EXPECT_THROW(PairCorrelationEstimate(2, 0.1, 0), InputError);
    PairCorrelationEstimate estimate(2, 0.1, 10);
    EXPECT_TRUE(estimate.mean().empty());
    EXPECT_THROW(estimate.add({2, {}}), InputError);
    EXPECT_THROW(estimate.add({2, {0.5, 0.5}}), InputError);
    EXPECT_THROW(estimate.add({3, {0.5, 0.5, 0.5, 0.1, 0.1, 0.1}}), InputError);
}

}
}
