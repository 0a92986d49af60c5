// `poissonlab tiles build --border chain`: what it means by itself, what it refuses, and a file that is proven.
#include "base/files/whole_file.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::Not;

class TilesBuildCommand : public test::CommandTest
{
protected:
    TilesBuildCommand() : CommandTest("tiles") {}

    /// The text of an error, which leaves no file.
    std::string refusal(const std::string& arguments) const
    {
        const Outcome outcome = run("build " + arguments + " --out refused.ptiles");
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "refused.ptiles"));
        return outcome.error;
    }
};

TEST_F(TilesBuildCommand, ChainsComeWithWhatTheyAreGoodWith)
{
    ASSERT_EQ(run("build corner --colors 2 --points 32 --border chain --out a.ptiles --quiet").status, 0);
    const PoissonTileParameters p = read_tile_set(folder_.path() / "a.ptiles").parameters;
    EXPECT_EQ(p.border, TileBorder::chain);
    EXPECT_TRUE(p.repulsion);
    EXPECT_EQ(p.joint_iterations, 20u);
    EXPECT_TRUE(p.null_peaks);
    const Outcome verified = run("verify a.ptiles");
    EXPECT_EQ(verified.status, 0);
    EXPECT_THAT(verified.out, HasSubstr("border                chain\n"));
    EXPECT_THAT(verified.out, HasSubstr("chains  "));
    EXPECT_THAT(run("verify a.ptiles --json").out, HasSubstr("\"joint_iterations\": 20"));
}

/// A file of a monotile is proven by verify, and one whose promise is too large by one unit is not.
TEST_F(TilesBuildCommand, HatsAndSpectresAreProven)
{
    for (const std::string word : {"hat", "spectre"}) {
        ASSERT_EQ(run("build " + word + " --points 2 --levels 0 --out a.ptiles --quiet").status, 0);
        const nlohmann::json json = nlohmann::json::parse(run("verify a.ptiles --json").out);
        EXPECT_EQ(json.at("kind"), word);
        EXPECT_EQ(json.at("states"), word == "hat" ? 19 : 42);
        EXPECT_GT(json.at("relative_radius").get<double>(), 0.79);
        std::string bytes = read_whole_file(folder_.path() / "a.ptiles");
        ++bytes[40];
        const std::uint64_t sum = tile_file_checksum(bytes);
        std::memcpy(bytes.data() + 120, &sum, sizeof(sum));
        write_whole_file(folder_.path() / "b.ptiles", bytes);
        const Outcome refused = run("verify b.ptiles");
        EXPECT_EQ(refused.status, 2);
        EXPECT_EQ(refused.error, "poissonlab: error: b.ptiles: promises other distances than are proven\n");
        EXPECT_EQ(refused.out, "");
    }
}

TEST_F(TilesBuildCommand, OptionsSayOtherwise)
{
    ASSERT_EQ(run("build template --tiles 5 --points 32 --border chain --joint-iterations 5 --null-peaks off "
                  "--out a.json --quiet")
                  .status,
              0);
    const PoissonTileParameters p = read_tile_set(folder_.path() / "a.json").parameters;
    EXPECT_EQ(p.joint_iterations, 5u);
    EXPECT_FALSE(p.null_peaks);
    EXPECT_EQ(run("verify a.json").status, 0);
}

TEST_F(TilesBuildCommand, StripsAreRelaxedTogetherWhereAsked)
{
    ASSERT_EQ(run("build corner --colors 2 --points 32 --repulsion --joint-iterations 5 --out a.ptiles --quiet").status,
              0);
    const PoissonTileParameters p = read_tile_set(folder_.path() / "a.ptiles").parameters;
    EXPECT_EQ(p.border, TileBorder::strip);
    EXPECT_EQ(p.joint_iterations, 5u);
    EXPECT_TRUE(p.null_peaks);
    EXPECT_EQ(run("verify a.ptiles").status, 0);
}

TEST_F(TilesBuildCommand, RanksAreStoredAndJudged)
{
    ASSERT_EQ(run("build corner --colors 2 --points 32 --ranked --out a.ptiles --quiet").status, 0);
    const PoissonTileSet set = read_tile_set(folder_.path() / "a.ptiles");
    EXPECT_TRUE(set.parameters.ranked);
    ASSERT_EQ(run("build corner --colors 2 --points 32 --out plain.ptiles --quiet").status, 0);
    EXPECT_EQ(read_tile_set(folder_.path() / "plain.ptiles").points, set.points);
    EXPECT_THAT(run("verify a.ptiles").out, HasSubstr("25 % of the points    relative radius 0."));
    const auto parts = nlohmann::json::parse(run("verify a.ptiles --json").out)["parts"];
    ASSERT_EQ(parts.size(), 3u);
    for (const auto& part : parts)
        EXPECT_LT(part["low_frequency_power"].get<double>(), 0.5 * part["random_low_frequency_power"].get<double>());
    EXPECT_THAT(run("verify plain.ptiles").out, Not(HasSubstr("of the points ")));
}

TEST_F(TilesBuildCommand, SaysWhatIsAllowed)
{
    EXPECT_THAT(refusal("corner --colors 2 --points 32 --border chian"),
                HasSubstr("--border chian: must be one of \"strip\", \"chain\"; did you mean \"chain\"?"));
    EXPECT_THAT(refusal("corner --colors 2 --points 32 --border chain --null-peaks yes"),
                HasSubstr("--null-peaks yes: must be one of \"on\", \"off\""));
    EXPECT_THAT(refusal("edge --colors 1 --points 32 --border chain"),
                HasSubstr("tiles build: --border chain: is for corner and template tiles"));
    EXPECT_THAT(refusal("corner --colors 2 --points 32 --null-peaks on"),
                HasSubstr("--null-peaks on: must be false without joint iterations"));
    EXPECT_THAT(refusal("corner --colors 2 --points 32 --border chain --joint-iterations 0 --null-peaks on"),
                HasSubstr("--null-peaks on: must be false without joint iterations"));
    EXPECT_EQ(refusal("corner --colors 2 --points 32 --joint-iterations x"),
              "poissonlab: error: tiles build: --joint-iterations x: must be an integer from 0 to 100000\n");
}

}
}
