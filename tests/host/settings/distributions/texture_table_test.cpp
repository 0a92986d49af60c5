// Tables [[texture]] and [[packing]] of a config, and what they refuse.
#include "host/settings/distributions/texture_config.hpp"

#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/exhibits.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Exhibit> textures_of(const std::string& lines) { return exhibits_in("seed = 7\n[[texture]]\n" + lines); }

std::vector<Exhibit> packings_of(const std::string& lines) { return exhibits_in("seed = 7\n[[packing]]\n" + lines); }

void expect_texture_refusal(const std::string& lines, const std::string& message)
{
    EXPECT_THAT(message_of([&] { textures_of(lines); }), HasSubstr(message)) << lines;
}

void expect_packing_refusal(const std::string& lines, const std::string& message)
{
    EXPECT_THAT(message_of([&] { packings_of(lines); }), HasSubstr(message)) << lines;
}

TEST(TextureTable, ReadsATexture)
{
    const auto read = textures_of("kind = \"omega\"\npattern = \"noise\"\nstages = 1\nsmooth = true\nsets = 3\n"
                                  "window = [5, 2]\nshow = [\"tiling\", \"seams\"]\nring = 2");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].kind->name(), "texture");
    EXPECT_EQ(read[0].label, "Noise: 16 omega tiles, one stage, smoothed");
    const auto& settings = read[0].settings.as<TextureSettings>();
    EXPECT_EQ(settings.request.kind, TextureKind::omega);
    EXPECT_EQ(settings.request.colors.horizontal, 4u);
    EXPECT_EQ(settings.request.ring, 2);
    EXPECT_EQ(read[0].seed, 7u);
    EXPECT_EQ(settings.sets, 3);
    EXPECT_EQ(settings.columns, 5u);
    EXPECT_EQ(settings.rows, 2u);
    EXPECT_THAT(settings.show, ElementsAre("tiling", "seams"));
}

/// Sets are chosen together where nothing speaks against it, and judged where they have corners and nothing is asked
/// for.
TEST(TextureTable, ChoosesSmallSetsTogether)
{
    const std::map<std::string, bool> tables{
        {"", true},
        {"kind = \"wang\"", true},
        {"kind = \"wang\"\ntiles = \"compact\"", true},
        {"kind = \"omega\"", true},
        {"stages = 3\nweight = \"plain\"", true},
        {"colors = 4\nsize = 90", true},  // 256 tiles, fewer than 2^21 pixels
        {"colors = 4\nsize = 92", false}, // more pixels
        {"colors = 5\nsize = 16", false}, // more tiles
        {"stages = 1", false},
        {"stages = 0", false},
        {"weight = \"gradient\"", false},
        {"kind = \"wang\"\ncut = \"path\"", false},
        {"kind = \"wang\"\noverlap = 0.125", false},
        {"smooth = true", false},
        {"joint = false", false},
        {"colors = 5\nsize = 16\njoint = true", true},
        {"joint = \"auto\"", true},
        {"stages = 1\njoint = \"auto\"", false},
    };
    for (const auto& [lines, is_joint] : tables) {
        const auto read = textures_of("pattern = \"noise\"\n" + lines);
        const auto& settings = read[0].settings;
        EXPECT_EQ(settings.as<TextureSettings>().request.joint, is_joint) << lines;
        const bool is_given = lines.find("joint = t") != lines.npos || lines.find("joint = f") != lines.npos;
        EXPECT_EQ(settings.as<TextureSettings>().request.is_judged,
                  is_joint && !is_given && lines.find("wang") == lines.npos)
            << lines;
        EXPECT_THAT(settings.resolved, HasSubstr(!is_given  ? "joint = auto"
                                                 : is_joint ? "joint = true"
                                                            : "joint = false"))
            << lines;
    }
}

TEST(TextureTable, ReadsEndlessTexturesWithoutTiles)
{
    const auto read = textures_of("kind = \"hexagons\"\npattern = \"noise\"\ngain = 2\nrestored = true\ncell = 40");
    EXPECT_EQ(read[0].label, "Noise: hex-tiling, gain of 2, variance restored");
    const auto& settings = read[0].settings.as<TextureSettings>();
    ASSERT_TRUE(settings.endless);
    EXPECT_EQ(settings.endless->method, EndlessMethod::hexagons);
    EXPECT_EQ(settings.endless->gain, 2);
    EXPECT_EQ(settings.endless->cell, 40);
    EXPECT_THAT(settings.show, ElementsAre("exemplar", "tiling", "plane"));
    expect_texture_refusal("kind = \"hexagons\"\npattern = \"noise\"\ncolors = 3", "is for tiles");
    expect_texture_refusal("pattern = \"noise\"\ncell = 40", "cell = 40: is for kind = \"offsets\", \"hexagons\"");
    expect_texture_refusal("kind = \"hexagons\"\npattern = \"noise\"\ncell = 200", "cell = 200: must be at most 126");
}

TEST(TextureTable, FindsPicturesFromTheConfigsFolder)
{
    const TemporaryFolder folder;
    folder.write("a.pgm", "P2 1 1 255\n7\n");
    const auto read = exhibits_in("[[texture]]\nexemplar = \"a.pgm\"\n", (folder.path() / "c.toml").string());
    EXPECT_EQ(read[0].settings.as<TextureSettings>().exemplar, folder.path() / "a.pgm");
    EXPECT_THAT(read[0].settings.inputs, ElementsAre(folder.path() / "a.pgm"));
}

/// Sizes and names are checked before any work, and what companions hold decides stored results.
TEST(TextureTable, ChecksCompanions)
{
    const TemporaryFolder folder;
    const std::vector<std::uint8_t> grey(12 * 12);
    for (const auto& [name, height] : std::map<std::string, int>{{"a.png", 12}, {"b.png", 12}, {"low.png", 10}})
        write_png(folder.path() / name, {12, height, 1},
                  [&](int row, int) { return &grey[static_cast<std::size_t>(12 * row)]; });
    const std::string config = (folder.path() / "c.toml").string(), at = folder.path().string() + "/";
    const auto read = exhibits_in("[[texture]]\nexemplar = \"a.png\"\nalso = [\"b.png\"]\n", config);
    EXPECT_THAT(read[0].settings.as<TextureSettings>().also, ElementsAre(folder.path() / "b.png"));
    EXPECT_THAT(read[0].settings.inputs, ElementsAre(folder.path() / "a.png", folder.path() / "b.png"));
    const auto refusal = [&](const std::string& also) {
        return message_of([&] { exhibits_in("[[texture]]\nexemplar = \"a.png\"\nalso = " + also + "\n", config); });
    };
    EXPECT_EQ(refusal("[\"b.png\", \"low.png\"]"),
              config + ":3: also: " + at + "low.png: 12 x 10 pixels: must have 12 x 12, as " + at + "a.png has");
    EXPECT_EQ(refusal("[\"b.png\", \"b.png\"]"),
              config + ":3: also: " + at + "b.png: is called as " + at + "b.png is: both would be atlas-b");
    EXPECT_THAT(refusal("[7]"), HasSubstr(":3: also = [7]: must be a list of pictures' files, in quotes"));
    EXPECT_THAT(refusal("\"c.png\""),
                HasSubstr(":3: also = \"c.png\": no such file: must be a list of pictures' files"));
    expect_texture_refusal("pattern = \"noise\"\nalso = [\"" + at + "b.png\"]", "needs exemplar");
}

TEST(TextureTable, RefusesWhatCannotBe)
{
    expect_texture_refusal("kind = \"corner\"", "c.toml:2: [[texture]]: needs exemplar, a picture's file, or pattern");
    expect_texture_refusal("pattern = \"noise\"\nmarks = \"x.png\"",
                           "c.toml:4: marks = \"x.png\": no such file: must be a picture's file");
    expect_texture_refusal("exemplar = \"none.png\"",
                           "c.toml:3: exemplar = \"none.png\": no such file: must be a picture's file");
    expect_texture_refusal("exemplar = \"/dev/null\"", "exemplar = \"/dev/null\": is a device, no file: must be");
    expect_texture_refusal("pattern = \"noise\"\nsize = 24\ntiming = true",
                           "c.toml:5: timing = true: is for complete sets of tiles whose size is a power of two");
    expect_texture_refusal("pattern = \"nois\"", "c.toml:3: pattern = \"nois\": must be one of \"noise\"");
    expect_texture_refusal("pattern = \"noise\"\nkind = \"wangs\"", "c.toml:4: kind = \"wangs\": must be");
    expect_texture_refusal("pattern = \"noise\"\nsize = 17", "c.toml:4: size = 17: must be even");
    expect_texture_refusal("pattern = \"noise\"\nstages = 2", "c.toml:4: stages = 2: must be 0, 1 or 3");
    expect_texture_refusal("pattern = \"noise\"\nshow = [\"all\"]", "c.toml:4: show = ");
    for (const std::string tiles : {"kind = \"wang\"\ntiles = \"compact\"", "kind = \"omega\"", "size = 48"})
        expect_texture_refusal("pattern = \"noise\"\nshow = [\"levels\"]\n" + tiles,
                               "\"levels\" is for complete sets of tiles whose size is a power of two");
    expect_texture_refusal("pattern = \"noise\"\nshow = [\"plane\"]\nsize = 48",
                           "\"plane\" is for tiles whose size is a power of two");
    expect_texture_refusal("pattern = \"noise\"\nshow = [\"marks\"]", "\"marks\" needs marked_exemplar");
    expect_texture_refusal("pattern = \"noise\"\nkind = \"wang\"\ntiles = \"random-marks\"",
                           "c.toml:5: tiles = \"random-marks\": needs an exemplar for marked corners");
    expect_texture_refusal("pattern = \"noise\"\nwindow = [65, 1]", "must have at most 64 tiles along each side");
    expect_texture_refusal("pattern = \"noise\"\nsets = 0", "c.toml:4: sets = 0: must be an integer from 1 to 1000");
    expect_texture_refusal("pattern = \"noise\"\ncolour = 3", "c.toml:4: colour");
}

TEST(PackingTable, ReadsAPacking)
{
    const auto read = packings_of("kind = \"wang\"\ncolors = 3\nmethod = \"eulerian\"");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].kind->name(), "packing");
    EXPECT_EQ(read[0].label, "Eulerian packing of Wang tiles, 3 colours");
    const auto& settings = read[0].settings.as<PackingSettings>();
    EXPECT_EQ(settings.kind, TileKind::wang);
    EXPECT_EQ(settings.colors, 3u);
    EXPECT_EQ(settings.show, "tiles");
}

TEST(PackingTable, RefusesWhatCannotBe)
{
    expect_packing_refusal("method = \"eulerian\"", "c.toml:3: method = \"eulerian\": is for wang tiles");
    expect_packing_refusal("method = \"printed\"\ncolors = 5", "method = \"printed\": has at most 4 colours");
    expect_packing_refusal("method = \"search\"\ncolors = 4", "takes years for more than 3 colours");
    expect_packing_refusal("method = \"grown\"", "is for corner tiles of 3 colours");
    expect_packing_refusal("colors = 17", "c.toml:3: colors = 17: must be at most 16 for a picture");
    expect_packing_refusal("show = \"tile\"", "c.toml:3: show = \"tile\": must be");
}

}
}
