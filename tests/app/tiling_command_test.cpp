// poissonlab tiling: what it prints is what the library tiles, and what it says about wrong arguments.
#include "tests/support/command_test.hpp"
#include "tiles/tilings/cube_tiling.hpp"
#include "tiles/tilings/scanline_tiling.hpp"
#include "tiles/tilings/tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace poissonlab {
namespace {

class TilingCommand : public test::CommandTest
{
protected:
    TilingCommand() : CommandTest("tiling") {}
};

std::string line_of(const std::vector<TileIndex>& tiles)
{
    std::string line;
    for (const TileIndex tile : tiles) line += (line.empty() ? "" : " ") + std::to_string(tile);
    return line + "\n";
}

/// Rows from north to south, tile by tile.
std::string text_of(const Tiling& tiling, std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height)
{
    std::string text;
    for (std::int64_t row = height; row-- > 0;) {
        std::vector<TileIndex> tiles;
        for (std::int64_t i = 0; i < width; ++i) tiles.push_back(tiling.tile(x + i, y + row));
        text += line_of(tiles);
    }
    return text;
}

TEST_F(TilingCommand, PrintsRowsFromNorthToSouth)
{
    const auto long_period = HashKind::long_period;
    EXPECT_EQ(printed("corner --colors 3 --window -4 -2 6 5"),
              text_of(Tiling(DirectAlgorithm::corner, {3, 3}, long_period, 1), -4, -2, 6, 5));
    EXPECT_EQ(printed("wang --colors 2 --seed 7 --window 5 6 7 8"),
              text_of(Tiling(DirectAlgorithm::wang_edge_hash, {2, 2}, long_period, 7), 5, 6, 7, 8));
    EXPECT_EQ(printed("wang --colors 4 --algorithm two-hashes --hash xxh64 --window 0 0 3 3"),
              text_of(Tiling(DirectAlgorithm::wang_two_hashes, {4, 4}, HashKind::xxh64, 1), 0, 0, 3, 3));
    EXPECT_EQ(printed("wang --colors 5 --algorithm one-hash --hash permutation --window 0 0 3 3"),
              text_of(Tiling(DirectAlgorithm::wang_one_hash, {5, 5}, HashKind::permutation, 1), 0, 0, 3, 3));
    EXPECT_EQ(printed("corner --colors 2 --period 3 0 --window 0 0 7 7"),
              text_of(Tiling(DirectAlgorithm::corner, {2, 2}, long_period, 1, {3, 0, 0}), 0, 0, 7, 7));
    EXPECT_EQ(printed("corner --colors 2 --period 3 4 --window -9 0 7 7"),
              text_of(Tiling(DirectAlgorithm::corner, {2, 2}, long_period, 1, {3, 4, 0}), -9, 0, 7, 7));
}

TEST_F(TilingCommand, PrintsLongRowsOnOneLineEach)
{
    EXPECT_EQ(printed("corner --colors 2 --window 0 0 20000 2"),
              text_of(Tiling(DirectAlgorithm::corner, {2, 2}, HashKind::long_period, 1), 0, 0, 20'000, 2));
}

TEST_F(TilingCommand, ReachesTheEndsOfTheCoordinates)
{
    const Tiling tiling(DirectAlgorithm::corner, {2, 2}, HashKind::long_period, 1);
    EXPECT_EQ(printed("corner --colors 2 --window 9223372036854775806 -9223372036854775808 3 1"),
              line_of({tiling.tile(INT64_MAX - 1, INT64_MIN), tiling.tile(INT64_MAX, INT64_MIN),
                       tiling.tile(INT64_MIN, INT64_MIN)}));
}

TEST_F(TilingCommand, PrintsCubesLayerByLayer)
{
    const CubeTiling tiling(2, HashKind::long_period, 1);
    std::string expected;
    for (const std::int64_t z : {-1, 0}) {
        expected += z == -1 ? "" : "\n";
        for (const std::int64_t y : {6, 5, 4}) expected += line_of({tiling.tile(-1, y, z), tiling.tile(0, y, z)});
    }
    EXPECT_EQ(printed("cube --colors 2 --window -1 4 -1 2 3 2"), expected);
}

TEST_F(TilingCommand, PrintsWangCubesDominoesAndTwoNumbersOfColors)
{
    const CubeTiling cubes(3, HashKind::xxh64, 1, {}, TileKind::wang_cube);
    EXPECT_EQ(printed("wang-cube --colors 3 --hash xxh64 --window -1 4 -1 2 1 2"),
              line_of({cubes.tile(-1, 4, -1), cubes.tile(0, 4, -1)}) + "\n" +
                  line_of({cubes.tile(-1, 4, 0), cubes.tile(0, 4, 0)}));
    const DominoTiling dominoes(5, HashKind::long_period, 2, 3);
    EXPECT_EQ(printed("domino --colors 5 --seed 2 --period 3 --window -2 4"),
              line_of({dominoes.tile(-2), dominoes.tile(-1), dominoes.tile(0), dominoes.tile(1)}));
    for (const auto& [word, algorithm] : {std::pair{"edge-hash", DirectAlgorithm::wang_edge_hash},
                                          std::pair{"two-hashes", DirectAlgorithm::wang_two_hashes}})
        EXPECT_EQ(printed(std::string("wang --colors 2 --vertical-colors 5 --window -2 3 4 2 --algorithm ") + word),
                  text_of(Tiling(algorithm, {2, 5}, HashKind::long_period, 1), -2, 3, 4, 2));
}

TEST_F(TilingCommand, PrintsScanlineTilings)
{
    for (const bool is_compact : {false, true}) {
        const TileSet corner = is_compact ? compact_corner_set(3) : TileSet::complete(TileKind::corner, 3);
        const TileSet wang = is_compact ? compact_wang_set(3) : TileSet::complete(TileKind::wang, 3);
        for (const TileSet& set : {corner, wang}) {
            ScanlineTiling tiling(set, 9, 4);
            std::string expected;
            tiling.stream(3, [&](auto, auto, std::span<const TileIndex> tiles) {
                expected += line_of({tiles.begin(), tiles.end()});
            });
            EXPECT_EQ(printed(std::string(set.kind() == TileKind::corner ? "corner" : "wang") +
                              " --colors 3 --seed 4 --window 0 0 9 3 --algorithm scanline" +
                              (is_compact ? "-compact" : "")),
                      expected);
        }
    }
}

TEST_F(TilingCommand, TilesAreTheSameForEver)
{
    // Tilings are part of results: these must not change.
    EXPECT_EQ(printed("corner --colors 2 --window -2 -2 6 3"), "6 14 11 5 10 9\n11 13 3 12 3 4\n7 14 7 10 1 12\n");
    EXPECT_EQ(printed("corner --colors 7 --hash permutation --window -2 -2 6 2"),
              "233 1302 2047 1811 649 1709\n1678 1810 2070 643 2248 2232\n");
    EXPECT_EQ(printed("corner --colors 5 --hash xxh64 --window -2 -2 6 2"),
              "59 535 559 489 248 71\n271 177 261 577 544 284\n");
    EXPECT_EQ(printed("wang --colors 3 --window 0 0 4 2 --seed 5"), "63 13 10 52\n14 46 8 54\n");
    EXPECT_EQ(printed("wang --colors 3 --algorithm two-hashes --window 0 0 4 2"), "67 46 41 67\n29 18 50 50\n");
    EXPECT_EQ(printed("wang --colors 3 --algorithm scanline --window 0 0 4 2"), "6 33 72 53\n76 65 13 64\n");
    EXPECT_EQ(printed("cube --colors 2 --window -1 -1 -1 3 1 2"), "17 204 183\n\n193 188 91\n");
}

TEST_F(TilingCommand, WrongArguments)
{
    expect_error("hexagon --colors 2 --window 0 0 1 1",
                 "tiling: KIND hexagon: must be one of \"corner\", \"wang\", \"cube\", \"wang-cube\", \"domino\"");
    expect_error("corner --window 0 0 1 1", "tiling: needs --colors");
    expect_error("corner --colors 2", "tiling: needs --window");
    expect_error("corner --colors 1 --window 0 0 1 1", "tiling: --colors 1: must be an integer from 2 to 256");
    expect_error("cube --colors 17 --window 0 0 0 1 1 1", "tiling: --colors 17: must be an integer from 2 to 16");
    expect_error("corner --colors 2.5 --window 0 0 1 1", "tiling: --colors 2.5: must be an integer from 2 to 256");
    expect_error("corner --colors 2 --seed -1 --window 0 0 1 1",
                 "tiling: --seed -1: must be an integer from 0 to 18446744073709551615 (see poissonlab tiling --help)");
    expect_error("corner --colors 2 --window 9223372036854775808 0 1 1",
                 "tiling: --window 9223372036854775808 0 1 1: must be [X, Y, width, height]");
    expect_error("corner --colors 2 --window 0 0 1", "tiling: --window 0 0 1: must be [X, Y, width, height]");
    expect_error("cube --colors 2 --window 0 0 1 1",
                 "tiling: --window 0 0 1 1: must be [X, Y, Z, width, height, depth]");
    expect_error("corner --colors 2 --window 0 0 0 1", "tiling: --window 0 0 0 1: sizes must be at least 1");
    expect_error(
        "wang --colors 2 --algorithm one-hsah --window 0 0 1 1",
        "tiling: --algorithm one-hsah: must be one of \"edge-hash\", \"two-hashes\", \"one-hash\", \"scanline\", "
        "\"scanline-compact\", \"culik\", \"kari\", \"ammann\"; did you mean \"one-hash\"?");
    expect_error("wang --colors 2 --hash md5 --window 0 0 1 1",
                 "tiling: --hash md5: must be one of \"permutation\", \"long-period\", \"xxh64\", \"two-tables\"");
    expect_error("corner --colors 2 --window 0 0 1 1 --period -1",
                 "tiling: --period -1: must be [MX, MY], or the first of these, integers of at least 0");
    expect_error("corner --colors 2 --window 0 0 1 1 --period 1 2 3",
                 "tiling: --period 1 2 3: must be [MX, MY], or the first of these, integers of at least 0");
    expect_error("corner --colors 2 --vertical-colors 3 --window 0 0 1 1",
                 "tiling: --vertical-colors 3: is for Wang tiles only");
    expect_error("wang --colors 2 --vertical-colors 3 --algorithm one-hash --window 0 0 1 1",
                 "tiling: colors = 2 x 3: this algorithm has one number of colours");
    expect_error("wang --colors 2 --vertical-colors 1 --window 0 0 1 1",
                 "tiling: --vertical-colors 1: must be an integer from 2 to 256");
    expect_error("wang-cube --colors 41 --window 0 0 0 1 1 1", "tiling: --colors 41: must be an integer from 2 to 40");
    expect_error("domino --colors 2 --window 0 0 1 1", "tiling: --window 0 0 1 1: must be [X, width]");
    expect_error("domino --colors 2 --window 0 1 --period 1 2",
                 "tiling: --period 1 2: must be [MX], integers of at least 0");
    expect_error("corner --colors 2 --algorithm scanline --window 3 0 1 1",
                 "tiling: --window 3 0 1 1: with --algorithm scanline, X and Y must be 0");
    expect_error("corner --colors 2 --algorithm scanline --hash xxh64 --window 0 0 1 1",
                 "tiling: --hash xxh64: has no place beside --algorithm scanline");
    expect_error("wang --colors 33 --algorithm scanline --window 0 0 1 1",
                 "tiling: colors = 33: must be at most 32 for a tiling by scanlines");
    expect_error("corner --colors 2 --algorithm scanline --window 0 0 9223372036854775807 1",
                 "tiling by scanlines: width = 9223372036854775807: must be at most 4294967296");
}

TEST_F(TilingCommand, SaysHowToUseIt)
{
    EXPECT_THAT(printed("--help"), testing::HasSubstr("--window X Y WIDTH HEIGHT"));
}

}
}
