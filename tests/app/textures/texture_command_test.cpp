// poissonlab texture: build, verify and tile from the command line, and what they say about wrong arguments.
#include "base/images/png_file.hpp"
#include "tests/support/command_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>
#include <sstream>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class TextureCommand : public test::CommandTest
{
protected:
    TextureCommand() : CommandTest("texture")
    {
        PngPixels noise{120, 110, 3, {}};
        std::mt19937 random(3);
        for (int i = 0; i < 120 * 110 * 3; ++i) noise.values.push_back(static_cast<std::uint8_t>(random()));
        write_png(folder_.path() / "noise.png", {120, 110, 3},
                  [&](int row, int) { return &noise.values[noise.at(0, row, 0)]; });
    }
};

TEST_F(TextureCommand, BuildsVerifiesAndTiles)
{
    for (const std::string kind : {"corner --colors 2", "wang --colors 2", "omega --colors 4"}) {
        const std::string name = kind.substr(0, kind.find(' '));
        EXPECT_THAT(printed("build " + kind + " --exemplar noise.png --size 16 --attempts 3 --out " + name),
                    HasSubstr(name + ": 16 tiles of 16 x 16 pixels from "));
        EXPECT_THAT(printed("verify " + name), HasSubstr("all others are contiguous"));
        EXPECT_THAT(printed("verify " + name + " --json"),
                    AllOf(HasSubstr("\"tiles\": 16"), HasSubstr("\"seam_mismatch\": "), HasSubstr("\"novelty\": "),
                          HasSubstr("\"slow_power\": "), HasSubstr("\"largest_seam_line\": ")));
        EXPECT_THAT(printed("verify " + name), HasSubstr("patches of 27 x 27 pixels of a tiling are new"));
        printed("tile " + name + " --window 0 0 5 3 --out " + name + ".png");
        const PngPixels picture = read_png(folder_.path() / (name + ".png"));
        EXPECT_EQ(picture.width, 5 * 16);
        EXPECT_EQ(picture.height, 3 * 16);
        EXPECT_EQ(picture.channels, 3);
    }
    printed("tile corner --window -7 1000000000000 2 2 --seed 5 --out far.png");
    expect_error("tile omega --window 1 0 2 2 --out a.png",
                 "texture tile: a window at 1 0: must be at 0 0, since these tiles are laid in scanlines");
}

/// Sixteen tiles recur, more than sixteen independent ones would; large tiles of a small exemplar have a number as
/// well.
TEST_F(TextureCommand, SaysWhatRecurs)
{
    const std::string build = "build corner --colors 2 --exemplar noise.png --size 16 --attempts 3 --out tiles";
    EXPECT_THAT(printed(build),
                HasSubstr(" % of a tiling's power recurs every 16 pixels, beyond chance: more than the 5 "
                          "% that an eye notices\n"));
    const auto built = nlohmann::json::parse(printed(build + " --json")),
               verified = nlohmann::json::parse(printed("verify tiles --json"));
    EXPECT_GT(built["recurrence"].get<double>(), 1.0 / 16);
    EXPECT_NEAR(built["recurrence"].get<double>(), verified["recurrence"].get<double>(), 1e-12) << "seed 1 of both";
    EXPECT_THAT(printed("verify tiles"), HasSubstr(" % of a tiling's power recurs every 16 pixels"));
    EXPECT_EQ(printed(build + " --quiet"), "");
    EXPECT_TRUE(nlohmann::json::parse(printed("build corner --colors 2 --exemplar noise.png --size 64 --attempts 1 "
                                              "--candidates 1 --out large --json"))
                    .contains("recurrence"));
}

TEST_F(TextureCommand, MapsThePlane)
{
    printed("build corner --colors 2 --exemplar noise.png --size 16 --attempts 3 --quiet --out tiles");
    const std::string small = "map tiles --size 40 30 --tile -5 1000000000000 ";
    printed(small + "--out a.png");
    printed(small + "--out b.png --engine reference");
    EXPECT_EQ(read_png(folder_.path() / "a.png").values, read_png(folder_.path() / "b.png").values);
    EXPECT_EQ(read_png(folder_.path() / "a.png").width, 40);
    printed(small + "--frames 2 --advance 3 --out fly.png --engine reference");
    EXPECT_EQ(read_png(folder_.path() / "fly-00000.png").values, read_png(folder_.path() / "a.png").values);
    EXPECT_NE(read_png(folder_.path() / "fly-00001.png").values, read_png(folder_.path() / "a.png").values);
    expect_error(small + "--out a.jpg", "texture map: --out a.jpg: must end in .png");
    expect_error(small + "--pitch 91 --out a.png", "texture map: --pitch 91: must be a number from 0 to 90");
    expect_error("map tiles --size 0 2 --out a.png", "texture map: --size 0: must be an integer from 1 to 16384");
    expect_error("map tiles --size 9 --out a.png", "texture map: --size 9: must be W H");
    expect_error(
        small + "--filter trilinear --out a.png",
        "texture map: --filter trilinear: must be one of \"anisotropic\", \"nearest\", \"bilinear\", \"mipmap\"; "
        "did you mean \"bilinear\"?");
    printed("build wang --colors 2 --exemplar noise.png --size 16 --attempts 3 --quiet --out wang");
    printed("map wang --size 40 30 --out c.png");
    printed("map wang --size 40 30 --out d.png --engine reference");
    EXPECT_EQ(read_png(folder_.path() / "c.png").values, read_png(folder_.path() / "d.png").values);
    printed("build wang --colors 2 --tiles compact --exemplar noise.png --size 16 --attempts 3 --quiet --out eight");
    expect_error(
        "map eight --lookup exact --out e.png",
        "eight: --lookup exact: is for complete sets of corner or Wang tiles, which a hash lays; must be repeated");
    expect_error("map eight --laid 10 --out e.png", "texture map: --laid 10: must be 4, 9, 16, 25, 36, 49 or 64");
    expect_error("map wang --laid 16 --out e.png",
                 "wang: --laid 16: is for sets without a hash, which are laid in scanlines; this is a complete set of "
                 "corner or Wang tiles");
    expect_error("export wang --relief 4 --out e",
                 "texture export: --relief: needs --normals: it sets the height that the normals are for");
}

/// Tiles without a hash are laid in a window first: omega, compact and marked ones; the window repeats.
TEST_F(TextureCommand, MapsAWindowOfTilesThatAreLaid)
{
    const std::vector<std::string> kinds{"omega --colors 4", "wang --colors 2 --tiles compact",
                                         "wang --colors 2 --tiles random-marks --marked-exemplar noise.png"};
    for (const std::string& kind : kinds) {
        SCOPED_TRACE(kind);
        printed("build " + kind + " --exemplar noise.png --size 16 --attempts 2 --candidates 1 --quiet --out laid");
        // A marked exemplar is another picture beside the first one, which nothing judges.
        const bool is_judged = kind.find("marked") == std::string::npos;
        EXPECT_EQ(printed("verify laid").find("tiling are new") != std::string::npos, is_judged);
        EXPECT_EQ(printed("verify laid --json").find("\"feature_side\"") != std::string::npos, is_judged);
        const std::string map =
            "map laid --size 64 64 --above 2 --pitch 90 --field 90 --filter nearest --seed 7 --laid 16 ";
        printed(map + "--tile 23 -8 --engine reference --out map.png"); // one window farther east and south of (7, 8)
        printed("tile laid --window 0 0 16 16 --seed 7 --out tile.png");
        const PngPixels shown = read_png(folder_.path() / "map.png"), tile = read_png(folder_.path() / "tile.png");
        for (int row = 0; row < 64; ++row)
            for (int i = 0; i < 3 * 64; ++i)
                ASSERT_EQ(shown.values[shown.at(0, row, i)], tile.values[tile.at(88, row + 88, i)])
                    << i / 3 << " " << row;
    }
}

/// Straight above, with a texel a pixel, the map is what `texture tile` draws: its middle is that of tile (-3, 5).
TEST_F(TextureCommand, MapsThePlaneThatItDraws)
{
    for (const std::string kind : {"corner", "wang"}) {
        printed("build " + kind + " --colors 3 --exemplar noise.png --size 16 --attempts 2 --quiet --out " + kind);
        printed("map " + kind +
                " --size 64 64 --tile -3 5 --above 2 --pitch 90 --field 90 --filter nearest --seed 7 "
                "--engine reference --out map.png");
        printed("tile " + kind + " --window -5 3 5 5 --seed 7 --out tile.png");
        const PngPixels map = read_png(folder_.path() / "map.png"), tile = read_png(folder_.path() / "tile.png");
        ASSERT_EQ(tile.width, 80);
        for (int row = 0; row < 64; ++row)
            for (int i = 0; i < 3 * 64; ++i)
                ASSERT_EQ(map.values[map.at(0, row, i)], tile.values[tile.at(8, row + 8, i)]) << i / 3 << " " << row;
    }
}

/// Other methods are mapped as pictures of a window: 4 x 4 tiles, rows from the south.
TEST_F(TextureCommand, MapsPictures)
{
    printed("endless hexagons --exemplar noise.png --window 0 0 256 256 --quiet --engine reference --out hexagons.png");
    printed("map hexagons.png --size 256 256 --tile 1 2 --above 2 --pitch 90 --field 90 --filter nearest --engine "
            "reference "
            "--out map.png");
    const PngPixels map = read_png(folder_.path() / "map.png"), picture = read_png(folder_.path() / "hexagons.png");
    // The middle of the map is that of tile (1, 2), from the lower left; a tile has 64 pixels.
    for (int row = 0; row < 256; ++row)
        for (int column = 0; column < 256; ++column)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(map.values[map.at(column, row, c)],
                          picture.values[picture.at((column + 96 + 128) % 256, (row + 96 + 128) % 256, c)])
                    << column << " " << row;
    expect_error("map hexagons.png --lookup exact --out a.png",
                 "hexagons.png: --lookup exact: is for texture sets; must be repeated");
}

/// Other methods are mapped as the functions of the plane that `texture endless` draws, anywhere, or in a window around
/// the camera: straight above the middle of tile (10^9 + 7, -5), 128 x 128 pixels of them. Blends of light are rounded
/// once more.
TEST_F(TextureCommand, MapsOtherTexturesAroundTheCamera)
{
    const std::string small = " --above 1 --pitch 90 --field 90 --filter nearest --engine reference --seed 3 --out ";
    for (const std::string method : {"repeated", "offsets --restored", "hexagons --gain 2 --cell 20", "blended"}) {
        SCOPED_TRACE(method);
        const std::string view = " --size 128 128 --tile 1000000007 -5" + small;
        printed("map noise.png --method " + method + " --laid 4" + view + "m.png");
        printed("map noise.png --method " + method + view + "far.png");
        printed("endless " + method + " --exemplar noise.png --window 64000000416 224 128 128 --seed 3 --quiet " +
                "--engine reference --out e.png");
        const PngPixels expected = read_png(folder_.path() / "e.png"), far = read_png(folder_.path() / "far.png");
        EXPECT_EQ(read_png(folder_.path() / "m.png").values, expected.values);
        for (std::size_t i = 0; i < far.values.size(); ++i)
            ASSERT_LE(std::abs(int{far.values[i]} - int{expected.values[i]}), 1) << i;
    }
    printed("endless quilted --exemplar noise.png --block 32 --window 0 0 256 256 --seed 3 --quiet --out q.png");
    printed("map noise.png --method quilted --block 32 --laid 4 --size 99 70 --tile 1 2" + small + "m.png");
    printed("map q.png --size 99 70 --tile 1 2" + small + "e.png");
    EXPECT_EQ(read_png(folder_.path() / "m.png").values, read_png(folder_.path() / "e.png").values);
    expect_error("map noise.png --method blended --tile 0 -35184372088833 --out a.png",
                 "noise.png: --tile 0 -35184372088833: must be within 2^45 tiles");
    expect_error("map noise.png --cell 40 --out a.png",
                 "texture map: --cell 40: is for --method offsets, hexagons, blended");
    expect_error("map noise.png --method hexagons --block 99 --out a.png",
                 "texture map: --block 99: is for --method quilted");
    expect_error("map noise.png --method hexagon --out a.png",
                 "texture map: --method hexagon: must be one of \"repeated\", \"offsets\", \"hexagons\", \"blended\", "
                 "\"quilted\"; did you mean \"hexagons\"?");
    expect_error("map nothing.png --method hexagons --out a.png", "nothing.png: no such picture, and no such folder");
    printed("build corner --colors 2 --exemplar noise.png --size 16 --attempts 1 --candidates 1 --quiet --out set");
    expect_error("map set --method hexagons --out a.png",
                 "set: --method hexagons: is for pictures; this is a texture set");
}

/// A switch that takes on or off means on by itself, before another option and at the end.
TEST_F(TextureCommand, TakesSwitchesByThemselves)
{
    const std::string build = "build corner --colors 2 --exemplar noise.png --size 16 --rounds 1 --quiet ";
    printed(build + "--joint --out a");
    printed(build + "--out b --joint");
    printed(build + "--joint on --out c");
    printed(build + "--joint auto --out e");
    printed(build + "--out f");
    EXPECT_EQ(read_png(folder_.path() / "e" / "atlas.png").values, read_png(folder_.path() / "f" / "atlas.png").values);
    const PngPixels expected = read_png(folder_.path() / "c" / "atlas.png");
    EXPECT_EQ(read_png(folder_.path() / "a" / "atlas.png").values, expected.values);
    EXPECT_EQ(read_png(folder_.path() / "b" / "atlas.png").values, expected.values);
    expect_error(build + "--joint on --joint off --out d", "texture build: --joint: is given twice");
}

TEST_F(TextureCommand, MakesTilesWithMarkedCorners)
{
    const std::string build = "build wang --colors 2 --exemplar noise.png --marked-exemplar noise.png --size 16 "
                              "--attempts 2 --quiet ";
    printed(build + "--tiles compact --out mapped");
    printed(build + "--tiles random-marks --out random");
    EXPECT_THAT(printed("verify mapped"), HasSubstr("mapped: 128 wang tiles"));
    EXPECT_THAT(printed("verify random"), HasSubstr("random: 64 wang tiles"));
    printed("tile mapped --window 0 0 5 3 --marks noise.png --out a.png");
    printed("tile random --window 0 0 5 3 --out b.png");
    expect_error("tile random --window 0 0 5 3 --marks noise.png --out c.png",
                 "texture tile: a map of marks leaves no choice of these tiles, which are for marks at random");
    expect_error("build wang --colors 2 --exemplar noise.png --size 16 --tiles random-marks --out o",
                 "texture build: --tiles random-marks: needs an exemplar for marked corners");
}

TEST_F(TextureCommand, MakesTheSameFilesAgain)
{
    printed("build corner --colors 2 --exemplar noise.png --size 16 --attempts 3 --quiet --out a");
    printed("build corner --colors 2 --exemplar noise.png --size 16 --attempts 3 --quiet --out b");
    EXPECT_EQ(files_below(folder_.path() / "a"), files_below(folder_.path() / "b"));
}

TEST_F(TextureCommand, WrongArguments)
{
    const std::string corner = "build corner --exemplar noise.png --out o ";
    expect_error("build triangle --colors 2 --exemplar noise.png --size 16 --out o",
                 "texture build: KIND triangle: must be one of \"corner\", \"wang\", \"omega\"");
    expect_error(corner + "--colors 2 --size 17", "texture build: --size 17: must be even");
    expect_error(corner + "--colors 9 --size 16", "texture build: --colors 9: must be an integer from 2 to 8");
    expect_error(corner + "--colors 2 --size 112",
                 "noise.png: size = 112: must be at most the exemplar's, 120 x 110 pixels");
    expect_error(corner + "--colors 2 --size 16 --ring 9", "texture build: --ring 9: must be 1 or 2");
    expect_error(
        corner + "--colors 2 --size 16 --weight gradeint",
        "texture build: --weight gradeint: must be one of \"plain\", \"gradient\"; did you mean \"gradient\"?");
    expect_error("build corner --colors 2 --size 16 --exemplar none.png --out o",
                 "texture build: --exemplar none.png: no such file: must be a picture's file");
    expect_error("build corner --colors 2 --size 16 --exemplar noise.png --out noise.png",
                 "texture build: --out noise.png: is a file; a folder is needed");
    expect_error("build corner --colors 2 --size 16 --exemplar /dev/null --out o",
                 "texture build: --exemplar /dev/null: is a device, no file: must be a picture's file");
    const std::string whole = content_of(folder_.path() / "noise.png");
    folder_.write("cut.png", whole.substr(0, whole.size() / 2));
    expect_error(
        "build corner --colors 2 --size 16 --exemplar cut.png --out o",
        "texture build: --exemplar: cut.png: cannot read the picture: the file is cut off"); // and no line of libpng's
    expect_error("build corner --colors 2 --size large --exemplar noise.png --out o",
                 "texture build: --size large: must be an integer from 16 to 512");
    folder_.write("text.png", "no picture");
    EXPECT_EQ(run("build corner --colors 2 --size 16 --exemplar text.png --out o").status, 2);
    EXPECT_EQ(run("verify .").status, 2);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "o"));
}

}
}
