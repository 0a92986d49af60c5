// Tilings by polygons as files of users: what they describe, and what is refused.
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/prototiles/patch_survey.hpp"
#include "tiles/prototiles/substitution.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

class TilingFiles : public testing::Test
{
protected:
    PolygonTiling read(const std::string& text) const
    {
        folder_.write("t.toml", text);
        return read_polygon_tiling(folder_.path() / "t.toml");
    }

    /// The message without the folder.
    std::string refusal(const std::string& text) const
    {
        const std::string message = refusal_of([&] { read(text); });
        const std::string before = (folder_.path() / "t.toml").string();
        return message.starts_with(before) ? message.substr(before.size()) : message;
    }

    TemporaryFolder folder_;
};

TEST_F(TilingFiles, OfTheDocumentationAreTilings)
{
    std::ifstream page(source_folder() + "/docs/polygon-tilings.md");
    std::string text;
    bool is_inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line == "    title = \"Half hexagon\"") is_inside = true;
        if (is_inside && !line.empty() && !line.starts_with("    ")) break;
        if (is_inside) text += line + "\n";
    }
    const PolygonTiling tiling = read(text);
    ASSERT_EQ(tiling.parts.size(), 1U);
    std::vector<PlacedTile> tiles;
    for (const AddressedTile& tile : Substitution(tiling, 0).tiles(4, 1000)) tiles.push_back(tile.tile);
    ASSERT_EQ(tiles.size(), 256U);
    const PatchSurvey survey = survey_patch(tiling, tiles);
    EXPECT_EQ(survey.crowded_edges + survey.odd_vertices, 0U);
    // The sides of the whole are 80, of tiles 1 and 2.
    EXPECT_GE(survey.border_edges, 40U);
    EXPECT_LE(survey.border_edges, 80U);
}

TEST_F(TilingFiles, GiveOtherLengthsToATilingOfTheProgram)
{
    const PolygonTiling tiling = read("title = \"Tile(1, 2)\"\nrule = \"hat\"\nlengths = [\"1\", \"2\"]\n");
    EXPECT_EQ(tiling.title, "Tile(1, 2)");
    EXPECT_EQ(tiling.starts.size(), 3U) << "hat, partner and plane";
    constexpr double root = std::numbers::sqrt3;
    EXPECT_NEAR(area_of(tiling, 0), root * (2 + root * 2 + 4), 1e-12) << "as in arXiv 2303.10798, section 6";
}

TEST_F(TilingFiles, SayWhatIsWrongInThem)
{
    const std::string square = "[[tile]]\nname = \"s\"\ncorners = [\"0\", \"1\", \"1 + i\", \"i\"]\n";
    const std::string whole = "magnification = \"2\"\n" + square;
    EXPECT_EQ(refusal(""), ": 0 tables [[tile]]: must be 1 to 64");
    EXPECT_EQ(refusal(square), ": no period: magnification is missing");
    EXPECT_EQ(refusal(whole), ":2: [[tile]]: parts is missing");
    EXPECT_EQ(refusal("directions = 9\n" + square), ":1: directions = 9: must be 8, 10 or 12");
    EXPECT_EQ(refusal("magnification = \"2 + i\"\n" + square + "parts = [\"s\"]"),
              ":1: magnification = \"2 + i\": must be a real number times a unit vector, or 1 plus one");
    EXPECT_EQ(refusal(whole + "parts = [\"t\"]"),
              ":5: parts = \"t\": must be a tile and its place, such as \"kite at 1 + @60 turn @120 mirrored\"; no "
              "tile is called \"t\"");
    EXPECT_EQ(refusal(whole + "parts = [\"s at 1 + @50\"]"),
              ":5: parts = \"s at 1 + @50\": @50: degrees must be multiples of 30 here");
    EXPECT_EQ(refusal(whole + "parts = [\"s\", \"s turn 2\"]"),
              ":5: parts = \"s turn 2\": must turn by a number of the absolute value that the others have");
    EXPECT_EQ(refusal("magnification = \"1\"\n" + square + "parts = [\"s\"]"),
              ":1: magnification = \"1\": must be larger than the turns of the parts");
    EXPECT_EQ(refusal(whole + "parts = []"), ":5: parts = []: must not be empty for the first tile");
    EXPECT_EQ(refusal(whole + "parts = [\"t\"]\n[[tile]]\nname = \"t\"\ncorners = \"s\"\nparts = []"),
              ":5: parts = [\"t\"]: must begin with a tile that has parts");
    EXPECT_EQ(refusal(whole + "parts = [\"s\"]\n[[tile]]\nname = \"t\"\ncorners = \"u\"\nparts = []"),
              ":8: corners = \"u\": must be a list, or the name of a tile before this one");
    const std::string map = "magnification = [\"2\", \"3 @30\"]\n";
    EXPECT_EQ(refusal("directions = 10\n" + map + "[[tile]]\nname = \"s\"\nsides = 5\nparts = [\"s\"]"),
              ":2: magnification = [\"2\", \"3 @30\"]: must be one number for 10 directions");
    EXPECT_EQ(refusal("magnification = [\"2\"]\n" + square + "parts = [\"s\"]"),
              ":1: magnification = [\"2\"]: must be a list of 2 to 2 numbers in quotes");
    const std::string no_map =
        ":1: magnification = [\"2\", \"3 @30\"]: must be one number where some parts are mirrored, "
        "or where they turn by other numbers than unit vectors at multiples of 60 degrees";
    EXPECT_EQ(refusal(map + square + "parts = [\"s\", \"s mirrored\"]"), no_map);
    EXPECT_EQ(refusal(map + square + "parts = [\"s\", \"s turn i\"]"), no_map);
    EXPECT_EQ(refusal(map + square + "parts = [\"s turn 2\"]"), no_map);
    EXPECT_EQ(refusal("magnification = [\"1\", \"2 - @30\"]\n" + square + "parts = [\"s\"]"),
              ":1: magnification = [\"1\", \"2 - @30\"]: must be larger than the turns of the parts");
    EXPECT_EQ(refusal("lengths = [\"1\", \"-1\"]\n" + whole + "parts = [\"s\"]"),
              ":1: lengths = [\"1\", \"-1\"]: must be two real numbers above 0, up to 1000");
    EXPECT_EQ(refusal("lengths = [\"1\", \"2\"]\n" + whole + "parts = [\"s turn i\"]"),
              ":1: lengths = [\"1\", \"2\"]: is for substitutions whose tiles turn by multiples of 60 degrees");
    EXPECT_EQ(refusal("rule = \"chairs\"").substr(0, 37), ":1: rule = \"chairs\": must be one of \"");
    EXPECT_EQ(refusal("rule = \"spectre\"\nlengths = [\"1\", \"2\"]"),
              ":2: lengths = [\"1\", \"2\"]: is for substitutions whose tiles turn by multiples of 60 degrees");
    EXPECT_EQ(refusal("period = [\"1\", \"2 i\"]\nunit = [\"s\"]\n" + square),
              ":2: unit = [\"s\"]: must have the area of a period");
    EXPECT_EQ(refusal("period = [\"i\", \"1\"]\nunit = [\"s\"]\n" + square),
              ":1: period = [\"i\", \"1\"]: must be two vectors, the second to the left of the first");
    EXPECT_EQ(refusal("[[tile]]\nname = \"s\"\ncorners = [\"0\", \"i\", \"1\"]"),
              ":3: corners = [\"0\", \"i\", \"1\"]: must go around the tile counterclockwise");
    EXPECT_EQ(refusal("[[tile]]\nname = \"s\"\nsides = 5"), ":3: sides = 5: must be a divisor of 12, the directions");
    EXPECT_EQ(refusal(square + "edges = \"abc\""),
              ":4: edges = \"abc\": must be 4 letters or digits, one for each edge");
    EXPECT_EQ(refusal(square + "colour = \"#ffffff\"").substr(0, 60),
              std::string(":4: colour = \"#ffffff\": unknown key; did you mean \"color\"? known").substr(0, 60));
}

}
}
