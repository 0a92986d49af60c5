#include "experiment/config/config.hpp"
#include "tests/support/errors.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

const std::string text = R"(seed = 1
[[method]]
sampler = "random"
[[method]]
sampler = "dart-throwing"
relative_radius = 0.70
[[method]]
sampler = "dart-throwing"
stop = "saturation"
)";

Config with(const std::vector<std::string>& overrides) { return parse_config(text, "c.toml", overrides); }

std::string error_with(const std::string& argument)
{
    return message_of([&] { with({argument}); });
}

TEST(Override, ReplacesAndAddsKeys)
{
    const Config config = with({"seed=2", "title=A new title", "analysis.points=4096", " engine = reference "});
    EXPECT_EQ(config.seed, 2U);
    EXPECT_EQ(config.title, "A new title");
    EXPECT_EQ(config.points, 4096U);
    EXPECT_EQ(config.engine, Engine::reference);
    EXPECT_EQ(config.overrides.size(), 4U);
    EXPECT_EQ(config.text, text) << "the config is kept as it is written";
}

TEST(Override, TheLastOneWins) { EXPECT_EQ(with({"seed=2", "seed=3"}).seed, 3U); }

TEST(Override, ReachesOneMethodByNumber)
{
    const Config config = with({"method.1.relative_radius=[0.6, 0.65]", "method.0.label=White"});
    EXPECT_EQ(config.methods[0].label, "White");
    ASSERT_EQ(config.methods[1].settings[0].choices.size(), 2U);
    EXPECT_EQ(config.methods[1].settings[0].choices[1].shown, "0.65");
}

TEST(Override, ReachesEveryMethodThatHasTheKey)
{
    const Config config = with({"method.relative_radius=0.5"});
    EXPECT_TRUE(config.methods[0].settings.empty()) << "random has no such parameter";
    EXPECT_EQ(config.methods[1].settings[0].choices[0].shown, "0.5");
    EXPECT_EQ(config.methods[2].settings[0].choices[0].shown, "0.5");
}

TEST(Override, PointsAreAKeyOfEveryMethod)
{
    const Config config = with({"method.points=[64, 256]"});
    for (const MethodConfig& method : config.methods) {
        EXPECT_EQ(method.settings[0].parameter->key, "points");
        EXPECT_EQ(method.settings[0].choices.size(), 2U);
    }
}

TEST(Override, CanBringTheMethods)
{
    const Config config = parse_config("seed = 1\n", "c.toml", {"method=[{sampler=\"random\"}]"});
    ASSERT_EQ(config.methods.size(), 1U);
    EXPECT_EQ(config.methods[0].sampler->name, "random");
}

TEST(Override, MistakesNameTheArgument)
{
    EXPECT_EQ(error_with("analysis.points=abc"),
              "--set analysis.points=abc: points = \"abc\": must be an integer from 1 to 134217728");
    EXPECT_EQ(error_with("sede=2"), "--set sede=2: sede = 2: unknown key; did you mean \"seed\"? "
                                    "known keys: title, seed, engine, device, analysis, method, tile_set, tiling, "
                                    "construction, distribution, scheme, texture, packing, include");
    EXPECT_EQ(error_with("method.1.relative_radius=2"), "--set method.1.relative_radius=2: relative_radius = 2: "
                                                        "must be a number greater than 0 and at most 1");
    EXPECT_EQ(error_with("method.relative_radus=0.5"),
              "--set method.relative_radus=0.5: relative_radus = 0.5: unknown key; did you mean "
              "\"relative_radius\"? "
              "known keys: sampler, label, points, order, region, planar, crs, overlap, buffer, relative_radius, stop, "
              "min_distance");
}

TEST(Override, ThatCannotBeApplied)
{
    EXPECT_EQ(error_with("seed"), "--set seed: must be key=value, for example --set seed=2");
    EXPECT_EQ(error_with("seed="), "--set seed=: a value is missing after \"=\"");
    EXPECT_EQ(error_with("=2"), "--set =2: the key must be words with dots between them, such as analysis.points");
    EXPECT_EQ(error_with("analysis..points=2"),
              "--set analysis..points=2: the key must be words with dots between them, such as analysis.points");
    EXPECT_EQ(error_with("seed.x=2"), "--set seed.x=2: \"seed\" is not a table and has no keys");
    EXPECT_EQ(error_with("method.3.label=x"),
              "--set method.3.label=x: there is no method 3: the config has 3, counted from 0");
    EXPECT_EQ(error_with("method.0=x"), "--set method.0=x: a parameter is missing: method.0.KEY=value");
    EXPECT_EQ(message_of([] { parse_config("", "c.toml", {"method.0.label=x"}); }),
              "--set method.0.label=x: the config has no [[method]] table");
    EXPECT_EQ(error_with("method.relative_radius=[0.5").substr(0, 35), "--set method.relative_radius=[0.5: ");
}

TEST(Override, PathsAreRelativeToTheWorkingFolder)
{
    const Config config = with({"method.0.sampler=file", "method.0.path=some/folder/*.dat"});
    EXPECT_EQ(config.methods[0].settings[0].choices[0].location.file, "--set");
}

}
}
