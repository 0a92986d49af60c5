// The largest empty circle around centres in a tile against the same by looking everywhere.
#include "tiles/poisson/proof/closure_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

std::vector<UnitPosition> random_positions(int dimension, std::size_t count, std::mt19937& random)
{
    std::uniform_int_distribution<std::int32_t> coordinate(-tile_units / 4, tile_units + tile_units / 4);
    std::vector<UnitPosition> points(count);
    for (UnitPosition& p : points)
        for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) p[k] = coordinate(random);
    return points;
}

/// The largest distance to the nearest point of a grid of places, which is at most `error` too small.
double looked_up(const std::vector<UnitPosition>& points, int dimension, int steps, double& error)
{
    double largest = 0;
    const double step = static_cast<double>(tile_units) / steps;
    for (int k = 0; k < (dimension == 3 ? steps : 1); ++k) {
        for (int j = 0; j < steps; ++j) {
            for (int i = 0; i < steps; ++i) {
                double nearest = HUGE_VAL;
                for (const UnitPosition& p : points) {
                    const double x = p[0] - (i + 0.5) * step;
                    const double y = p[1] - (j + 0.5) * step;
                    const double z = dimension == 3 ? p[2] - (k + 0.5) * step : 0;
                    nearest = std::min(nearest, x * x + y * y + z * z);
                }
                largest = std::max(largest, nearest);
            }
        }
    }
    error = step / 2 * std::sqrt(dimension);
    return std::sqrt(largest);
}

void expect_found(int dimension, std::size_t count, int steps, std::mt19937& random)
{
    const std::vector<UnitPosition> points = random_positions(dimension, count, random);
    double error = 0;
    const double lower = looked_up(points, dimension, steps, error);
    const double found = EmptyBallSearch(dimension).radius(points, 0);
    EXPECT_GE(found * (1 + EmptyBallSearch::tolerance), lower);
    EXPECT_LE(found, lower + error);
}

/// Centres outside of the polygon do not count, and those beyond the square do: an L that reaches out of the tile,
/// whose inside is known.
TEST(EmptyBall, InAPolygonHasItsCentreThere)
{
    constexpr std::int32_t u = tile_units;
    const std::vector<UnitPosition> polygon{{-u / 4, 0, 0},    {u, 0, 0},     {u, u / 2, 0},
                                            {u / 2, u / 2, 0}, {u / 2, u, 0}, {-u / 4, u, 0}};
    const auto is_inside = [](double x, double y) {
        return x >= -u / 4 && x <= u && y >= 0 && y <= (x <= u / 2 ? u : u / 2);
    };
    std::mt19937 random(2);
    for (const std::size_t count : {1, 3, 10, 40}) {
        const std::vector<UnitPosition> points = random_positions(2, count, random);
        double lower = 0;
        constexpr double step = u / 200.0;
        for (double x = -u / 4 + step / 2; x < u; x += step)
            for (double y = step / 2; y < u; y += step) {
                if (!is_inside(x, y)) continue;
                double nearest = HUGE_VAL;
                for (const UnitPosition& p : points) nearest = std::min(nearest, std::hypot(p[0] - x, p[1] - y));
                lower = std::max(lower, nearest);
            }
        const double found = EmptyBallSearch(2).radius_in(polygon, points, 0);
        EXPECT_GE(found * (1 + EmptyBallSearch::tolerance), lower);
        EXPECT_LE(found, lower + step * std::sqrt(0.5));
    }
}

TEST(EmptyBall, IsFoundWithinTheTolerance)
{
    std::mt19937 random(1);
    for (const std::size_t count : {1, 2, 5, 20, 100}) {
        for (int i = 0; i < 5; ++i) expect_found(2, count, 200, random);
        for (int i = 0; i < 2; ++i) expect_found(3, count, 30, random);
    }
}

TEST(EmptyBall, IsThatOfPointsInTheCorners)
{
    constexpr std::int32_t u = tile_units;
    const double half = u / 2.0;
    EXPECT_NEAR(EmptyBallSearch(2).radius(std::vector<UnitPosition>{{0, 0, 0}, {u, 0, 0}, {0, u, 0}, {u, u, 0}}, 0),
                half * std::sqrt(2), 1e-9);
    EXPECT_NEAR(EmptyBallSearch(2).radius(std::vector<UnitPosition>{{u / 2, u / 2, 0}}, 0), half * std::sqrt(2),
                half * std::sqrt(2) * EmptyBallSearch::tolerance);
    EXPECT_NEAR(EmptyBallSearch(3).radius(std::vector<UnitPosition>{{u / 2, u / 2, u / 2}}, 0), half * std::sqrt(3),
                half * std::sqrt(3) * EmptyBallSearch::tolerance);
}

TEST(EmptyBall, IsAtLeastWhatIsKnown)
{
    std::mt19937 random(2);
    EmptyBallSearch search(2);
    const std::vector<UnitPosition> points = random_positions(2, 50, random);
    EXPECT_EQ(search.radius(points, 1e6), 1e6);
    const double alone = search.radius(points, 0);
    EXPECT_NEAR(search.radius(points, alone / 2), alone, alone * EmptyBallSearch::tolerance);
}

}
}
