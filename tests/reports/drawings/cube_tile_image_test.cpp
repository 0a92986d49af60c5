// Pictures of cubes: which faces are in sight, and every corner's colour where it is seen.
#include "reports/drawings/cube_tile_image.hpp"

#include "base/errors/errors.hpp"
#include "reports/drawings/tile_image.hpp"
#include "tests/reports/drawings/colors.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/reports/support/tile_grids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

const std::string south_grey = "#ebebeb", east_grey = "#d6d6d6";

/// The projection of space: 32 units an edge, x to the lower right and y to the upper right by 30
/// degrees. `left` and `top` are the margins of the block, `depth` and `height` its sizes in y and z.
struct View
{
    double left = 8, top = 8;
    double depth = 1, height = 1;

    DrawingPoint operator()(double x, double y, double z) const
    {
        const double cosine = std::cos(std::numbers::pi / 6), sine = 0.5;
        return {left + 32 * cosine * (x + y), top + 32 * (height + sine * depth + sine * (x - y) - z)};
    }
};

/// The colours 0 to 7 at the corners of one cube: x + 2 y + 4 z.
CubeGrid one_cube(bool has_gaps)
{
    const CornerCube cube{{7, 5, 4, 6}, {3, 1, 0, 2}};
    return {8, {1, 1, 1}, {cube_index(cube, 8)}, has_gaps};
}

TEST(CubeTileImage, ShowsThreeFacesAndSevenCorners)
{
    const Drawing drawing = draw_cubes(one_cube(true));
    EXPECT_NEAR(drawing.width, 16 + 32 * std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(drawing.height, 16 + 64, 1e-9);
    const test::Pixels pixels(drawing, 10);
    const View view;
    for (int corner = 0; corner < 8; ++corner) {
        if (corner == 2) continue; // north-west, at the bottom
        EXPECT_EQ(pixels.at(view(corner & 1, corner >> 1 & 1, corner >> 2)), tile_color(static_cast<Color>(corner)))
            << corner;
    }
    // The hidden corner around the nearest one: from 5 to 7 units, with an outline of 0.6.
    const auto [x, y] = view(1, 0, 1);
    EXPECT_EQ(pixels.at(x, y + 4.5), tile_color(5));
    EXPECT_EQ(pixels.at(x, y + 5), black);
    EXPECT_EQ(pixels.at(x, y + 6), tile_color(2));
    EXPECT_EQ(pixels.at(x, y + 7), black);
    EXPECT_EQ(pixels.at(x + 8, y + 8), east_grey);

    EXPECT_EQ(pixels.at(view(0.5, 0.5, 1)), white);
    EXPECT_EQ(pixels.at(view(0.5, 0, 0.5)), south_grey);
    EXPECT_EQ(pixels.at(view(1, 0.5, 0.5)), east_grey);
    EXPECT_EQ(pixels.at(view(0.5, 0, 1)), black); // an edge
    EXPECT_EQ(pixels.at(view(1, 0, 0.5)), black);
    EXPECT_EQ(pixels.at(view(1, 0.5, 0)), black);
    EXPECT_EQ(pixels.at(2, 2), white);

    // A block of one cube is the same without the ring.
    const test::Pixels block(draw_cubes(one_cube(false)), 10);
    EXPECT_EQ(block.at(x, y + 4.5), tile_color(5));
    EXPECT_EQ(block.at(x + 4.5, y + 4.5), east_grey);
}

TEST(CubeTileImage, ShowsTheOuterFacesOfABlock)
{
    const CubeTiling tiling(4, HashKind::xxh64, 3);
    const CubeWindow window{-1, 2, 5, 2, 3, 4};
    const Drawing drawing = draw_cubes(cube_tiling_grid(tiling, window));
    EXPECT_NEAR(drawing.width, 16 + 32 * 5 * std::sqrt(0.75), 1e-9);
    EXPECT_NEAR(drawing.height, 16 + 32 * (2.5 + 4), 1e-9);
    const test::Pixels pixels(drawing, 5);
    const View view{8, 8, 3, 4};
    int points = 0;
    for (int z = 0; z <= 4; ++z)
        for (int y = 0; y <= 3; ++y)
            for (int x = 0; x <= 2; ++x) {
                if (x < 2 && y > 0 && z < 4) continue; // not in sight
                ++points;
                const CornerCube cube = cube_tile(tiling.tile(x - 1, y + 2, z + 5), 4);
                EXPECT_EQ(pixels.at(view(x, y, z)), tile_color(cube.bottom.south_west));
            }
    EXPECT_EQ(points, 60 - 24);
    EXPECT_EQ(pixels.at(view(1.5, 2.5, 4)), white);
    EXPECT_EQ(pixels.at(view(1.5, 0, 3.5)), south_grey);
    EXPECT_EQ(pixels.at(view(2, 2.5, 0.5)), east_grey);
    EXPECT_EQ(pixels.at(view(1, 1.5, 4)), black); // outlines of the cubes
    EXPECT_EQ(pixels.at(view(2, 1.5, 3)), black);
}

TEST(CubeTileImage, ShowsSetsInRows)
{
    const CubeGrid grid = cube_set_grid(TileSet::complete(TileKind::cube, 2), 20);
    EXPECT_EQ(grid.cubes.size(), 256u);
    EXPECT_EQ(grid.size, (std::array<std::size_t, 3>{20, 13, 1}));
    const Drawing drawing = draw_cubes(grid);
    const double width = 32 * std::sqrt(3.0);
    EXPECT_NEAR(drawing.width, 16 + 20 * width + 19 * 16, 1e-9);
    EXPECT_NEAR(drawing.height, 16 + 13 * 64 + 12 * 16, 1e-9);
    const test::Pixels pixels(drawing, 2);
    for (const std::size_t i : {0u, 1u, 19u, 20u, 103u, 255u}) {
        const View view{8 + (width + 16) * static_cast<double>(i % 20), 8 + 80.0 * static_cast<double>(i / 20)};
        const CornerCube cube = cube_tile(static_cast<TileIndex>(i), 2);
        EXPECT_EQ(pixels.at(view(0, 0, 0)), tile_color(cube.bottom.south_west)) << i;
        EXPECT_EQ(pixels.at(view(1, 1, 0)), tile_color(cube.bottom.north_east)) << i;
        EXPECT_EQ(pixels.at(view(0, 1, 1)), tile_color(cube.top.north_west)) << i;
        const auto [x, y] = view(1, 0, 1);
        EXPECT_EQ(pixels.at(x, y + 6), tile_color(cube.bottom.north_west)) << i;
    }
}

TEST(CubeTileImage, ShowsRegionsOnEachFace)
{
    const double r = 0.08, A = r * (1 + 2 * std::numbers::sqrt2), B = r * (1 + std::numbers::sqrt2);
    const double e = 0.03; // further than half a line
    const test::Pixels pixels(draw_cube_regions(one_cube(false), r), 10);
    const View view;
    // Each face: its plane's axis and position, and the share of black.
    const struct
    {
        std::size_t axis;
        double position, shade;
        std::string plain;
    } faces[] = {{2, 1, 0, white}, {1, 0, 0.08, south_grey}, {0, 1, 0.16, east_grey}};
    for (const auto& face : faces) {
        const std::size_t u = face.axis == 0 ? 1 : 0, v = face.axis == 2 ? 1 : 2;
        for (int corner = 0; corner < 4; ++corner) {
            std::array<double, 3> place{};
            place[face.axis] = face.position;
            const auto at = [&](double along, double aside) {
                place[u] = corner & 1 ? 1 - along : along;
                place[v] = corner & 2 ? 1 - aside : aside;
                return pixels.at(view(place[0], place[1], place[2]));
            };
            std::array<int, 3> bits{};
            bits[face.axis] = static_cast<int>(face.position);
            bits[u] = corner & 1;
            bits[v] = corner >> 1;
            const std::string color = tile_color(static_cast<Color>(bits[0] + 2 * bits[1] + 4 * bits[2]));
            const std::string full = mixed_color(color, black, face.shade);
            const std::string pale = mixed_color(mixed_color(color, white, 0.6), black, face.shade);
            EXPECT_EQ(at(e, e), full);
            EXPECT_EQ(at(A - e, B - e), full);
            EXPECT_EQ(at(B - e, A - e), full);
            EXPECT_EQ(at((A + B) / 2 - e, (A + B) / 2 - e), full);
            EXPECT_EQ(at((A + B) / 2 + e, (A + B) / 2 + e), face.plain);
            EXPECT_EQ(at(A + e, B - e), pale);
            EXPECT_EQ(at(B - e, 0.5 - e), pale);
            EXPECT_EQ(at(0.5 - e, B - e), pale);
            EXPECT_EQ(at(A + e, B + e), face.plain);
        }
    }
}

TEST(CubeTileImage, HasTheAreasOfTheRegions)
{
    // Per face, an octagon in four quarters, strips on the inside of four edges; rhombs are sin 120 as large.
    const double r = 0.1, A = r * (1 + 2 * std::numbers::sqrt2), B = r * (1 + std::numbers::sqrt2);
    CubeGrid grid{2, {1, 1, 1}, {0}, false};
    const std::string color = tile_color(0);
    auto areas = test::filled_areas(draw_cube_regions(grid, r));
    const double rhomb = 1024 * std::sqrt(0.75);
    for (const double shade : {0.0, 0.08, 0.16}) {
        EXPECT_NEAR(areas[mixed_color(color, black, shade)], (4 * A * A - 2 * (A - B) * (A - B)) * rhomb, 1e-9);
        EXPECT_NEAR(areas[mixed_color(mixed_color(color, white, 0.6), black, shade)], 4 * B * (1 - 2 * A) * rhomb,
                    1e-9);
        EXPECT_NEAR(areas[mixed_color(white, black, shade)], rhomb, 1e-9); // under the regions
    }
    EXPECT_EQ(areas.size(), 9u);
}

TEST(CubeTileImage, RefusesWhatItCannotDraw)
{
    EXPECT_NEAR(max_sphere_region_radius, 0.1306, 5e-5);
    EXPECT_NO_THROW(draw_cube_regions(one_cube(true), max_sphere_region_radius));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double radius : {std::nextafter(max_sphere_region_radius, 1), 0.2, 0.0, -0.1, nan})
        EXPECT_THROW(draw_cube_regions(one_cube(true), radius), InputError) << radius;

    CubeGrid grid{2, {2, 2, 2}, std::vector<TileIndex>(7), false};
    EXPECT_THROW(draw_cubes(grid), std::logic_error);
    EXPECT_THROW(draw_cube_regions(grid, 0.1), std::logic_error);
    grid.has_gaps = true;
    EXPECT_NO_THROW(draw_cubes(grid));
    grid.cubes.resize(9);
    EXPECT_THROW(draw_cubes(grid), std::logic_error);
    EXPECT_THROW(draw_cubes({2, {0, 1, 1}, {}, true}), std::logic_error);
}

TEST(CubeTileImage, WangCubesShowTheirFacesAndThoseBehind)
{
    // North 0, east 1, south 2, west 3, top 4, bottom 5.
    const CubeGrid grid{6, {1, 1, 1}, {wang_cube_index({0, 1, 2, 3, 4, 5}, 6)}, true, TileKind::wang_cube};
    const test::Pixels pixels(draw_cubes(grid), 10);
    const View view;
    EXPECT_EQ(pixels.at(view(0.15, 0.5, 1)), tile_color(4));
    EXPECT_EQ(pixels.at(view(0.5, 0.5, 1)), tile_color(5));
    EXPECT_EQ(pixels.at(view(0.15, 0, 0.5)), mixed_color(tile_color(2), "#000000", 0.08));
    EXPECT_EQ(pixels.at(view(0.5, 0, 0.5)), mixed_color(tile_color(0), "#000000", 0.08));
    EXPECT_EQ(pixels.at(view(1, 0.15, 0.5)), mixed_color(tile_color(1), "#000000", 0.16));
    EXPECT_EQ(pixels.at(view(1, 0.5, 0.5)), mixed_color(tile_color(3), "#000000", 0.16));
    CubeGrid block = grid;
    block.has_gaps = false;
    EXPECT_EQ(test::Pixels(draw_cubes(block), 10).at(view(0.5, 0.5, 1)), tile_color(4));
}

}
}
