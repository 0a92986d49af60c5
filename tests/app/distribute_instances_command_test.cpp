// `poissonlab distribute instances` and `distribute icons`: their files, and what they refuse.
#include "base/images/png_file.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class DistributeInstances : public testing::Test
{
protected:
    Outcome run(const std::string& verb, const std::vector<std::string>& arguments) const
    {
        std::vector<std::string> words{"distribute", verb};
        words.insert(words.end(), arguments.begin(), arguments.end());
        return run_program(folder_.path(), words);
    }

    Outcome place(std::vector<std::string> arguments, const std::string& out) const
    {
        arguments.insert(arguments.end(), {"--tiles", tiles_, "--out", out});
        return run("instances", arguments);
    }

    std::set<std::string> lines_of(const std::string& file) const
    {
        std::istringstream text(content_of(folder_.path() / file));
        std::set<std::string> lines;
        for (std::string line; std::getline(text, line);) lines.insert(line);
        return lines;
    }

    void expect_error(const std::string& verb, const std::vector<std::string>& arguments,
                      const std::string& message) const
    {
        const Outcome outcome = run(verb, arguments);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_THAT(outcome.error, HasSubstr(message));
        EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out.csv"));
    }

    TemporaryFolder folder_;
    std::string tiles_ = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
};

/// Instances are made on the fly: two windows together have the lines of the whole window, with the heights of one
/// terrain.
TEST_F(DistributeInstances, AreTheSameWhateverTheWindows)
{
    const std::vector<std::string> terrain{"forest", "--terrain", "x*y", "--terrain-area", "0",  "0", "2",
                                           "1",      "--seed",    "4",   "--density",      "300"};
    // Numbers of a list are words, or apart by commas in one word.
    for (const auto& [window, file] :
         {std::pair{"0 0 2 1", "whole.csv"}, {"0 0 0.7 1", "west.csv"}, {"0.7,0,1.3,1", "east.csv"}}) {
        std::vector<std::string> words = terrain;
        words.emplace_back("--window");
        std::ranges::copy(test::words_of(window), std::back_inserter(words));
        const Outcome outcome = place(words, file);
        ASSERT_EQ(outcome.status, 0) << outcome.error;
    }
    std::set<std::string> parts = lines_of("west.csv");
    parts.merge(lines_of("east.csv"));
    EXPECT_EQ(parts, lines_of("whole.csv"));
    EXPECT_NEAR(static_cast<double>(parts.size()), 601, 40);
}

TEST_F(DistributeInstances, AreWrittenAsTablesAndPictures)
{
    const Outcome outcome = place({"sunflowers", "--out", "a.usda", "--out", "a.png", "--pixels", "200"}, "a.ply");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("instances of 11 models; 500.0 are expected"));
    EXPECT_EQ(run("instances", test::words_of("--window 0 0 1 1 forest --tiles " + tiles_ + " --out b.csv")).status, 0);
    EXPECT_THAT(content_of(folder_.path() / "a.ply"), HasSubstr("property double tilt"));
    EXPECT_THAT(content_of(folder_.path() / "a.usda"), HasSubstr("quath[] orientations"));
    EXPECT_EQ(read_png(folder_.path() / "a.png").width, 200);
}

TEST_F(DistributeInstances, RefuseWhatTheyCannotDo)
{
    const auto refuse = [&](const std::string& text, const std::string& message) {
        std::vector<std::string> words = test::words_of(text);
        words.insert(words.end(), {"--out", "out.csv"});
        expect_error("instances", words, message);
    };
    refuse("wood", "distribute instances: SCENE wood: must be one of \"forest\", \"sunflowers\", \"asteroids\"");
    refuse("forest --window 0 0 1", "--window 0 0 1: must be [x, y, width, height]");
    refuse("forest --window 0 0 1 0",
           "--window 0 0 1 0: must be [x, y, width, height]; height must be a number from 0.001");
    refuse("forest --window 0 0 a 1", "--window 0 0 a 1: must be [x, y, width, height]; width must be a number");
    refuse("forest --window 0 0 9000 9000", "instances in the window: must be at most 1000000");
    refuse("forest --terrain x", "--terrain x: needs --terrain-area");
    refuse("forest --height 2", "--height 2: needs --terrain");
    refuse("forest --ring 1 2 3", "--ring 1 2 3: is for asteroids");
    refuse("asteroids --ring 1 2", "--ring 1 2: must be [inner, outer, thickness]");
    refuse("asteroids --ring 0 1 1e300",
           "--ring 0 1 1e300: must be [inner, outer, thickness]; thickness must be a number from 0.001 to 1000000");
    refuse("asteroids --ring 2 1 3", "must be [inner, outer, thickness] with");
    refuse("asteroids --tiles " + tiles_, "are tiles in 2 dimensions; must be in 3");
    refuse("forest --scale 0.5 2", "--scale 0.5 2: must be a number from 0.001 to 1, { uniform = [a, b] }");
    refuse("forest --models 0", "--models 0: must be an integer from 1 to 65536");
    refuse("forest --models many", "--models many: must be an integer from 1 to 65536");
    refuse("forest --out a.obj", "must end in .csv, .ply, .usda, .glb or .png");
}

TEST_F(DistributeInstances, HaveNeighboursThatAreIcons)
{
    const Outcome outcome = run("icons", {"--u=-y", "--v", "x", "--points", "50", "--tiles", tiles_, "--out", "a.svg",
                                          "--out", "a.csv", "--out", "a.png", "--pixels", "300"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(lines_of("a.csv").size(), 51);
    EXPECT_EQ(read_png(folder_.path() / "a.png").width, 300);
    EXPECT_THAT(content_of(folder_.path() / "a.svg"), HasSubstr("<svg"));
}

TEST_F(DistributeInstances, HaveNeighboursThatRefuseFields)
{
    const auto refuse = [&](std::vector<std::string> words, const std::string& message) {
        words.insert(words.end(), {"--points", "9", "--out", "out.csv"});
        expect_error("icons", words, message);
    };
    refuse({"--u", "x"}, "distribute icons: needs --field, or --u and --v");
    refuse({"--u", "x", "--v", "x+"}, "distribute icons: --v: formula \"x+\"");
    refuse({"--u", "0", "--v", "0"}, "the field has no vectors");
    refuse({"--u", "x", "--v", "y", "--length", "two"}, "--length two: must be one of \"magnitude\", \"one\"");
    refuse({"--field", "none.exr"}, "none.exr");
    refuse({"--u", "x", "--v", "y", "--out", "a.txt"}, "must end in .svg, .png or .csv");
}

}
}
