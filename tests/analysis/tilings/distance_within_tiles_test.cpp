// The smallest distance within tiles, against every pair.
#include "analysis/tilings/tiled_sets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace poissonlab {
namespace {

/// The smallest distance of all pairs with the same tile, whose numbers are known.
double smallest_of_pairs(const PointSet& points, const std::vector<int>& tiles)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (tiles[i] != tiles[j]) continue;
            double squared = 0;
            for (std::size_t k = 0; k < points[i].size(); ++k) squared += std::pow(points[i][k] - points[j][k], 2);
            least = std::min(least, std::sqrt(squared));
        }
    return least;
}

TEST(DistanceWithinTiles, IsThatOfAllPairsOfATile)
{
    std::mt19937 random(3);
    for (const int dimension : {2, 3})
        for (const int tiles : {2, 3, 7}) {
            PointSet points{dimension, {}};
            std::vector<int> of_tile;
            std::uniform_int_distribution<int> tile(0, tiles - 1), place(0, 65'535);
            for (int i = 0; i < 400; ++i) {
                int number = 0;
                for (int k = 0; k < dimension; ++k) {
                    const int along = tile(random);
                    number = number * tiles + along;
                    points.coordinates.push_back((along * 65'536.0 + place(random)) / (tiles * 65'536.0));
                }
                of_tile.push_back(number);
            }
            const double expected = smallest_of_pairs(points, of_tile);
            EXPECT_NEAR(min_distance_within_tiles(points, tiles), expected, 1e-15) << dimension << ", " << tiles;
        }
}

/// A point at a lower border belongs to that tile, even where rounding has put it a little below.
TEST(DistanceWithinTiles, KnowsWhereTilesBegin)
{
    const double third = std::nextafter(1.0 / 3, 0);
    const PointSet below{2, {0.3, 0.5, third, 0.5, 0.5, 0.5}}; // 0.3 is alone in its tile
    EXPECT_NEAR(min_distance_within_tiles(below, 3), 0.5 - third, 1e-15);
    const PointSet at_end{2, {std::nextafter(1.0, 0), 0.1, 0.25, 0.1, 0.9, 0.1}};
    EXPECT_NEAR(min_distance_within_tiles(at_end, 2), 0.25, 1e-15) << "the torus' end is its beginning";
}

TEST(DistanceWithinTiles, OfSinglePointsIsInfinite)
{
    EXPECT_EQ(min_distance_within_tiles({2, {0.1, 0.1, 0.6, 0.6}}, 2), std::numeric_limits<double>::infinity());
}

}
}
