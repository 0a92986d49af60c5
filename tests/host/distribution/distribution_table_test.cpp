// Tables [[distribution]] of a config, and what they refuse.
#include "experiment/exhibits/exhibit.hpp"

#include "experiment/config/config.hpp"
#include "host/distribution/icons.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::vector<Exhibit> distributions_of(const std::string& lines)
{
    return read_exhibits(parse_config("seed = 7\n[[distribution]]\n" + lines, "c.toml"));
}

void expect_refusal(const std::string& lines, const std::string& message)
{
    EXPECT_THAT(message_of([&] { distributions_of(lines); }), HasSubstr(message)) << lines;
}

TEST(DistributionTable, ReadsAWarp)
{
    const auto read = distributions_of("kind = \"warp\"\ndensity = \"x+1\"\npoints = 12\n"
                                       "method = { sampler = \"dart-throwing\", relative_radius = 0.7 }");
    ASSERT_EQ(read.size(), 1);
    EXPECT_EQ(read[0].kind->word, "warp");
    EXPECT_EQ(read[0].label, "Warped points by x+1");
    EXPECT_EQ(read[0].seed, 7);
    const WarpSettings& settings = read[0].settings.as<WarpSettings>();
    EXPECT_EQ(settings.points, 12);
    EXPECT_FALSE(settings.is_environment);
    const auto sky = distributions_of("kind = \"warp\"\ndensity = \"x+1\"\npoints = 12\nenvironment = true\n"
                                      "seen_from = \"outside\"");
    EXPECT_EQ(sky.at(0).settings.as<WarpSettings>().seen_from, SeenFrom::outside);
    expect_refusal("kind = \"warp\"\ndensity = \"x+1\"\npoints = 12\nseen_from = \"outside\"",
                   "c.toml:6: seen_from = \"outside\": needs environment");
    ASSERT_TRUE(settings.method.sampler);
    EXPECT_EQ(settings.method.sampler->parameters.number("relative_radius"), 0.7);
}

/// The text is part of the keys of stored work: it differs wherever values do, and is the same whatever the label.
TEST(DistributionTable, HasEveryValueInItsText)
{
    const auto read = distributions_of("kind = \"warp\"\ndensity = \"x+1\"\npoints = 12\n"
                                       "method = { sampler = \"dart-throwing\", relative_radius = 0.70 }");
    EXPECT_EQ(read[0].identity(),
              "kind = warp, environment = false, density = x+1, density_from = light, seen_from = inside, "
              "points = 12, method = { sampler = dart-throwing, relative_radius = 0.7 }, tiles = , ");
}

TEST(DistributionTable, RefusesWhatItDoesNotKnow)
{
    expect_refusal("kind = \"wrap\"", "c.toml:3: kind = \"wrap\": must be");
    expect_refusal("density = \"x+1\"\npoints = 12\ncolour = 3", "c.toml:5: colour");
    expect_refusal("points = 12", "c.toml:2: [[distribution]]: needs density");
    expect_refusal("density = \"x+1\"", "c.toml:2: [[distribution]]: needs points");
    expect_refusal("density = \"x+\"\npoints = 12", "c.toml:3: density: formula \"x+\"");
    expect_refusal("density = \"none.png\"\npoints = 12", "c.toml:3: density: none.png: no such file");
    expect_refusal("density = \"x+1\"\npoints = 0", "c.toml:4: points = 0: must be");
    expect_refusal("density = \"x+1\"\npoints = 9\nmethod = \"regula\"",
                   "c.toml:5: method = \"regula\": must be one of");
    expect_refusal("density = \"x+1\"\npoints = 9\ntiles = \"none.ptiles\"",
                   "tiles = \"none.ptiles\": no such file: must be a file");
    const std::string tiles = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
    expect_refusal("density = \"x+1\"\npoints = 9\ntiles = \"" + tiles + "\"\nmethod = \"random\"",
                   "cannot be combined with method");
    expect_refusal("density = \"x+1\"\ndensity_from = \"ink\"\npoints = 9",
                   "c.toml:4: density_from = \"ink\": is for pictures, and density = \"x+1\" is none");
}

TEST(DistributionTable, ReadsStipplingAndHatching)
{
    const auto read = distributions_of("kind = \"stippling\"\nimage = \"0.3\"\npoints = 12\nink = 0.5");
    const StippleSettings& dots = read.at(0).settings.as<StippleSettings>();
    EXPECT_EQ(read[0].label, "Stippling of 0.3");
    EXPECT_EQ(dots.points, 12);
    EXPECT_EQ(dots.ink, 0.5);
    EXPECT_FALSE(dots.has_strokes);
    EXPECT_EQ(dots.by, MarkPlaces::gaussian);
    const auto hatched = distributions_of("kind = \"hatching\"\nimage = \"0.3\"\nstroke = 2.5\nangle = 1");
    const StippleSettings& strokes = hatched.at(0).settings.as<StippleSettings>();
    EXPECT_TRUE(strokes.has_strokes);
    EXPECT_EQ(strokes.mark_width, 2.5);
    EXPECT_EQ(strokes.angle, 1);
    const auto relaxed =
        distributions_of("kind = \"stippling\"\nimage = \"0.3\"\npoints = 12\nby = \"gaussian\"\niterations = 7");
    EXPECT_EQ(relaxed.at(0).settings.as<StippleSettings>().by, MarkPlaces::gaussian);
    EXPECT_EQ(relaxed.at(0).settings.as<StippleSettings>().iterations, 7);
    const std::string image = "kind = \"stippling\"\nimage = \"0.3\"\n";
    expect_refusal("kind = \"stippling\"\npoints = 3", "[[distribution]]: needs image");
    expect_refusal("kind = \"stippling\"\nimage = \"x+\"\npoints = 3", "c.toml:4: image: formula \"x+\"");
    expect_refusal(image, "needs points or dot");
    expect_refusal(image + "points = 3\ndot = 2", "c.toml:6: dot = 2: cannot be combined with points");
    expect_refusal(image + "points = 3\nby = \"rank\"", "by = \"rank\"");
    expect_refusal(image + "points = 3\nby = \"ranks\"\nmethod = \"random\"", "cannot be combined with by = \"ranks\"");
    expect_refusal(image + "points = 3\nby = \"ranks\"\niterations = 3", "iterations = 3: is for by = \"gaussian\"");
    expect_refusal(image + "points = 3\nink = 2", "ink = 2: must be");
    expect_refusal(image + "points = 3\nangle = 2", "c.toml:6: angle");
}

TEST(DistributionTable, ReadsIcons)
{
    const auto read = distributions_of("kind = \"icons\"\nu = \"-y\"\nv = \"x\"\npoints = 12\nlength = \"one\"");
    const IconSettings& icons = read.at(0).settings.as<IconSettings>();
    EXPECT_EQ(read[0].label, "Icons of (-y, x)");
    EXPECT_TRUE(icons.have_one_length);
    expect_refusal("kind = \"icons\"\npoints = 3\nu = \"x\"", "needs field, or u and v");
    expect_refusal("kind = \"icons\"\npoints = 3\nu = \"x\"\nv = \"x+\"", "c.toml:6: v: formula \"x+\"");
    expect_refusal("kind = \"icons\"\npoints = 3\nfield = \"none.exr\"",
                   "field = \"none.exr\": no such file: must be a file");
}

TEST(DistributionTable, ReadsInstances)
{
    const auto read = distributions_of("kind = \"instances\"\nscene = \"asteroids\"\nring = [0.2, 0.4, 0.1]\n"
                                       "scale = { uniform = [0.5, 0.75] }");
    const InstanceSettings& belt = read.at(0).settings.as<InstanceSettings>();
    EXPECT_EQ(read[0].label, "Instances: asteroids");
    EXPECT_EQ(belt.ring[1], 0.4);
    EXPECT_EQ(belt.scale.b, 0.75);
    EXPECT_EQ(belt.models, 8);
    const std::string forest = "kind = \"instances\"\n";
    expect_refusal(forest + "scene = \"wood\"", "c.toml:4: scene = \"wood\": must be");
    expect_refusal(forest + "window = [0, 0, 1]", "must be [x, y, width, height]");
    expect_refusal(forest + "window = [0, 0, 1, 0]",
                   "must be [x, y, width, height]; height must be a number from 0.001 to 1000000");
    expect_refusal(forest + "window = [0, 0, 1000, 1000]", "2000000000 instances in the window: must be at most");
    expect_refusal(forest + "ring = [0.2, 0.4, 0.1]", "ring = [0.2, 0.4, 0.1]: is for asteroids");
    expect_refusal(forest + "height = 2", "c.toml:4: height = 2: needs terrain");
    expect_refusal(forest + "terrain = \"x\"", "needs terrain_area");
    expect_refusal(forest + "scale = 2", "scale = 2: must be a number from 0.001 to 1");
    expect_refusal(forest + "scene = \"asteroids\"\nring = [0.4, 0.2, 0.1]", "must be [inner, outer, thickness] with");
}

}
}
