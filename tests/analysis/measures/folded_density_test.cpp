// The density over the tile, of points whose places are known.
#include "analysis/measures/seam_density.hpp"

#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace poissonlab {
namespace {

TEST(FoldedDensity, PutsTheTilesOverOneAnother)
{
    // Two tiles along each axis, with a point each at (1/4, 3/4) of the tile, and one more in one tile at (3/4, 3/4).
    FoldedDensity density(2, 5);
    const PointSet points{2, {0.125, 0.375, 0.625, 0.375, 0.125, 0.875, 0.625, 0.875, 0.375, 0.375}};
    density.add(points);
    const SquareImage image = density.densities();
    const int n = image.size;
    const double mean = 5.0 / (n * n);
    EXPECT_DOUBLE_EQ(image.at(n / 4, 3 * n / 4), 4 / mean);
    EXPECT_DOUBLE_EQ(image.at(3 * n / 4, 3 * n / 4), 1 / mean);
    EXPECT_NEAR(std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0), n * n, 1e-9);
}

TEST(FoldedDensity, HasBinsOfAQuarterOfARadius)
{
    // Tiles of 32 points: r is 0.75 / 2 of the largest distance, sqrt(2 / (sqrt 3 32)) = 0.19 tiles.
    EXPECT_EQ(FoldedDensity(16, 16 * 16 * 32).size(), 56);
}

TEST(FoldedDensity, OfPartsIsThatOfTheWhole)
{
    std::mt19937_64 random(1);
    const PointSet first = test::random_points(500, 2, random), second = test::random_points(500, 2, random);
    FoldedDensity whole(3, 500), part(3, 500), rest(3, 500);
    whole.add(first);
    whole.add(second);
    part.add(first);
    rest.add(second);
    part.append(rest);
    EXPECT_EQ(part.densities().pixels, whole.densities().pixels);
}

}
}
