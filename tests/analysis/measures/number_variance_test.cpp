// The number variance against counting by hand, the closed form of random points, and lattices.
#include "analysis/measures/number_variance.hpp"

#include "analysis/measures/torus_ball.hpp"
#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using namespace test;

std::vector<NumberVarianceBin> variance_of(const PointSet& points, bool is_window = false)
{
    NumberVarianceEstimate estimate(points.dimension, points.size(), is_window);
    estimate.add(points);
    return estimate.mean();
}

/// The points within a radius of a place, by the distances of all.
double counted(const PointSet& points, const std::vector<double>& centre, double radius, bool is_window)
{
    double count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double squared = 0;
        for (std::size_t k = 0; k < centre.size(); ++k) {
            const double direct = std::abs(points[i][k] - centre[k]);
            const double along = is_window ? direct : std::min(direct, 1 - direct);
            squared += along * along;
        }
        count += squared < radius * radius;
    }
    return count;
}

/// The mean square deviation over the estimate's places.
double variance_by_hand(const PointSet& points, const NumberVarianceBin& bin, bool is_window)
{
    const StreamKey key = stream_key(0, Purpose::variance_windows, 0);
    const auto centres = static_cast<std::uint32_t>(std::min<std::size_t>(10'000, 4 * points.size()));
    const double margin = is_window ? bin.radius : 0;
    double sum = 0, squares = 0;
    for (std::uint32_t i = 0; i < centres; ++i) {
        const auto words = philox({i, 0, 0, 0}, key);
        std::vector<double> centre;
        for (std::size_t k = 0; k < static_cast<std::size_t>(points.dimension); ++k)
            centre.push_back(margin + (1 - 2 * margin) * words[k] * 0x1p-32);
        const double count = counted(points, centre, bin.radius, is_window);
        sum += count, squares += count * count;
    }
    if (is_window) return (squares - sum * sum / centres) / (centres - 1);
    return squares / centres - 2 * bin.points * sum / centres + bin.points * bin.points;
}

void expect_counts_by_hand(const PointSet& points, bool is_window)
{
    for (const auto& bin : variance_of(points, is_window))
        ASSERT_NEAR(bin.variance, variance_by_hand(points, bin, is_window), 1e-8 * bin.points * bin.points)
            << points.dimension << " " << points.size() << " " << is_window << " " << bin.radius;
}

TEST(NumberVariance, IsThatOfCountsByHand)
{
    std::mt19937_64 random(1);
    for (const int dimension : {2, 3})
        for (const std::size_t n : {64u, 300u})
            for (const bool is_window : {false, true})
                expect_counts_by_hand(random_points_with_borders(n, dimension, random), is_window);
    // The largest balls on the torus hold so many points that they are counted by rows of cells.
    expect_counts_by_hand(random_points_with_borders(1300, 2, random), false);
}

TEST(NumberVariance, OfRandomPointsIsThatOfABinomialVariable)
{
    std::mt19937_64 random(2);
    for (const int dimension : {2, 3}) {
        NumberVarianceEstimate estimate(dimension, 2000);
        for (int k = 0; k < 40; ++k) estimate.add(random_points(2000, dimension, random));
        const auto bins = estimate.mean();
        ASSERT_EQ(bins.size(), 24u);
        EXPECT_NEAR(bins.front().radius, 0.5 * std::pow(2000, -1.0 / dimension), 1e-15);
        EXPECT_EQ(bins.back().radius, 0.25);
        for (const auto& bin : bins) {
            const double volume = torus_ball_volume(bin.radius, dimension);
            EXPECT_NEAR(bin.points, 2000 * volume, 1e-9);
            EXPECT_LT(std::abs(bin.variance - 2000 * volume * (1 - volume)), z_bound(48) * bin.standard_error)
                << dimension << " " << bin.radius;
        }
    }
}

TEST(NumberVariance, OfALatticeIsThatOfOneCell)
{
    // The variance is taken over places on a fine grid in one cell of the lattice; 10,000 random places know it within
    // four standard errors of a mean of squares.
    constexpr int m = 24, grid = 60;
    const PointSet lattice = square_lattice(m, 2);
    for (const auto& bin : variance_of(lattice)) {
        double squares = 0, fourths = 0, places = 0;
        for (int y = 0; y < grid; ++y)
            for (int x = 0; x < grid; ++x) {
                const double place_x = (x + 0.5) / grid, place_y = (y + 0.5) / grid;
                const double reach = bin.radius * m;
                double count = 0;
                for (int row = -static_cast<int>(reach) - 2; row <= reach + 2; ++row) {
                    const double across = row - place_y, squared = reach * reach - across * across;
                    if (squared < 0) continue;
                    count += std::ceil(place_x + std::sqrt(squared)) - 1 - std::floor(place_x - std::sqrt(squared));
                }
                const double deviation = count - bin.points;
                squares += deviation * deviation, fourths += std::pow(deviation, 4), ++places;
            }
        const double variance = squares / places;
        const double error = std::sqrt((fourths / places - variance * variance) * (1 / places + 1 / (4.0 * m * m)));
        EXPECT_LT(std::abs(bin.variance - variance), z_bound(24) * error) << bin.radius;
        if (bin.radius * m < 0.5) {
            EXPECT_NEAR(variance, bin.points * (1 - bin.points), 0.01);
        }
    }
}

TEST(NumberVariance, AppendsAsItAdds)
{
    std::mt19937_64 random(3);
    NumberVarianceEstimate all(2, 100), begin(2, 100), end(2, 100);
    for (int k = 0; k < 4; ++k) {
        const PointSet points = random_points(100, 2, random);
        all.add(points);
        (k < 2 ? begin : end).add(points);
    }
    begin.append(end);
    ASSERT_EQ(begin.mean().size(), all.mean().size());
    for (std::size_t i = 0; i < all.mean().size(); ++i) {
        EXPECT_EQ(begin.mean()[i].variance, all.mean()[i].variance);
        EXPECT_EQ(begin.mean()[i].standard_error, all.mean()[i].standard_error);
        EXPECT_GT(all.mean()[i].standard_error, 0);
    }
}

TEST(NumberVariance, IsNotOfAFewPoints)
{
    std::mt19937_64 random(4);
    EXPECT_TRUE(variance_of(random_points(15, 2, random)).empty());
    EXPECT_TRUE(variance_of(random_points(63, 3, random)).empty());
    EXPECT_EQ(variance_of(random_points(16, 2, random)).size(), 24u);
    EXPECT_THROW(NumberVarianceEstimate(4, 100), InputError);
    NumberVarianceEstimate plane(2, 100);
    EXPECT_THROW(plane.add(random_points(100, 3, random)), InputError);
}

}
}
