// Distances, pair correlation and number variance in periodic rectangles and boxes, against sums over all pairs.
#include "analysis/borders/border_pairs.hpp"
#include "analysis/measures/ball_counter.hpp"
#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/number_variance.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "tests/support/periodic_boxes.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace poissonlab {
namespace {

using namespace test;

TEST(PeriodicBox, HasSidesOfProduct1InTheirProportion)
{
    for (const auto& sides : sides_of_boxes()) {
        const PeriodicBox box = periodic_box(sides);
        EXPECT_NEAR(box.sides[0] * box.sides[1] * box.sides[2], 1, 1e-14);
        for (std::size_t k = 0; k < sides.size(); ++k)
            EXPECT_NEAR(box.sides[k] / box.sides[0], sides[k] / sides[0], 1e-14 * sides[k] / sides[0]);
    }
    EXPECT_TRUE(periodic_box(std::vector<double>{3, 3, 3}).is_unit());
    EXPECT_TRUE(periodic_box({}).is_unit());
    EXPECT_NEAR(root_of_volume(std::vector<double>{1e300, 1e300, 8e300}), 2e300, 1e287);
}

TEST(BoxDistances, AreThoseOfAllPairs)
{
    std::mt19937_64 random(1);
    // In narrow boxes few points may all be farther apart than in the densest packing.
    std::vector<std::vector<double>> boxes = sides_of_boxes();
    boxes.insert(boxes.end(), {{1, 100}, {100, 1, 1}, {1, 100, 100}});
    for (const auto& sides : boxes)
        for (const std::size_t n : {2u, 2u, 2u, 3u, 3u, 5u, 5u, 10u, 300u}) {
            const PeriodicBox box = periodic_box(sides);
            const PointSet points = random_points(n, static_cast<int>(sides.size()), random);
            double least = std::numeric_limits<double>::infinity(), sum = 0;
            for (std::size_t i = 0; i < n; ++i) {
                double nearest = std::numeric_limits<double>::infinity();
                for (std::size_t j = 0; j < n; ++j)
                    if (j != i) nearest = std::min(nearest, distance_in(box, points, i, j));
                least = std::min(least, nearest);
                sum += nearest;
            }
            EXPECT_NEAR(min_toroidal_distance(points, box), least, 1e-14 * least);
            EXPECT_NEAR(mean_nearest_distance(points, box), sum / static_cast<double>(n), 1e-13 * sum);
        }
}

TEST(BoxDistances, OfAStretchedSquareLatticeAreItsSpacing)
{
    constexpr int n = 20;
    PointSet points{2, {}};
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < 2 * n; ++x)
            points.coordinates.insert(points.coordinates.end(), {x / (2.0 * n), y / (1.0 * n)});
    const PeriodicBox box = periodic_box(std::vector<double>{2, 1});
    const double spacing = 1 / std::sqrt(2.0 * n * n);
    EXPECT_NEAR(min_toroidal_distance(points, box), spacing, 1e-15);
    EXPECT_NEAR(mean_nearest_distance(points, box), spacing, 1e-15);
    // Relative radius of the square lattice.
    EXPECT_NEAR(relative_radius(min_toroidal_distance(points, box), points.size(), 2), std::sqrt(std::sqrt(3) / 2),
                1e-12);
}

TEST(BoxPairCorrelation, CountsAllPairs)
{
    std::mt19937_64 random(2);
    for (const auto& sides : sides_of_boxes())
        for (const std::size_t n : {40u, 2'000u}) {
            const PeriodicBox box = periodic_box(sides);
            const int dimension = static_cast<int>(sides.size());
            const PointSet points = random_points(n, dimension, random);
            const double end = std::min(box.shortest() / 2, 4 * max_min_distance(n, dimension));
            constexpr std::size_t bins = 37;
            PairCorrelationEstimate estimate(dimension, end, bins, false, box);
            estimate.add(points);
            std::vector<double> pairs(bins);
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < i; ++j)
                    if (const double bin = distance_in(box, points, i, j) / end * bins; bin < bins)
                        ++pairs[static_cast<std::size_t>(bin)];
            const auto mean = estimate.mean();
            for (std::size_t k = 0; k < bins; ++k) EXPECT_EQ(mean[k].pairs, pairs[k]) << n << " points, bin " << k;
        }
}

TEST(BoxPairCorrelation, OfRandomPointsIs1)
{
    std::mt19937_64 random(3);
    for (const auto& sides : sides_of_boxes()) {
        const PeriodicBox box = periodic_box(sides);
        PairCorrelationEstimate estimate(static_cast<int>(sides.size()), box.shortest() / 2, 8, false, box);
        for (int set = 0; set < 30; ++set) estimate.add(random_points(500, static_cast<int>(sides.size()), random));
        for (const PairCorrelationBin& bin : estimate.mean())
            EXPECT_NEAR(bin.value, 1, 5 / std::sqrt(std::max(bin.pairs * 30, 1.0))) << bin.distance;
    }
}

TEST(BoxPairCorrelation, EndsAtHalfOfTheShortestSide)
{
    const PeriodicBox box = periodic_box(std::vector<double>{4, 1});
    EXPECT_NO_THROW(PairCorrelationEstimate(2, 0.25, 10, false, box));
    EXPECT_THROW(PairCorrelationEstimate(2, 0.26, 10, false, box), InputError);
}

TEST(BoxMeasures, OfTwoCopiesAreThoseOfTheSquare)
{
    std::mt19937_64 random(4);
    for (const int dimension : {2, 3}) {
        const PointSet one = random_points(3'000, dimension, random), both = two_copies(one);
        const PeriodicBox box = periodic_box(dimension == 2 ? std::vector<double>{2, 1} : std::vector<double>{2, 1, 1});
        const double unit = std::pow(2, 1.0 / dimension); // of the box's lengths, in those of the square
        EXPECT_NEAR(min_toroidal_distance(both, box) * unit, min_toroidal_distance(one), 1e-14);
        EXPECT_NEAR(mean_nearest_distance(both, box) * unit, mean_nearest_distance(one), 1e-14);

        PairCorrelationEstimate square(dimension, 0.25, 20), rectangle(dimension, 0.25 / unit, 20, false, box);
        square.add(one), rectangle.add(both);
        const auto g = square.mean(), of_both = rectangle.mean();
        for (std::size_t k = 0; k < g.size(); ++k) {
            EXPECT_NEAR(of_both[k].pairs, 2 * g[k].pairs, 2); // rounding at the ends of bins
            EXPECT_NEAR(of_both[k].value, g[k].value, 1e-3 + 4 / std::max(g[k].pairs, 1.0));
        }

        NumberVarianceEstimate of_square(dimension, one.size()), of_rectangle(dimension, both.size(), false, box);
        of_square.add(one), of_rectangle.add(both);
        const auto variance = of_square.mean(), variance_of_both = of_rectangle.mean();
        ASSERT_EQ(variance.size(), variance_of_both.size());
        for (std::size_t r = 0; r < variance.size(); ++r) {
            EXPECT_NEAR(variance_of_both[r].radius * unit, variance[r].radius, 1e-14);
            EXPECT_NEAR(variance_of_both[r].points, variance[r].points, 1e-9);
            // Balls have other centres, 10,000 each.
            EXPECT_NEAR(variance_of_both[r].variance, variance[r].variance, 0.1 * variance[r].variance);
        }
    }
}

template <int D>
void expect_counts_of_all_points(const std::vector<double>& sides, std::mt19937_64& random)
{
    const PeriodicBox box = periodic_box(sides);
    PointSet points = random_points(500, D, random);
    const BallCounter<D> counter(points, box);
    points.coordinates.resize(501 * D); // the last one is the centre of a ball
    for (int ball = 0; ball < 200; ++ball) {
        std::array<double, D> centre;
        for (int k = 0; k < D; ++k) points.coordinates[500 * D + k] = centre[k] = uniform(random);
        const double radius = box.shortest() / 4 * uniform(random);
        int expected = 0;
        for (std::size_t i = 0; i < 500; ++i) expected += distance_in(box, points, i, 500) < radius;
        EXPECT_EQ(counter.count(counter.stretched(centre), radius), expected);
        std::array<std::int64_t, 1> in_shell{};
        counter.add_to_shells(counter.stretched(centre), BallShells({radius}, 500, D), in_shell);
        EXPECT_EQ(in_shell[0], expected);
    }
}

TEST(BoxNumberVariance, CountsPointsInBalls)
{
    std::mt19937_64 random(5);
    for (const auto& sides : sides_of_boxes())
        sides.size() == 2 ? expect_counts_of_all_points<2>(sides, random)
                          : expect_counts_of_all_points<3>(sides, random);
}

TEST(BoxNumberVariance, OfRandomPointsIsThatOfIndependentOnes)
{
    std::mt19937_64 random(6);
    for (const auto& sides : sides_of_boxes()) {
        const int dimension = static_cast<int>(sides.size());
        NumberVarianceEstimate estimate(dimension, 500, false, periodic_box(sides));
        for (int set = 0; set < 20; ++set) estimate.add(random_points(500, dimension, random));
        const auto bins = estimate.mean();
        ASSERT_FALSE(bins.empty());
        for (const NumberVarianceBin& bin : bins) {
            const double share = bin.points / 500;
            EXPECT_NEAR(bin.variance, bin.points * (1 - share), 5 * bin.standard_error) << bin.radius;
        }
    }
    EXPECT_TRUE(NumberVarianceEstimate(2, 100, false, periodic_box(std::vector<double>{90, 1})).mean().empty());
}

TEST(BoxBorder, PairsAcrossItAreCloserInTheBoxsLengths)
{
    // Of 2 x 1: the pair across the left border is 0.04 apart, that across the lower one 0.03, that inside 0.1.
    const PointSet points{2, {0.01, 0.5, 0.99, 0.5, 0.5, 0.01, 0.5, 0.98, 0.3, 0.5, 0.35, 0.5}};
    const PeriodicBox box = periodic_box(std::vector<double>{2, 1});
    const double unit = std::sqrt(2), inside = min_distance_in_window(points, box);
    EXPECT_NEAR(inside * unit, 0.1, 1e-14);
    EXPECT_NEAR(min_toroidal_distance(points, box) * unit, 0.03, 1e-14);
    EXPECT_EQ(closer_pairs_across(points, inside, box), 2u);
    EXPECT_GT(chance_of_pairs_across(5, 1, 10'000, 2, 0, box), chance_of_pairs_across(5, 1, 10'000, 2));
}

}
}
