// Cells and movement on the torus of two tiles, against what their definitions say.
#include "host/tile_construction/filling/tile_torus.hpp"

#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

constexpr std::int32_t width = 3300;

TilePosition random_position(std::mt19937& random, int dimension)
{
    TilePosition position{};
    for (int k = 0; k < dimension; ++k) position[k] = static_cast<std::int32_t>(random() % torus_units);
    return position;
}

class TileTorus : public testing::TestWithParam<int>
{
protected:
    const int dimension_ = GetParam();
    const TileRegions regions_ = modified_regions(dimension_, width);
};

/// The shares of random positions in the regions are their volumes, which are closed forms.
TEST_P(TileTorus, RegionsHaveTheirVolumes)
{
    std::mt19937 random(1);
    constexpr int count = 400'000;
    std::array<int, 8> hits{};
    for (int i = 0; i < count; ++i)
        ++hits[cell_at(regions_, random_position(random, dimension_)) & all_axes(dimension_)];
    const double bound = test::z_bound(all_axes(dimension_) + 1u);
    double sum = 0;
    for (std::uint8_t axes = 0; axes <= all_axes(dimension_); ++axes) {
        const double volume = regions_.volume(axes);
        const double error = std::sqrt(volume * (1 - volume) / count);
        EXPECT_NEAR(static_cast<double>(hits[axes]) / count, volume, bound * error) << "axes " << int{axes};
        sum += volume;
    }
    EXPECT_NEAR(sum, 1, 1e-3); // thresholds are rounded up to units
}

/// Different cells of the same dimension are two radii apart; that is what enlarged corners are for.
TEST_P(TileTorus, RegionsOfTheSameDimensionAreTwoRadiiApart)
{
    std::mt19937 random(2);
    int compared = 0;
    for (int i = 0; i < 300'000; ++i) {
        const TilePosition a = random_position(random, dimension_);
        TilePosition b = a;
        for (int k = 0; k < dimension_; ++k)
            b[k] = wrapped(a[k] + static_cast<std::int32_t>(random() % (6 * width)) - 3 * width);
        const unsigned cell_a = cell_at(regions_, a);
        const unsigned cell_b = cell_at(regions_, b);
        const unsigned axes = cell_a & all_axes(dimension_);
        if (cell_a == cell_b || axes != (cell_b & all_axes(dimension_))) continue;
        ++compared;
        ASSERT_GE(squared_distance(a, b, dimension_), std::uint64_t{4} * width * width);
    }
    // Perpendicular edges have other axes.
    for (int i = 0; i < 300'000; ++i) {
        TilePosition a = random_position(random, dimension_);
        const TilePosition b = random_position(random, dimension_);
        const unsigned axes_a = cell_at(regions_, a) & all_axes(dimension_);
        const unsigned axes_b = cell_at(regions_, b) & all_axes(dimension_);
        if (axes_a == axes_b || std::popcount(axes_a) != 1 || std::popcount(axes_b) != 1) continue;
        ++compared;
        ASSERT_GE(squared_distance(a, b, dimension_), std::uint64_t{4} * width * width);
    }
    EXPECT_GT(compared, 1000);
}

TEST_P(TileTorus, PushedOutPositionsLeaveTheirCellByTheShortestWay)
{
    std::mt19937 random(3);
    for (int i = 0; i < 20'000; ++i) {
        const TilePosition position = random_position(random, dimension_);
        const unsigned cell = cell_at(regions_, position);
        const TilePosition out = pushed_out(regions_, position);
        if ((cell & all_axes(dimension_)) == all_axes(dimension_)) {
            EXPECT_EQ(out, position);
            continue;
        }
        EXPECT_NE(cell_at(regions_, out), cell);
        const auto extent_of = [&](unsigned number) { return std::popcount(number & all_axes(dimension_)); };
        // No shorter movement leads out, but into cells of lower dimension at the ends: tried in many
        // directions.
        const double length = std::sqrt(static_cast<double>(squared_distance(position, out, dimension_)));
        std::normal_distribution<double> normal;
        for (int direction = 0; direction < 8; ++direction) {
            std::array<double, 3> d{normal(random), normal(random), dimension_ == 3 ? normal(random) : 0};
            const double norm = std::hypot(d[0], d[1], d[2]);
            TilePosition tried = position;
            for (int k = 0; k < dimension_; ++k)
                tried[k] = wrapped(position[k] + static_cast<std::int32_t>((length - 4) * d[k] / norm));
            if (length > 8) {
                const unsigned reached = cell_at(regions_, tried);
                EXPECT_TRUE(reached == cell || extent_of(reached) < extent_of(cell));
            }
        }
    }
}

TEST_P(TileTorus, MovementsEndWhereTheyAreAllowed)
{
    std::mt19937 random(4);
    const CellSet interior = CellSet{1} << cell_number(all_axes(dimension_), 0, dimension_);
    const CellSet outside_corners = [&] {
        CellSet cells = all_cells(dimension_);
        for (unsigned base = 0; base < 1u << dimension_; ++base)
            cells &= ~(CellSet{1} << cell_number(0, base, dimension_));
        return cells;
    }();
    int stopped = 0;
    for (const CellSet cells : {interior, outside_corners}) {
        for (int i = 0; i < 60'000; ++i) {
            const TilePosition start = random_position(random, dimension_);
            if (!is_allowed({regions_, cells}, start)) continue;
            TilePosition movement{};
            for (int k = 0; k < dimension_; ++k)
                movement[k] = static_cast<std::int32_t>(random() % (2 * width)) - width;
            TilePosition free_end{};
            for (int k = 0; k < dimension_; ++k) free_end[k] = wrapped(start[k] + movement[k]);
            for (const bool slides : {false, true}) {
                const TilePosition end = allowed_end({regions_, cells}, start, movement, slides);
                EXPECT_TRUE(is_allowed({regions_, cells}, end));
                if (is_allowed({regions_, cells}, free_end)) {
                    EXPECT_EQ(end, free_end);
                }
            }
            stopped += !is_allowed({regions_, cells}, free_end);
        }
    }
    EXPECT_GT(stopped, 500);
}

TEST_P(TileTorus, MovementsMayBeKeptInTheirTile)
{
    std::mt19937 random(5);
    int stopped = 0;
    for (int i = 0; i < 20'000; ++i) {
        const TilePosition start = random_position(random, dimension_);
        // All cells of this kind are allowed, on all sides of the lattice.
        CellSet cells = 0;
        for (unsigned base = 0; base < 1u << dimension_; ++base)
            cells |= CellSet{1} << cell_number(cell_at(regions_, start) & all_axes(dimension_), base, dimension_);
        TilePosition movement{};
        for (int k = 0; k < dimension_; ++k) movement[k] = static_cast<std::int32_t>(random() % (2 * width)) - width;
        for (const bool slides : {false, true}) {
            const TilePosition end = allowed_end({regions_, cells, {}, true}, start, movement, slides);
            EXPECT_TRUE(is_allowed({regions_, cells}, end));
            for (int k = 0; k < dimension_; ++k) EXPECT_EQ(end[k] / tile_units, start[k] / tile_units);
            stopped += end != allowed_end({regions_, cells}, start, movement, slides);
        }
    }
    EXPECT_GT(stopped, 500);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, TileTorus, testing::Values(2, 3));

}
}
