// Pictures of tiles: every tile at its place, with its colours on the right sides.
#include "reports/drawings/tile_image.hpp"

#include "tests/reports/drawings/colors.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/reports/support/tile_grids.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace poissonlab {
namespace {

/// Places two units inside of a tile's sides, the tile's upper left being at (x, y): north, east, south,
/// west.
std::array<DrawingPoint, 4> beside_sides(double x, double y)
{
    return {{{x + 16, y + 2}, {x + 30, y + 16}, {x + 16, y + 30}, {x + 2, y + 16}}};
}

/// Places near a tile's corners, the tile's upper left being at (x, y): north-east, south-east, south-west, north-west.
std::array<DrawingPoint, 4> beside_corners(double x, double y)
{
    return {{{x + 29, y + 3}, {x + 29, y + 29}, {x + 3, y + 29}, {x + 3, y + 3}}};
}

TEST(TileImage, HasColorsThatPeopleTellApart)
{
    EXPECT_EQ(tile_color(0), "#d55e00");
    EXPECT_EQ(tile_color(1), "#f0e442");
    EXPECT_EQ(tile_color(2), "#009e73");
    EXPECT_EQ(tile_color(3), "#56b4e9");
    EXPECT_EQ(tile_color(4), "#0072b2");
    std::set<std::string> different;
    for (Color color = 0; color < 32; ++color) different.insert(tile_color(color));
    EXPECT_EQ(different.size(), 32u);
}

TEST(TileImage, WangTilesAreTrianglesOnTheirEdges)
{
    // A tile from (8, 8) to (40, 40); y points down. North vermilion, east yellow, south green, west sky blue.
    const TileSet one(TileKind::wang, {4, 4}, {wang_index({0, 1, 2, 3}, {4, 4})});
    const Drawing drawing = draw_tiles(tile_set_grid(one));
    const test::Pixels pixels(drawing, 10);
    const auto places = beside_sides(8, 8);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(pixels.at(places[i]), tile_color(static_cast<Color>(i)));
    // On both sides of the diagonals, near the middle and near the corners.
    for (const double d : {3.0, 14.0}) {
        EXPECT_EQ(pixels.at(24 + d - 0.5, 24 - d), tile_color(0));
        EXPECT_EQ(pixels.at(24 + d + 0.5, 24 - d), tile_color(1));
        EXPECT_EQ(pixels.at(24 + d - 0.5, 24 + d), tile_color(2));
        EXPECT_EQ(pixels.at(24 - d - 0.5, 24 + d), tile_color(3));
    }
    EXPECT_EQ(pixels.at(8.1, 20), black);
    EXPECT_EQ(pixels.at(20, 40.2), black);
    EXPECT_EQ(pixels.at(4, 20), white);
    const std::map<std::string, double> quarters{
        {tile_color(0), 256}, {tile_color(1), 256}, {tile_color(2), 256}, {tile_color(3), 256}};
    EXPECT_EQ(test::filled_areas(drawing), quarters);
}

TEST(TileImage, CornerTilesAreQuartersOfDisksAtTheirCorners)
{
    const TileSet one(TileKind::corner, {4, 4}, {corner_index({0, 1, 2, 3}, 4)});
    const Drawing drawing = draw_tiles(tile_set_grid(one));
    const test::Pixels pixels(drawing, 10);
    const double corners[4][4] = {{40, 8, -1, 1}, {40, 40, -1, -1}, {8, 40, 1, -1}, {8, 8, 1, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& [x, y, dx, dy] = corners[i];
        for (const double angle : {0.1, 0.7, 1.4}) {
            const double right = dx * std::cos(angle), down = dy * std::sin(angle);
            EXPECT_EQ(pixels.at(x + 10.7 * right, y + 10.7 * down), tile_color(static_cast<Color>(i)));
            EXPECT_EQ(pixels.at(x + 11.3 * right, y + 11.3 * down), white);
        }
    }
    EXPECT_EQ(pixels.at(24, 24), white);
    EXPECT_EQ(pixels.at(24, 8.1), black);
    // Eight sides instead of a quarter of a circle.
    const double area = 4 * 121 * std::sin(std::numbers::pi / 16);
    for (const auto& [color, drawn] : test::filled_areas(drawing)) EXPECT_NEAR(drawn, area, 1e-9) << color;
    EXPECT_EQ(test::filled_areas(drawing).size(), 4u);
}

TEST(TileImage, ShowsSetsInOrderWithGaps)
{
    const TileGrid grid = tile_set_grid(TileSet::complete(TileKind::corner, 2));
    EXPECT_EQ(grid.columns, 4u);
    EXPECT_EQ(grid.tiles.size(), 16u);
    const Drawing drawing = draw_tiles(grid);
    // Four tiles of 32, three gaps of 8, margins of 8.
    EXPECT_EQ(drawing.width, 168);
    EXPECT_EQ(drawing.height, 168);
    const test::Pixels pixels(drawing, 4);
    for (std::size_t tile = 0; tile < 16; ++tile) {
        const double x = 8.0 + 40.0 * static_cast<double>(tile % 4), y = 8.0 + 40.0 * static_cast<double>(tile / 4);
        const auto places = beside_corners(x, y);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const auto digit = static_cast<Color>(tile >> (3 - corner) & 1); // binary digits
            EXPECT_EQ(pixels.at(places[corner]), tile_color(digit)) << tile << ' ' << corner;
        }
        EXPECT_EQ(pixels.at(x + 36, y + 16), white);
        EXPECT_EQ(pixels.at(x + 16, y + 36), white);
    }
    // Compact sets have rows that are not full.
    const Drawing compact = draw_tiles(tile_set_grid(compact_wang_set(3), 4));
    EXPECT_EQ(compact.width, 168);
    EXPECT_EQ(compact.height, 208);
}

TEST(TileImage, ShowsTilingsWithTheNorthAtTheTop)
{
    const Tiling tiling(DirectAlgorithm::wang_edge_hash, {3, 3}, HashKind::xxh64, 1);
    const Drawing drawing = draw_tiles(tiling_grid(tiling, {-2, 5, 4, 3}));
    EXPECT_EQ(drawing.width, 144);
    EXPECT_EQ(drawing.height, 112);
    const test::Pixels pixels(drawing, 4);
    for (std::int64_t row = 0; row < 3; ++row) {
        for (std::int64_t column = 0; column < 4; ++column) {
            const WangTile tile = wang_tile(tiling.tile(-2 + column, 7 - row), {3, 3});
            const auto places =
                beside_sides(8.0 + 32.0 * static_cast<double>(column), 8.0 + 32.0 * static_cast<double>(row));
            EXPECT_EQ(pixels.at(places[0]), tile_color(tile.north));
            EXPECT_EQ(pixels.at(places[1]), tile_color(tile.east));
            EXPECT_EQ(pixels.at(places[2]), tile_color(tile.south));
            EXPECT_EQ(pixels.at(places[3]), tile_color(tile.west));
        }
    }
}

TEST(TileImage, TakesOnePathForAColor)
{
    const Tiling tiling(DirectAlgorithm::corner, {3, 3}, HashKind::xxh64, 1);
    const std::string svg = drawing_svg(draw_tiles(tiling_grid(tiling, {0, 0, 20, 20})));
    for (const std::string& start : {"<path fill=\"" + tile_color(0), "<path fill=\"" + tile_color(1),
                                     "<path fill=\"" + tile_color(2), std::string("<path fill=\"none")}) {
        EXPECT_NE(svg.find(start), std::string::npos) << start;
        EXPECT_EQ(svg.find(start), svg.rfind(start)) << start;
    }
}

/// A tiling has a number at each of its lattice points, and a set one for each colour of each tile.
TEST(TileImage, NumbersColors)
{
    const auto numbers = [](const Drawing& drawing) {
        std::map<std::pair<double, double>, std::string> words;
        for (const Shape& shape : drawing.shapes) {
            const auto* const text = std::get_if<Text>(&shape.form);
            if (text == nullptr) continue;
            EXPECT_TRUE(words.try_emplace({text->start[0], text->start[1]}, text->words).second);
        }
        return words;
    };
    EXPECT_EQ(numbers(draw_tiles(tile_set_grid(TileSet::complete(TileKind::corner, 2)))).size(), 4u * 16);
    const Tiling tiling(DirectAlgorithm::corner, {3, 3}, HashKind::xxh64, 1);
    const auto of_tiling = numbers(draw_tiles(tiling_grid(tiling, {0, 0, 5, 4})));
    EXPECT_EQ(of_tiling.size(), 6u * 5);
    // The tile in the third column from the west and the second row from the south has its lower left corner there.
    EXPECT_EQ(of_tiling.at({8 + 2 * 32, 8 + 3 * 32 + 0.36 * 6}),
              std::to_string(corner_tile(tiling.tile(2, 1), 3).south_west));
    EXPECT_TRUE(numbers(draw_tiles(tiling_grid(tiling, {0, 0, 20, 20}))).empty());
}

TEST(TileImage, RefusesCubes)
{
    EXPECT_THROW(draw_tiles(tile_set_grid(TileSet::complete(TileKind::cube, 2))), std::logic_error);
}

TEST(TileImage, DominoesAreTwoHalves)
{
    const TileGrid grid{TileKind::domino, {4, 4}, 2, {domino_index({2, 1}, 4), domino_index({3, 2}, 4)}, false};
    const Drawing drawing = draw_tiles(grid);
    EXPECT_EQ(drawing.width, 16 + 64);
    EXPECT_EQ(drawing.height, 16 + 32);
    const test::Pixels pixels(drawing, 10);
    EXPECT_EQ(pixels.at(16, 14), tile_color(1));
    EXPECT_EQ(pixels.at(32, 14), tile_color(2));
    EXPECT_EQ(pixels.at(48, 14), tile_color(2));
    EXPECT_EQ(pixels.at(64, 14), tile_color(3));
}

}
}
