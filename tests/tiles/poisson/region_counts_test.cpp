// The spread of points over regions, against closed forms of their areas.
#include "tiles/poisson/region_counts.hpp"

#include "tests/support/random_tile_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// The share of the plane in the regions of corners and edges (section 4.5): octagons of side 2 r, and between them
/// rectangles 2 r wide.
struct Shares
{
    double corners;
    double edges;
};

Shares shares_of(const PoissonTileParameters& parameters)
{
    const double r = parameters.relative_radius / std::sqrt(2 * std::numbers::sqrt3 * parameters.points_per_tile);
    const double a = r * (1 + std::numbers::sqrt2);
    return {8 * (1 + std::numbers::sqrt2) * r * r, 2 * (2 * r) * (1 - 2 * a)};
}

TEST(RegionCounts, ExpectAsManyPointsAsTheAreaHolds)
{
    for (const std::uint32_t points : {16u, 64u, 128u}) {
        const PoissonTileSet set = random_tile_set(PoissonTileKind::corner, 2, 2, points);
        const auto counts = region_counts(set);
        const Shares shares = shares_of(set.parameters);
        // The radius is rounded up to whole units: the border of a region moves by less than two of them, and the
        // borders in a tile are shorter than four tiles.
        const double rounding = 4 * 2.0 / tile_units * points;
        EXPECT_NEAR(counts[0].expected, shares.corners * points, rounding);
        EXPECT_NEAR(counts[1].expected, shares.edges * points, rounding);
        EXPECT_NEAR(counts[2].expected, (1 - shares.corners - shares.edges) * points, rounding);
    }
}

TEST(RegionCounts, AreBinomialForIndependentPoints)
{
    const PoissonTileSet set = random_tile_set(PoissonTileKind::corner, 2, 4, 64); // 256 tiles
    const auto counts = region_counts(set);
    const double total = 256.0 * 64;
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double share = counts[k].expected / 64;
        const double standard_error = std::sqrt(share * (1 - share) / total) * 64;
        EXPECT_NEAR(counts[k].mean, counts[k].expected, 4 * standard_error) << k;
        EXPECT_DOUBLE_EQ(counts[k].density, counts[k].mean / counts[k].expected);
        EXPECT_LT(counts[k].min, counts[k].mean);
        EXPECT_GT(counts[k].max, counts[k].mean);
        sum += counts[k].mean;
    }
    EXPECT_DOUBLE_EQ(sum, 64);
    EXPECT_EQ(counts[3], RegionCounts{});
}

}
}
