// poissonlab aperiodic: what its commands print, write and refuse.
#include "tests/support/command_test.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::json;

class AperiodicCommand : public test::CommandTest
{
protected:
    AperiodicCommand() : CommandTest("aperiodic") {}

    Json json(const std::string& arguments) const { return Json::parse(printed(arguments + " --json")); }
};

TEST_F(AperiodicCommand, ListsTheSets)
{
    EXPECT_THAT(printed("sets"), HasSubstr("kari              14        6           3         6  Kari 1996\n"));
    EXPECT_THAT(printed("sets"), HasSubstr("not available: Penrose 32/16, "));
    const Json sets = json("sets");
    ASSERT_EQ(sets.size(), 6U);
    EXPECT_EQ(sets[2]["name"], "ammann");
    EXPECT_EQ(sets[2]["tiles"], 16);
    EXPECT_EQ(sets[2]["colors"], 6);
    EXPECT_EQ(sets[2]["wang_tiles"].size(), 16U);
    EXPECT_EQ(sets[3]["name"], "robinson");
    EXPECT_EQ(sets[4]["available"], false);
}

TEST_F(AperiodicCommand, ConvertsAsTheDissertationsTables)
{
    const Json steps = json("convert culik --construction rotation --repeat 3");
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_EQ(steps[0]["tiles"], 60);
    EXPECT_EQ(steps[0]["colors"], 9);
    EXPECT_EQ(steps[0]["wang_tiles"], 60);
    EXPECT_EQ(steps[0]["wang_colors"], 21);
    EXPECT_EQ(steps[0]["white"], 13);
    EXPECT_EQ(steps[0]["black"], 47);
    EXPECT_EQ(steps[2]["tiles"], 336);
    EXPECT_EQ(steps[2]["colors"], 149);
    EXPECT_EQ(steps[2]["wang_colors"], 228);
    EXPECT_EQ(printed("convert kari --construction vertical --repeat 2"),
              "1: 86 corner tiles over 6 colours; 86 Wang tiles over 36 colours\n"
              "2: 504 corner tiles over 36 colours; 504 Wang tiles over 216 colours\n");
    const Json failed = json("convert kari --construction horizontal --repeat 2");
    ASSERT_EQ(failed.size(), 1U);
    EXPECT_EQ(failed[0]["ambiguous"], true);
}

TEST_F(AperiodicCommand, ReadsAndWritesFilesOfTiles)
{
    printed("convert ammann --construction rotation --out corners.txt");
    EXPECT_THAT(content_of(folder_.path() / "corners.txt"), StartsWith("corner # "));
    // The Wang tiles of a file of corner tiles are those that the next repetition begins with.
    EXPECT_EQ(json("convert corners.txt --construction rotation")[0],
              json("convert ammann --construction rotation --repeat 2")[1]);
    folder_.write("own.txt", "a 0 b 0\n");
    const Outcome outcome = run("convert own.txt --construction diagonal");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.error, "poissonlab: note: own.txt:1: no tile fits on the north of this one: it cannot occur in "
                             "a tiling\n");
    EXPECT_THAT(outcome.out, StartsWith("1: 0 corner tiles over 1 colours; "));
}

TEST_F(AperiodicCommand, DrawsSets)
{
    printed("convert ammann --construction horizontal --out figure.svg");
    EXPECT_THAT(content_of(folder_.path() / "figure.svg"), HasSubstr("#cc79a7")); // the sixth colour
    printed("convert ammann --construction horizontal --out figure.png");
    EXPECT_EQ(test::decode_png(content_of(folder_.path() / "figure.png")).width,
              576); // 7 columns of 40 units, and a margin
}

TEST_F(AperiodicCommand, FindsPeriods)
{
    const Json none = json("verify ammann --width 4");
    EXPECT_EQ(none["periodic"], false);
    EXPECT_TRUE(none["period"].is_null());
    EXPECT_EQ(none["heights"]["horizontal"], (std::vector<int>{2, 4, 8, 4}));
    EXPECT_EQ(none["heights"]["vertical"], (std::vector<int>{2, 4, 8, 4}));
    const Json found = json("verify ammann --construction horizontal --width 8");
    EXPECT_EQ(found["periodic"], true);
    EXPECT_EQ(found["period"]["width"], 2);
    EXPECT_EQ(found["period"]["height"], 3);
    EXPECT_EQ(found["period"]["tiles"].size(), 3U);
    EXPECT_EQ(found["heights"]["horizontal"].size(), 1U);
    EXPECT_EQ(found["heights"]["vertical"].size(), 2U) << "columns repeat after three tiles";
    EXPECT_THAT(printed("verify ammann --construction horizontal --width 8 --out period.png"),
                AllOf(HasSubstr("            2       any"), HasSubstr("            3         -       any\n"),
                      HasSubstr("\nperiodic: these 2 x 3 tiles repeat\n")));
    EXPECT_EQ(test::decode_png(content_of(folder_.path() / "period.png")).height, 2 * (6 * 32 + 16)); // two copies
    EXPECT_THAT(printed("verify jeandel-rao --width 3"),
                EndsWith("no period up to 3 tiles along either axis; that there is none is not proven by this\n"));
}

TEST_F(AperiodicCommand, PrintsTheTablesOfItsPage)
{
    const std::string page = printed("tables");
    EXPECT_EQ(page, content_of(source_folder() + "/docs/aperiodic-tiles.md"));
    // No number differs from those that are printed, and the largest set is there.
    EXPECT_THAT(page, Not(HasSubstr("**here")));
    EXPECT_THAT(page, HasSubstr("| 160168/14810 | 1213029/58910 | 1642/777 | 7092/2068 |"));
}

TEST_F(AperiodicCommand, PrintsTilings)
{
    // Both engines print equal tilings, and windows agree; 14 tiles are numbered from 0.
    const std::string whole = printed("tile kari --window -3 -2 6 4 --seed 2");
    EXPECT_EQ(printed("tile kari --window -3 -2 6 4 --seed 2 --engine reference"), whole);
    EXPECT_EQ(printed("tile kari --window -3 -2 6 1 --seed 2"), whole.substr(whole.rfind('\n', whole.size() - 2) + 1));
    EXPECT_NE(printed("tile kari --window -3 -2 6 4 --seed 3"), whole);
    EXPECT_EQ(std::ranges::count(printed("tile ammann --window 0 0 5 3"), '\n'), 3);
    EXPECT_EQ(std::ranges::count(printed("tile jeandel-rao --window 0 0 12 12"), '\n'), 12);
    EXPECT_EQ(std::ranges::count(printed("tile kari --construction rotation --repeat 2 --window -5 -5 4 3"), '\n'), 3);
    printed("tile ammann --construction diagonal --window 0 0 8 8 --out tiling.png");
    EXPECT_EQ(test::decode_png(content_of(folder_.path() / "tiling.png")).width, 2 * (8 * 32 + 16));
}

TEST_F(AperiodicCommand, SaysWhyThereIsNoTiling)
{
    expect_error("tile kari --construction diagonal --repeat 0 --window 0 0 1 1",
                 "aperiodic tile: --repeat 0: must be an integer from 1 to 16 (see poissonlab aperiodic tile --help)");
    expect_error("tile kari --window 0 0 1", "aperiodic tile: --window 0 0 1: must be X Y W H");
    expect_error("tile kari --window 0 0 0 1", "aperiodic tile: --window 0 0 0 1: sizes must be at least 1");
    expect_error("tile kari --method substitution --window 0 0 1 1",
                 "aperiodic tile: --method substitution: there is none for kari");
    expect_error("tile jeandel-rao --window 1 0 2 2", "aperiodic tile: --window 1 0 2 2: by search, X and Y must be 0");
    expect_error("tile kari --window 0 2000000 2 2",
                 "rows of a tiling by Beatty sequences are from -1048576 to 1048575");
    expect_error("tile ammann --window 0 0 8 8 --engine gpu",
                 "aperiodic tile: --engine gpu: must be one of \"opencl\", \"reference\"");
    folder_.write("two.txt", "0 1 0 0\n0 2 0 1\n");
    const Outcome none = run("tile two.txt --window 0 0 3 1");
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.error, EndsWith("error: aperiodic tile: no 3 x 1 tiles of two.txt fit together\n"));
}

TEST_F(AperiodicCommand, WrongArguments)
{
    expect_error("verify karj --width 3", "aperiodic verify: SET karj: must be one of \"culik\", \"kari\", \"ammann\", "
                                          "\"robinson\", \"jeandel-rao\", or a file of tiles; did you mean \"kari\"?");
    expect_error(
        "verify kari --width 0",
        "aperiodic verify: --width 0: must be an integer from 1 to 64 (see poissonlab aperiodic verify --help)");
    expect_error("verify kari --width 3 --construction diagnal",
                 "aperiodic verify: --construction diagnal: must be one of \"diagonal\", \"horizontal\", \"vertical\", "
                 "\"rotation\", \"subdivision\"; did you mean \"diagonal\"?");
    expect_error("verify kari --width 3 --construction horizontal --repeat 2",
                 "aperiodic verify: repetition 1 is ambiguous: there is none after it");
    expect_error("verify kari --width 3 --out a.gif", "aperiodic verify: --out a.gif: must end in .svg or .png");
    expect_error("verify kari --width 3 --out no/a.png", "aperiodic verify: --out no/a.png: there is no folder no");
    expect_error(
        "convert kari --construction diagonal --repeat 17",
        "aperiodic convert: --repeat 17: must be an integer from 1 to 16 (see poissonlab aperiodic convert --help)");
    expect_error("convert kari --construction diagonal --repeat 3 --out a.png",
                 "aperiodic convert: --out a.png: 58910 tiles cannot be drawn (at most 20000)");
    expect_error("convert kari --construction diagonal --repeat 5",
                 "repetition 5: 1213029 tiles are too many to go on from (at most 1000000)");
    folder_.write("bad.txt", "1 2 3 4\n1 2 3\n");
    expect_error("convert bad.txt --construction diagonal", "bad.txt:2: has 3 words: must be four colours, N E S W");
    folder_.write("empty.txt", "# nothing\n");
    expect_error("convert empty.txt --construction diagonal", "empty.txt: has no tiles");
}

}
}
