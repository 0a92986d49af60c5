// Pictures of Poisson disk tile regions: every region at its place, in its colour, as large as it should be.
#include "reports/drawings/tile_image.hpp"

#include "base/errors/errors.hpp"
#include "tests/reports/drawings/colors.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/reports/support/tile_grids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

const std::string grey = "#d0d0d0", outline = "#606060";

constexpr double r = 0.15;
const double a = r * (1 + std::numbers::sqrt2);

TileGrid one_wang_tile() { return tile_set_grid(TileSet(TileKind::wang, {4, 4}, {wang_index({0, 1, 2, 3}, {4, 4})})); }

TileGrid one_corner_tile() { return tile_set_grid(TileSet(TileKind::corner, {4, 4}, {corner_index({0, 1, 2, 3}, 4)})); }

/// A place in the tile from (8, 8) to (40, 40), x and y from 0 to 1, y upwards.
DrawingPoint in_tile(double x, double y) { return {8 + 32 * x, 40 - 32 * y}; }

TEST(TileRegionsImage, HasEdgeRegionsInTheColorsOfWangTiles)
{
    const test::Pixels pixels(draw_tile_regions(one_wang_tile(), r), 10);
    // Both ends and the inner border of the strips: north, east, south, west. Lines are 0.4 units wide.
    const double e = 0.02;
    for (const double t : {a + e, 0.5, 1 - a - e}) {
        for (const double s : {e, r - e}) {
            EXPECT_EQ(pixels.at(in_tile(t, 1 - s)), tile_color(0));
            EXPECT_EQ(pixels.at(in_tile(1 - s, t)), tile_color(1));
            EXPECT_EQ(pixels.at(in_tile(t, s)), tile_color(2));
            EXPECT_EQ(pixels.at(in_tile(s, t)), tile_color(3));
        }
        EXPECT_EQ(pixels.at(in_tile(t, r + e)), white);
        EXPECT_EQ(pixels.at(in_tile(1 - r - e, t)), white);
    }
    for (const double x : {e, 1 - e}) {
        EXPECT_EQ(pixels.at(in_tile(x, e)), grey);
        EXPECT_EQ(pixels.at(in_tile(x, 1 - e)), grey);
        EXPECT_EQ(pixels.at(in_tile(x, a - e)), grey);
        EXPECT_EQ(pixels.at(in_tile(x, 1 - a + e)), grey);
    }
    // The slanted side goes through the middle between (a, r) and (r, a).
    const double m = (a + r) / 2;
    EXPECT_EQ(pixels.at(in_tile(m - e, m - e)), grey);
    EXPECT_EQ(pixels.at(in_tile(m, m)), outline);
    EXPECT_EQ(pixels.at(in_tile(m + e, m + e)), white);
    EXPECT_EQ(pixels.at(in_tile(a, r / 2)), outline);
    EXPECT_EQ(pixels.at(in_tile(0.4, r)), outline);
    EXPECT_EQ(pixels.at(in_tile(0.4, 0)), black);
}

TEST(TileRegionsImage, HasRegionsInTheColorsOfCornerTiles)
{
    const test::Pixels pixels(draw_tile_regions(one_corner_tile(), r), 10);
    // North-east, south-east, south-west, north-west.
    const double corners[4][2] = {{1, 1}, {1, 0}, {0, 0}, {0, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string color = tile_color(static_cast<Color>(i));
        const auto at = [&](double x, double y) {
            return pixels.at(in_tile(std::abs(corners[i][0] - x), std::abs(corners[i][1] - y)));
        };
        const double e = 0.02;
        for (const auto& [along, aside] :
             {std::pair{e, e}, {a - e, e}, {a - e, r - e}, {(a + r) / 2 - e, (a + r) / 2 - e}}) {
            EXPECT_EQ(at(along, aside), color);
            EXPECT_EQ(at(aside, along), color);
        }
        for (const double along : {a + e, 0.5 - e}) {
            EXPECT_EQ(at(along, r / 2), mixed_color(color, white, 0.6));
            EXPECT_EQ(at(r / 2, along), mixed_color(color, white, 0.6));
        }
        EXPECT_EQ(at(a + e, r + e), white);
        EXPECT_EQ(at(0.4, 0.45), white);
    }
}

TEST(TileRegionsImage, HasTheAreasOfTheRegions)
{
    for (const double radius : {0.02, 0.15, 0.2, max_disk_region_radius}) {
        const double reach = radius * (1 + std::numbers::sqrt2);
        // A regular octagon of side 2 r has the area 2 (1 + sqrt 2) (2 r)^2.
        const double octagon = 2 * (1 + std::numbers::sqrt2) * 4 * radius * radius;
        const double strip = (1 - 2 * reach) * radius;
        const double unit = 32 * 32;
        auto wang = test::filled_areas(draw_tile_regions(one_wang_tile(), radius));
        EXPECT_EQ(wang.size(), 5u);
        EXPECT_NEAR(wang[grey], octagon * unit, 1e-9);
        auto corner = test::filled_areas(draw_tile_regions(one_corner_tile(), radius));
        EXPECT_EQ(corner.size(), 8u);
        for (Color color = 0; color < 4; ++color) {
            EXPECT_NEAR(wang[tile_color(color)], strip * unit, 1e-9);
            EXPECT_NEAR(corner[tile_color(color)], octagon / 4 * unit, 1e-9);
            EXPECT_NEAR(corner[mixed_color(tile_color(color), white, 0.6)], strip * unit, 1e-9);
        }
    }
}

TEST(TileRegionsImage, ShowsWholeRegionsInTilings)
{
    // Around the lattice points and edges inside of a window, all tiles agree.
    const Tiling tiling(DirectAlgorithm::corner, {3, 3}, HashKind::xxh64, 1);
    const test::Pixels pixels(draw_tile_regions(tiling_grid(tiling, {0, 0, 5, 4}), r), 4);
    for (int y = 1; y < 4; ++y)
        for (int x = 1; x < 5; ++x) {
            const std::string color = tile_color(corner_tile(tiling.tile(x, y), 3).south_west);
            for (const double dx : {-0.1, 0.1})
                for (const double dy : {-0.1, 0.1}) {
                    EXPECT_EQ(pixels.at(8 + 32 * (x + dx), 8 + 32 * (4 - y - dy)), color);
                    EXPECT_EQ(pixels.at(8 + 32 * (x + 4.2 * dx), 8 + 32 * (4 - y - dy)),
                              mixed_color(color, white, 0.6));
                }
        }
}

TEST(TileRegionsImage, RefusesRadiiThatDoNotFit)
{
    EXPECT_NEAR(max_disk_region_radius, 0.2071, 5e-5);
    EXPECT_NO_THROW(draw_tile_regions(one_wang_tile(), max_disk_region_radius));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double radius : {std::nextafter(max_disk_region_radius, 1), 0.5, 0.0, -0.1, nan})
        EXPECT_THROW(draw_tile_regions(one_corner_tile(), radius), InputError) << radius;
    EXPECT_THROW(draw_tile_regions(tile_set_grid(TileSet::complete(TileKind::cube, 2)), r), std::logic_error);
}

}
}
