// The table [[construction]] of a config.
#include "host/scenes/construction_panels.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/exhibits.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::vector<ShownConstruction> constructions_of(const std::string& text)
{
    return settings_in<ShownConstruction>(exhibits_in(text));
}

TEST(ConstructionTable, HasDefaults)
{
    const auto all = constructions_of("seed = 7\n[[construction]]\n[[construction]]\nkind = \"sphere\"\n"
                                      "[[construction]]\nkind = \"template\"\nshow = \"tile\"\n"
                                      "[[construction]]\nkind = \"edge\"\nshow = \"tiles\"\n");
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].show, "regions");
    EXPECT_EQ(exhibits_in("[[construction]]\n").at(0).label, "Regions, corner-based Poisson disk tiles");
    EXPECT_EQ(all[0].parameters.tiles, 16u);
    EXPECT_EQ(exhibits_in("seed = 7\n[[construction]]\n").at(0).seed, 7u);
    EXPECT_FALSE(all[0].seed);
    EXPECT_EQ(all[1].parameters.dimension, 3);
    EXPECT_TRUE(all[1].modified);
    EXPECT_EQ(all[2].variant, 1u) << "tile 0 is the master";
    EXPECT_EQ(all[2].axes, 3);
    EXPECT_EQ(all[3].parameters.tiles, 4096u);
    EXPECT_EQ(all[3].count, 16u);
    EXPECT_TRUE(all[3].is_list());
}

TEST(ConstructionTable, ChainsAreShownInTilingsAlone)
{
    EXPECT_NO_THROW(constructions_of("[[construction]]\nshow = \"points\"\nborder = \"chain\"\n"));
    for (const char* show : {"regions", "tile", "corners"})
        EXPECT_THAT(
            [&] { constructions_of(fmt::format("[[construction]]\nshow = \"{}\"\nborder = \"chain\"\n", show)); },
            testing::ThrowsMessage<InputError>(HasSubstr("must be strip, or show must be tiling or points")));
}

TEST(ConstructionTable, TakesEveryKey)
{
    const auto all = constructions_of(
        "[[construction]]\nkind = \"corner\"\nshow = \"edge\"\ncolors = 3\npoints_per_tile = 48\n"
        "relative_radius = 0.65\nfilling = \"dart-throwing\"\nlloyd_iterations = 3\nrepulsion = false\nseed "
        "= 9\n"
        "along = \"y\"\nvariant = 5\nlabel = \"L\"\n"
        "[[construction]]\nkind = \"sphere\"\nshow = \"face\"\nalong = \"yz\"\nvariant = 15\n"
        "[[construction]]\nkind = \"template\"\nshow = \"points\"\ntiles = 12\nwindow = [-1, 2, 3, 4]\n"
        "[[construction]]\nkind = \"sphere\"\nshow = \"regions\"\nmodified = false\n"
        "[[construction]]\nkind = \"edge\"\nshow = \"corners\"\ncount = 4\n");
    ASSERT_EQ(all.size(), 5u);
    const PoissonTileParameters& p = all[0].parameters;
    EXPECT_EQ(p.colors, 3u);
    EXPECT_EQ(p.points_per_tile, 48u);
    EXPECT_EQ(p.relative_radius, 0.65);
    EXPECT_EQ(p.filling, TileFilling::dart_throwing);
    EXPECT_EQ(p.lloyd_iterations, 3u);
    EXPECT_FALSE(p.repulsion);
    EXPECT_EQ(all[0].seed, 9u);
    EXPECT_EQ(all[0].axes, 2);
    EXPECT_EQ(all[0].variant, 5u);
    EXPECT_EQ(exhibits_in("[[construction]]\nlabel = \"L\"\n").at(0).label, "L");
    EXPECT_TRUE(all[0].is_stage());
    EXPECT_EQ(all[1].axes, 6);
    EXPECT_EQ(all[2].parameters.tiles, 12u);
    EXPECT_EQ(all[2].window.x, -1);
    EXPECT_EQ(all[2].window.height, 4u);
    EXPECT_FALSE(all[3].modified);
    EXPECT_EQ(all[4].count, 4u);
}

TEST(ConstructionTable, SaysWhatIsAllowed)
{
    const auto error_of = [](const std::string& lines) {
        return message_of([&] { constructions_of("[[construction]]\n" + lines + "\n"); });
    };
    EXPECT_THAT(error_of("kind = \"wang\""),
                HasSubstr("c.toml:2: kind = \"wang\": must be one of \"corner\", \"edge\", \"template\", \"sphere\""));
    EXPECT_THAT(error_of("show = \"face\""), HasSubstr("c.toml:2: show = \"face\": must be one of \"regions\""));
    EXPECT_THAT(error_of("kind = \"sphere\"\nshow = \"tiling\""), HasSubstr("c.toml:3: show = \"tiling\""));
    EXPECT_THAT(error_of("colors = 0"), HasSubstr("c.toml:2: colors = 0: must be an integer from 1 to 32"));
    EXPECT_THAT(error_of("colors = 256"), HasSubstr("c.toml:2: colors = 256: "));
    EXPECT_THAT(error_of("kind = \"template\"\ntiles = 0"), HasSubstr("must be an integer from 1 to 1048576"));
    EXPECT_THAT(error_of("relative_radius = 2"), HasSubstr("must be a number greater than 0 and less than 1"));
    EXPECT_THAT(error_of("points_per_tile = 5\nrelative_radius = 0.9"),
                HasSubstr("c.toml:3: relative_radius = 0.9: must be at most"));
    EXPECT_THAT(error_of("points_per_tile = 3"), HasSubstr("c.toml:2: points_per_tile = 3: must be an integer from 4"));
    EXPECT_THAT(error_of("show = \"edge\"\nalong = \"z\""), HasSubstr("along = \"z\": must be one of \"x\", \"y\""));
    EXPECT_THAT(error_of("show = \"corner\"\nvariant = 2"), HasSubstr("must be 0 or 1"));
    EXPECT_THAT(error_of("show = \"corners\"\ncount = 3"), HasSubstr("must be 1 or 2"));
    EXPECT_THAT(error_of("show = \"tiling\"\nwindow = [0, 0, 3]"), HasSubstr("must be [X, Y, width, height]"));
    EXPECT_THAT(error_of("show = \"tiling\"\nwindow = [0, 0, 65, 1]"), HasSubstr("from 1 to 64 tiles"));
    EXPECT_THAT(error_of("show = \"tiling\"\nwindow = [0, 0, 64, 64]"), HasSubstr("at most 100000 points"));
    EXPECT_THAT(error_of("repulsion = 1"), HasSubstr("must be true or false"));
    EXPECT_THAT(error_of("filling = \"jittered\""),
                HasSubstr("must be one of \"dart-throwing\", \"relaxation-dart-throwing\""));
    EXPECT_THAT(error_of("label = \"\""), HasSubstr("must be a line of text"));
    // Keys that say nothing about what is shown.
    EXPECT_THAT(error_of("show = \"corner\"\nalong = \"x\""), HasSubstr("c.toml:3: "));
    EXPECT_THAT(error_of("show = \"corner\"\nwindow = [0, 0, 1, 1]"), HasSubstr("is for show = tiling, points"));
    EXPECT_THAT(error_of("kind = \"template\"\ncolors = 2"), HasSubstr("unknown key"));
    EXPECT_THAT(error_of("modified = false"), HasSubstr("unknown key"));
    EXPECT_THAT(message_of([] { constructions_of("construction = 3\n"); }), HasSubstr("written [[construction]]"));
}

}
}
