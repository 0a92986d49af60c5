// poissonlab texture cells: maps against marching squares by hand and the hash of the runtime header; what is written
// for Tiled is put together again from its own numbers.
#include "base/files/whole_file.hpp"
#include "runtime/texture_tiles.h"
#include "tests/support/command_test.hpp"
#include "tests/support/places.hpp"
#include "tests/support/raw_png.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <regex>
#include <set>

namespace poissonlab {
namespace {

using test::RawPng;
using testing::ElementsAre;
using testing::HasSubstr;

/// A cell shows the bits of its corners: four pixels, lit where the corner has the second colour.
std::string lamps()
{
    std::string text = "name = \"lamps\"\nsize = 2\n[[corner]]\nname = \"off\"\ncolor = \"#000000\"\n"
                       "[[corner]]\nname = \"on\"\ncolor = \"#ffc800\"\nweight = 3\n"
                       "[glyphs]\n\".\" = \"#000000\"\n\"*\" = \"#ffc800\"\n";
    for (int bits = 0; bits < 16; ++bits) {
        const auto word = [&](int corner) { return (bits >> corner & 1) != 0 ? "\"on\"" : "\"off\""; };
        const auto glyph = [&](int corner) { return (bits >> corner & 1) != 0 ? '*' : '.'; };
        text += fmt::format("[[cell]]\ncorners = [{}, {}, {}, {}]\nrows = [\"{}{}\", \"{}{}\"]\n", word(0), word(1),
                            word(2), word(3), glyph(0), glyph(1), glyph(2), glyph(3));
    }
    return text;
}

class TextureCells : public test::CommandTest
{
protected:
    TextureCells() : CommandTest("texture cells") {}

    RawPng picture(const std::string& name) const { return test::read_raw_png(folder_.path() / name); }
};

bool is_lit(const RawPng& png, int column, int row) { return png.pixel(column, row)[0] == 255; }

/// The corner above and to the right of a pixel is that of the runtime header: three of four have the second colour.
TEST_F(TextureCells, HaveTheCornersOfTheRuntime)
{
    folder_.write("lamps.toml", lamps());
    printed("lamps.toml --window -3 1000000000000 9 7 --seed 77 --quiet --out map.png");
    const RawPng map = picture("map.png");
    ASSERT_EQ(map.width, 18);
    ASSERT_EQ(map.height, 14);
    int lit = 0;
    for (int row = 0; row < 14; ++row)
        for (int column = 0; column < 18; ++column) {
            const auto x = static_cast<std::uint32_t>(-3 + (column + 1) / 2);
            const auto y = static_cast<std::uint32_t>(1000000000000 + 7 - (row + 1) / 2);
            ASSERT_EQ(is_lit(map, column, row), ttiles_color(77, 4, x, y) >= 1) << column << " " << row;
            lit += is_lit(map, column, row);
        }
    EXPECT_GT(lit, 14 * 18 / 2);
}

/// The numbers of attributes name="...", in their order.
std::vector<int> attributes(const std::string& xml, const std::string& name)
{
    std::vector<int> found;
    const std::regex pattern(" " + name + "=\"(\\d+)\"");
    for (std::sregex_iterator match(xml.begin(), xml.end(), pattern), end; match != end; ++match)
        found.push_back(std::stoi((*match)[1]));
    return found;
}

std::vector<int> numbers_in(const std::string& text)
{
    std::vector<int> found;
    const std::regex pattern("\\d+");
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        found.push_back(std::stoi(match->str()));
    return found;
}

TEST_F(TextureCells, AreTheSameInTiled)
{
    printed(source_folder() + "/configs/alphabets/dungeon.toml --window 4 5 21 13 --quiet --out map.png --out map.tmx "
                              "--out map.csv");
    const std::string xml = read_whole_file(folder_.path() / "map.tmx");
    const std::size_t data = xml.find("<data encoding=\"csv\">\n") + 22;
    const std::string csv = xml.substr(data, xml.find("</data>") - data);
    EXPECT_THAT(xml, HasSubstr("<image source=\"map-tiles.png\" width=\"64\" height=\"64\"/>"));
    EXPECT_THAT(attributes(xml, "tilewidth"), ElementsAre(16, 16));
    EXPECT_THAT(attributes(xml, "columns"), ElementsAre(4));
    EXPECT_THAT(csv, testing::EndsWith("\n"));
    EXPECT_EQ(csv[csv.size() - 2] == ',', false) << "no comma behind the last number";
    EXPECT_EQ(std::ranges::count(csv, ','), 21 * 13 - 1);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 13);
    const std::vector<int> numbers = numbers_in(csv),
                           from_csv = numbers_in(read_whole_file(folder_.path() / "map.csv"));
    ASSERT_EQ(numbers.size(), 21 * 13);
    const RawPng map = picture("map.png"), cells = picture("map-tiles.png");
    for (int row = 0; row < 13; ++row)
        for (int column = 0; column < 21; ++column) {
            const auto i = static_cast<std::size_t>(row * 21 + column);
            const int cell = numbers[i] - 1;
            ASSERT_EQ(from_csv[i], cell);
            for (int y = 0; y < 16; ++y)
                for (int x = 0; x < 16; ++x)
                    for (int c = 0; c < 3; ++c)
                        ASSERT_EQ(map.pixel(column * 16 + x, row * 16 + y)[c],
                                  cells.pixel(cell % 4 * 16 + x, cell / 4 * 16 + y)[c]);
        }
}

/// Terrains of Tiled say the corners clockwise from the upper right one: neighbours in the map agree on theirs.
TEST_F(TextureCells, AreTerrainsInTiled)
{
    printed(source_folder() + "/configs/alphabets/islands.toml --window 0 0 30 20 --quiet --out map.tmx");
    const std::string xml = read_whole_file(folder_.path() / "map.tmx");
    std::vector<std::array<int, 4>> corners(81);
    const std::regex pattern("<wangtile tileid=\"(\\d+)\" wangid=\"0,(\\d),0,(\\d),0,(\\d),0,(\\d)\"/>");
    for (std::sregex_iterator match(xml.begin(), xml.end(), pattern), end; match != end; ++match)
        for (std::size_t i = 0; i < 4; ++i)
            corners.at(std::stoul((*match)[1]))[i] = std::stoi((*match)[static_cast<int>(i) + 2]);
    EXPECT_EQ(std::set(corners.begin(), corners.end()).size(), 81);
    const std::size_t data = xml.find("csv\">");
    const std::vector<int> numbers = numbers_in(xml.substr(data, xml.find("</data>") - data));
    ASSERT_EQ(numbers.size(), 600);
    const auto at = [&](std::size_t column, std::size_t row) {
        return corners[static_cast<std::size_t>(numbers[row * 30 + column] - 1)];
    };
    enum
    {
        upper_right,
        lower_right,
        lower_left,
        upper_left
    };
    for (std::size_t row = 0; row < 20; ++row)
        for (std::size_t column = 0; column + 1 < 30; ++column) {
            ASSERT_EQ(at(column, row)[upper_right], at(column + 1, row)[upper_left]);
            ASSERT_EQ(at(column, row)[lower_right], at(column + 1, row)[lower_left]);
            if (row + 1 == 20) continue;
            ASSERT_EQ(at(column, row)[lower_left], at(column, row + 1)[upper_left]);
            ASSERT_EQ(at(column, row)[lower_right], at(column, row + 1)[upper_right]);
        }
}

/// The rule is marching squares: a pixel has the second colour where the bilinear interpolation of 0 and 1 is above
/// 1/2.
TEST_F(TextureCells, AreDrawnByTheRule)
{
    folder_.write("rule.toml", "size = 32\n[[corner]]\ncolor = \"#000000\"\n[[corner]]\ncolor = \"#ff0000\"\n[rule]\n");
    printed("rule.toml --window 0 0 12 9 --seed 5 --quiet --out map.png");
    const RawPng map = picture("map.png");
    const auto corner = [](int x, int y) {
        return ttiles_color(5, 2, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(9 - y)) == 1 ? 1.0 : 0.0;
    };
    int ties = 0;
    for (int row = 0; row < 9 * 32; ++row)
        for (int column = 0; column < 12 * 32; ++column) {
            const double x = (column % 32 + 0.5) / 32, y = (row % 32 + 0.5) / 32;
            const int i = column / 32, j = row / 32;
            const double value = (1 - y) * ((1 - x) * corner(i, j) + x * corner(i + 1, j)) +
                                 y * ((1 - x) * corner(i, j + 1) + x * corner(i + 1, j + 1));
            if (std::abs(value - 0.5) < 1e-9) {
                ++ties;
                continue;
            }
            ASSERT_EQ(is_lit(map, column, row), value > 0.5) << column << " " << row;
        }
    EXPECT_LT(ties, 12 * 9 * 64);
}

TEST_F(TextureCells, CountThemselves)
{
    folder_.write("lamps.toml", lamps());
    const auto told = nlohmann::json::parse(printed("lamps.toml --window 0 0 200 100 --out a.csv --json"));
    EXPECT_EQ(told["cells"], 20'000);
    EXPECT_EQ(told["different"], 16);
    // A binomial share of 3/4 in 20,000 has a standard error of 0.003.
    EXPECT_NEAR(told["corners_2"].get<double>(), 0.75, 0.015);
}

TEST_F(TextureCells, SayWhatIsWrong)
{
    folder_.write("none.toml", "[[corner]]\ncolor = \"#000000\"\n");
    expect_error("none.toml --out a.png", "none.toml: 1 tables [[corner]]: must be 2 to 6");
    const std::string two =
        "[[corner]]\nname = \"a\"\ncolor = \"#000000\"\n[[corner]]\nname = \"b\"\ncolor = \"#0000ff\"\n";
    folder_.write("lack.toml", two);
    expect_error("lack.toml --out a.png", "lack.toml: the cell a a over a a has no [[cell]], and there is no [rule]");
    folder_.write("color.toml", "[[corner]]\ncolor = \"red\"\n");
    expect_error("color.toml --out a.png", "color.toml:2: color = \"red\": must be a colour, \"#rrggbb\"");
    folder_.write("cell.toml", "size = 2\n" + two +
                                   "[glyphs]\n\".\" = \"#000000\"\n[[cell]]\ncorners = [\"a\", \"a\", "
                                   "\"b\", \"c\"]\nrows = [\"..\", \"..\"]\n");
    expect_error("cell.toml --out a.png", "cell.toml:11: corners = \"c\": must be one of a, b");
    folder_.write("rows.toml", "size = 2\n" + two +
                                   "[glyphs]\n\".\" = \"#000000\"\n[[cell]]\ncorners = [\"a\", \"a\", "
                                   "\"b\", \"b\"]\nrows = [\"..\", \".x\"]\n");
    expect_error("rows.toml --out a.png", "rows.toml:12: rows = \".x\": the glyph x is not in [glyphs]");
    folder_.write("twice.toml", "size = 2\n" + two +
                                    "[glyphs]\n\".\" = \"#000000\"\n[[cell]]\ncorners = [\"a\", \"a\", "
                                    "\"a\", \"b\"]\nturned = true\nrows = [\"..\", \"..\"]\n[[cell]]\n"
                                    "corners = [\"b\", \"a\", \"a\", \"a\"]\nrows = [\"..\", \"..\"]\n");
    expect_error("twice.toml --out a.png", "twice.toml:15: [[cell]]: b a over a a is drawn twice");
    folder_.write("lamps.toml", lamps());
    expect_error("lamps.toml --window 0 0 40000 1 --out a.png",
                 "texture cells: window: 40000 cells of 2 pixels are more than 65500 along a side of the picture");
    expect_error("lamps.toml --out a.bmp", "texture cells: --out a.bmp: must end in .png, .tmx or .csv");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "a.png"));
}

}
}
