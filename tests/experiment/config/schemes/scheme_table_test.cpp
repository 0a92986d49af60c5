// Tables [[scheme]] of a config, and what they refuse.
#include "host/kinds/kinds.hpp"
#include "host/schemes/scheme_settings.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/exhibits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::vector<Exhibit> schemes_of(const std::string& lines) { return exhibits_in("seed = 7\n[[scheme]]\n" + lines); }

template <class Settings>
Settings settings_of(const std::string& lines)
{
    return schemes_of(lines).at(0).settings.as<Settings>();
}

void expect_scheme_refusal(const std::string& lines, const std::string& message)
{
    EXPECT_THAT(message_of([&] { schemes_of(lines); }), HasSubstr(message)) << lines;
}

TEST(SchemeTable, ReadsEveryKindByItsDefaults)
{
    for (const std::string& kind : kind_words("scheme")) {
        const auto read = schemes_of("kind = \"" + kind + "\"");
        ASSERT_EQ(read.size(), 1) << kind;
        EXPECT_EQ(read[0].kind->word, kind);
        EXPECT_EQ(read[0].seed, 7);
        EXPECT_NE(read[0].label, "");
    }
}

TEST(SchemeTable, ReadsKeys)
{
    EXPECT_EQ(schemes_of("kind = \"noise\"\nlabel = \"L\"")[0].label, "L");
    const auto scanline =
        settings_of<ScanlineStepsSettings>("kind = \"scanline\"\ntiles = \"corner\"\ncolors = 4\nset = \"complete\"");
    EXPECT_EQ(scanline.tiles, TileKind::corner);
    EXPECT_EQ(scanline.colors, 4);
    EXPECT_FALSE(scanline.is_compact);
    const auto direct = settings_of<DirectTilingSettings>(
        "kind = \"direct\"\nalgorithm = \"edge-hash\"\nhash = \"xxh64\"\nwindow = [-3, 4, 5, 6]");
    EXPECT_EQ(direct.request.kind, TileKind::wang);
    EXPECT_EQ(direct.request.hash, HashKind::xxh64);
    EXPECT_EQ(direct.window.height, 6);
    const auto diffraction =
        settings_of<DiffractionSettings>("kind = \"diffraction\"\ntilings = [\"kari\", \"direct\"]\ncolors = 3");
    ASSERT_EQ(diffraction.tilings.size(), 2);
    EXPECT_EQ(diffraction.tilings[0].colors, 6);
    EXPECT_EQ(diffraction.tilings[1].kind, TileKind::corner);
    EXPECT_EQ(diffraction.tilings[1].colors, 3);
    const auto isohedral = settings_of<IsohedralSettings>(
        "kind = \"isohedral\"\ntype = 1\nparameters = [0.1, 0, 0, 0]\ncurves = [[[0.5, 0.1]]]\n"
        "coloring = { colors = 3, aspects = [1], steps = [1, 2] }\nwindow = [4, 5]");
    EXPECT_EQ(isohedral.parameters.curves.at(0).size(), 3);
    EXPECT_EQ(isohedral.coloring->of({0, 1, 1}), 1);
    EXPECT_EQ(settings_of<SurfaceSettings>("kind = \"surface\"\ncubes = [[0, 0, 0], [-1, 2, 0]]").cubes.size(), 2);
}

TEST(SchemeTable, SaysWhatIsAllowed)
{
    expect_scheme_refusal("kind = \"magic\"", "c.toml:3: kind = \"magic\": must be one of \"corner-problem\"");
    expect_scheme_refusal("kind = \"noise\"\npoints = 3", "unknown key");
    expect_scheme_refusal("kind = \"corner-problem\"\ncolors = 5", "must be an integer from 2 to 4");
    expect_scheme_refusal("kind = \"direct\"\nwindow = [0, 0, 17, 1]", "must be of 1 to 16 tiles along each axis");
    expect_scheme_refusal("kind = \"construction\"\nwindow = [9, 1]", "a number from 1 to 8");
    expect_scheme_refusal("kind = \"construction\"\nset = \"jeandel-rao\"", "must be one of \"ammann\"");
    expect_scheme_refusal("kind = \"aperiodic-tables\"\nwidth = 9", "must be an integer from 1 to 8");
    expect_scheme_refusal("kind = \"diffraction\"\ntilings = [\"jeandel-rao\"]", "\"jeandel-rao\" is none");
    expect_scheme_refusal("kind = \"diffraction\"\ntilings = []", "must be a list of different algorithms");
    expect_scheme_refusal("kind = \"diffraction\"\ntilings = [\"kari\", \"kari\"]",
                          "must be a list of different algorithms");
    expect_scheme_refusal("kind = \"diffraction\"\ncolor = 2", "must be 0 or 1");
    expect_scheme_refusal("kind = \"isohedral\"\ntype = 94", "must be an integer from 1 to 93");
    expect_scheme_refusal("kind = \"isohedral\"\ntype = 1\nparameters = [0.1]",
                          "c.toml:5: parameters = [0.1]: must be as many as IH1 has: 4");
    expect_scheme_refusal("kind = \"isohedral\"\nrandom = true\nparameters = [1]",
                          "cannot be combined with random = true");
    expect_scheme_refusal("kind = \"isohedral\"\nparameters = [1e300, 1]",
                          "must be a list of numbers from -100 to 100");
    expect_scheme_refusal("kind = \"isohedral\"\nparameters = [nan, 1]", "must be a list of numbers from -100 to 100");
    expect_scheme_refusal("kind = \"isohedral\"\ncurves = [[0.5, 0.1]]", "must be a list of curves");
    expect_scheme_refusal("kind = \"isohedral\"\ncurves = [[[0.5, 101]]]", "points [x, y] from -100 to 100");
    expect_scheme_refusal("kind = \"isohedral\"\ntype = 1\ncoloring = { colors = 2, aspects = [2], steps = [0, 0] }",
                          "must be a list of 1 colours from 0 to 1");
    expect_scheme_refusal("kind = \"isohedral\"\ntype = 1\ncoloring = { colors = 2, permutations = [[0, 0], [1, 0]] }",
                          "must be two lists of all colours from 0 to 1");
    expect_scheme_refusal("kind = \"isohedral\"\ntype = 1\ncoloring = { colors = 2, permutations = [[0, 1]] }",
                          "must be two lists of all colours from 0 to 1");
    expect_scheme_refusal("kind = \"isohedral\"\ntype = 1\ncoloring = { colors = 2, permutations = 3, steps = [0, 0] }",
                          "must have steps or permutations, not both");
    expect_scheme_refusal("kind = \"isohedral\"\nwindow = [0, 4]", "must be [width, height], each from 1 to 100");
    expect_scheme_refusal("kind = \"surface\"\ncubes = [[0, 0, 0], [0, 0, 0]]", "must be a list of different cubes");
    expect_scheme_refusal("kind = \"surface\"\ncubes = [[0, 0.5, 0]]", "must be a list of different cubes");
}

}
}
