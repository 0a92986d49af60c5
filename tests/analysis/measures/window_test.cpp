// Measures of sets that are windows of the plane or of space: nothing goes across their borders.
#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "analysis/measures/torus_ball.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

TEST(MinDistanceInWindow, DoesNotGoAcrossABorder)
{
    EXPECT_EQ(min_distance_in_window({2, {0.0, 0.0, 0.75, 0.0}}), 0.75);
    EXPECT_EQ(min_distance_in_window({3, {0.0, 0.0, 0.0, 0.75, 0.0, 1.0}}), 1.25);
    EXPECT_EQ(min_distance_in_window({2, {0.5, 0.5}}), std::numeric_limits<double>::infinity());
}

TEST(MinDistanceInWindow, IsThatOfAllPairs)
{
    std::mt19937_64 random(4);
    for (const int dimension : {2, 3}) {
        const PointSet points = test::random_points(300, dimension, random);
        double squared = 4;
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                double sum = 0;
                for (std::size_t k = 0; k < points[i].size(); ++k)
                    sum += (points[i][k] - points[j][k]) * (points[i][k] - points[j][k]);
                squared = std::min(squared, sum);
            }
        EXPECT_NEAR(min_distance_in_window(points), std::sqrt(squared), 1e-15);
    }
}

TEST(WindowPairVolume, IsTheShareOfPairsThatAreNearer)
{
    std::mt19937_64 random(5);
    for (const int dimension : {2, 3}) {
        constexpr std::size_t pairs = 200'000;
        const PointSet points = test::random_points(2 * pairs, dimension, random);
        for (const double distance : {0.1, 0.5, 1.0}) {
            std::size_t nearer = 0;
            for (std::size_t i = 0; i < pairs; ++i) {
                double sum = 0;
                for (std::size_t k = 0; k < points[i].size(); ++k)
                    sum += std::pow(points[2 * i][k] - points[2 * i + 1][k], 2);
                nearer += std::sqrt(sum) < distance;
            }
            const double share = window_pair_volume(distance, dimension);
            const double error = std::sqrt(share * (1 - share) / static_cast<double>(pairs));
            EXPECT_NEAR(static_cast<double>(nearer) / static_cast<double>(pairs), share, 4.5 * error)
                << dimension << "D, " << distance;
        }
    }
    // Both forms hold up to distance 1 of the square; half of its pairs are nearer than 0.5120 (the median distance).
    EXPECT_NEAR(window_pair_volume(0.512003, 2), 0.5, 1e-5);
}

TEST(PairCorrelationOfWindows, IsOneForRandomPoints)
{
    std::mt19937_64 random(6);
    PairCorrelationEstimate estimate(2, 0.5, 20, true);
    constexpr int sets = 60;
    for (int i = 0; i < sets; ++i) estimate.add(test::random_points(300, 2, random));
    for (const PairCorrelationBin& bin : estimate.mean()) EXPECT_NEAR(bin.value, 1, 4.5 * bin.standard_error);
}

TEST(PairCorrelationOfWindows, HasNoPairAcrossABorder)
{
    PairCorrelationEstimate open(2, 0.5, 5, true), torus(2, 0.5, 5);
    const PointSet points{2, {0.01, 0.5, 0.99, 0.5}};
    open.add(points);
    torus.add(points);
    for (const PairCorrelationBin& bin : open.mean()) EXPECT_EQ(bin.pairs, 0);
    EXPECT_EQ(torus.mean().front().pairs, 1);
}

}
}
