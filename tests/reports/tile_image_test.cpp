// Pictures of tiles: every tile at its place, with its colours on the right sides.
#include "reports/tile_image.hpp"

#include "errors/errors.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace poissonlab {
namespace {

/// The filled shapes of a picture: colour and path, in order.
std::vector<std::pair<std::string, std::string>> shapes_of(const std::string& svg)
{
    const std::regex shape("<path fill=\"(#[0-9a-f]{6})\" d=\"([^\"]*)\"/>");
    std::vector<std::pair<std::string, std::string>> shapes;
    for (std::sregex_iterator at(svg.begin(), svg.end(), shape), end; at != end; ++at)
        shapes.emplace_back((*at)[1], (*at)[2]);
    return shapes;
}

std::vector<std::string> colors_of(const std::string& svg)
{
    std::vector<std::string> colors;
    for (const auto& [color, path] : shapes_of(svg)) colors.push_back(color);
    return colors;
}

TEST(TileImage, HasTheColorsOfThePapers)
{
    EXPECT_EQ(tile_color(0), "#ff0000");
    EXPECT_EQ(tile_color(1), "#ffff00");
    EXPECT_EQ(tile_color(2), "#00ff00");
    EXPECT_EQ(tile_color(3), "#00ffff");
    EXPECT_EQ(tile_color(4), "#0000ff");
    std::set<std::string> different;
    for (Color color = 0; color < 32; ++color) different.insert(tile_color(color));
    EXPECT_EQ(different.size(), 32u);
}

TEST(TileImage, WangTilesAreTrianglesOnTheirEdges)
{
    // A tile from (8, 8) to (40, 40); y points down. North red, east yellow, south green, west cyan.
    const TileSet one(TileKind::wang, {4, 4}, {wang_index({0, 1, 2, 3}, {4, 4})});
    EXPECT_EQ(shapes_of(tiles_svg(tile_set_grid(one))),
              (std::vector<std::pair<std::string, std::string>>{{"#ff0000", "M8 8l32 0L24 24z"},
                                                                {"#ffff00", "M40 8l0 32L24 24z"},
                                                                {"#00ff00", "M40 40l-32 0L24 24z"},
                                                                {"#00ffff", "M8 40l0 -32L24 24z"}}));
}

TEST(TileImage, CornerTilesAreQuartersOfDisksAtTheirCorners)
{
    // Each arc ends on the tile's other side: start, side, arc.
    const TileSet one(TileKind::corner, {4, 4}, {corner_index({0, 1, 2, 3}, 4)});
    EXPECT_EQ(shapes_of(tiles_svg(tile_set_grid(one))), (std::vector<std::pair<std::string, std::string>>{
                                                            {"#ff0000", "M40 8l0 11a11 11 0 0 1 -11 -11z"},
                                                            {"#ffff00", "M40 40l-11 0a11 11 0 0 1 11 -11z"},
                                                            {"#00ff00", "M8 40l0 -11a11 11 0 0 1 11 11z"},
                                                            {"#00ffff", "M8 8l11 0a11 11 0 0 1 -11 11z"}}));
}

TEST(TileImage, ShowsSetsInOrderWithGaps)
{
    const TileGrid grid = tile_set_grid(TileSet::complete(TileKind::corner, 2));
    EXPECT_EQ(grid.columns, 4u);
    EXPECT_EQ(grid.tiles.size(), 16u);
    const std::string svg = tiles_svg(grid);
    // Four tiles of 32, three gaps of 8, margins of 8.
    EXPECT_NE(svg.find("viewBox=\"0 0 168 168\""), std::string::npos);
    const auto colors = colors_of(svg);
    ASSERT_EQ(colors.size(), 64u);
    for (std::size_t tile = 0; tile < 16; ++tile) {
        for (std::size_t corner = 0; corner < 4; ++corner)
            EXPECT_EQ(colors[4 * tile + corner], tile_color(tile >> (3 - corner) & 1)); // binary digits
    }
    EXPECT_EQ(shapes_of(svg)[4].second.substr(0, 5),
              "M80 8"); // the second tile, one size and one gap further
    // Compact sets have rows that are not full.
    EXPECT_NE(tiles_svg(tile_set_grid(compact_wang_set(3), 4)).find("viewBox=\"0 0 168 208\""),
              std::string::npos);
}

TEST(TileImage, ShowsTilingsWithTheNorthAtTheTop)
{
    const Tiling tiling(DirectAlgorithm::wang_edge_hash, {3, 3}, HashKind::xxh64, 1);
    const TileGrid grid = tiling_grid(tiling, {-2, 5, 4, 3});
    const std::string svg = tiles_svg(grid);
    EXPECT_NE(svg.find("viewBox=\"0 0 144 112\""), std::string::npos);
    const auto shapes = shapes_of(svg);
    ASSERT_EQ(shapes.size(), 48u);
    for (std::int64_t row = 0; row < 3; ++row) {
        for (std::int64_t column = 0; column < 4; ++column) {
            const WangTile tile = wang_tile(tiling.tile(-2 + column, 7 - row), {3, 3});
            const auto first = static_cast<std::size_t>(4 * (4 * row + column));
            EXPECT_EQ(shapes[first].first, tile_color(tile.north));
            EXPECT_EQ(shapes[first + 1].first, tile_color(tile.east));
            EXPECT_EQ(shapes[first + 2].first, tile_color(tile.south));
            EXPECT_EQ(shapes[first + 3].first, tile_color(tile.west));
        }
    }
}

TEST(TileImage, RefusesWhatNobodyCanSee)
{
    EXPECT_THROW(tile_set_grid(TileSet::complete(TileKind::corner, 18)), InputError);
    const Tiling tiling(DirectAlgorithm::corner, {2, 2}, HashKind::xxh64, 1);
    EXPECT_THROW(tiling_grid(tiling, {0, 0, 1000, 101}), InputError);
    EXPECT_THROW(tiling_grid(tiling, {0, 0, std::uint64_t{1} << 63, 2}), InputError);
    EXPECT_NO_THROW(tiling_grid(tiling, {0, 0, 1000, 100}));
    EXPECT_THROW(tiles_svg(tile_set_grid(TileSet::complete(TileKind::cube, 2))), std::logic_error);
}

}
}
