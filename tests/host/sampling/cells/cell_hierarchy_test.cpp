// The hierarchy of cells, the Poisson numbers and the exact distance thresholds that dart throwing stands on.
#include "host/sampling/cells/cell_hierarchy.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace poissonlab {
namespace {

const double distances[] = {1.0, 0.83, 0.5, 0.36, 0.34, 0.31, 0.2, 0.1, 0.0123, 0.0063, 0.00075};

TEST(CellHierarchy, CoversTheTorusWithNestedCells)
{
    for (const double d : distances) {
        for (const int dimension : {2, 3}) {
            const CellHierarchy h = cell_hierarchy(d, dimension);
            EXPECT_EQ(h.lower_bound(0, 0), 0u);
            EXPECT_EQ(h.lower_bound(h.size, 0), std::uint64_t{1} << 32);
            for (std::uint64_t i = 0; i < h.size; i += 1 + h.size / 50) {
                for (int level = 0; level < std::min(h.last_level, 12); ++level) {
                    EXPECT_EQ(h.lower_bound(i << level, level), h.lower_bound(i, 0));
                    EXPECT_LT(h.lower_bound(i << level, level), h.lower_bound((i << level) + 1, level));
                }
            }
        }
    }
}

TEST(CellHierarchy, CellsHoldOnePointAndReachIsEnough)
{
    for (const double d : distances) {
        for (const int dimension : {2, 3}) {
            const CellHierarchy h = cell_hierarchy(d, dimension);
            std::uint64_t widest = 0;
            std::uint64_t narrowest_reach = UINT64_MAX;
            const auto reach = static_cast<std::uint64_t>(h.reach);
            for (std::uint64_t i = 0; i < h.size; ++i) {
                widest = std::max(widest, h.lower_bound(i + 1, 0) - h.lower_bound(i, 0));
                if (i + reach <= h.size) {
                    narrowest_reach = std::min(narrowest_reach, h.lower_bound(i + reach, 0) - h.lower_bound(i, 0));
                }
            }
            // Coordinates in one cell differ by less than its width, so two points there would be too near.
            EXPECT_LT(dimension * (widest - 1) * (widest - 1), squared_threshold(d)) << d;
            // Points more than `reach` cells apart have at least `reach` whole cells, plus one unit, between
            // them.
            if (2 * reach + 1 < h.size) {
                EXPECT_GE((narrowest_reach + 1) * (narrowest_reach + 1), squared_threshold(d)) << d;
            }
        }
    }
}

TEST(CellHierarchy, LastLevelHasCellsOfOneOrTwoCoordinates)
{
    for (const double d : distances) {
        const CellHierarchy h = cell_hierarchy(d, 2);
        const std::uint64_t cells = std::uint64_t{h.size} << h.last_level;
        ASSERT_LE(cells, std::uint64_t{1} << 32);
        for (std::uint64_t i = 0; i < cells; i += 1 + cells / 10'007) {
            const std::uint64_t width = h.lower_bound(i + 1, h.last_level) - h.lower_bound(i, h.last_level);
            EXPECT_TRUE(width == 1 || width == 2) << width;
        }
    }
}

TEST(PoissonThresholds, AreTheCumulativeDistribution)
{
    for (const double mean : {0.3, 1.0, 2.5}) {
        const auto thresholds = poisson_thresholds(mean);
        double cumulative = 0;
        const auto probability = [&](std::size_t k) {
            const auto x = static_cast<double>(k);
            return std::exp(-mean + x * std::log(mean) - std::lgamma(x + 1));
        };
        for (std::size_t k = 0; k < thresholds.size(); ++k) {
            cumulative += probability(k);
            // One unit for rounding down, and rounding errors of some 2^-52 relative, 2^-20 in these units.
            EXPECT_NEAR(thresholds[k], cumulative * 0x1p32, 1.01) << mean << " " << k;
        }
        // The part that is left out is less than one unit.
        EXPECT_GT(cumulative + probability(thresholds.size()), 1 - 1.01 * 0x1p-32);
    }
}

TEST(SquaredThreshold, IsTheSmallestIntegerThatIsNotBelow)
{
    // Distances that are multiples of 2^-31 have exact squares.
    std::mt19937_64 generator(1);
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t units = generator() >> 33;
        EXPECT_EQ(squared_threshold(static_cast<double>(units) * 0x1p-32), units * units);
    }
    // Between them, rounding goes up; one unit in the last place of the distance decides.
    const double exact = 12345678 * 0x1p-32;
    EXPECT_EQ(squared_threshold(std::nextafter(exact, 1.0)), 12345678ull * 12345678 + 1);
    EXPECT_EQ(squared_threshold(std::nextafter(exact, 0.0)), 12345678ull * 12345678);
    EXPECT_EQ(squared_threshold(0), 0u);
    EXPECT_EQ(squared_threshold(1e-300), 1u);
    EXPECT_EQ(squared_threshold(1.0), UINT64_MAX);
}

TEST(PackingBound, IsReachedByTheHexagonalLatticeOnly)
{
    for (const std::size_t n : {1u, 7u, 1000u, 1000000u}) {
        for (const int dimension : {2, 3}) {
            const double d = max_min_distance(n, dimension);
            EXPECT_GE(packing_bound(d, dimension), n);
            EXPECT_LE(packing_bound(d, dimension), n + 2);
        }
    }
}

}
}
