// Keys are described and read by the same function: what is described is what is read.
#include "host/settings/keys/keys.hpp"

#include "base/regions/region_text.hpp"
#include "host/settings/toml_reader.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Settings
{
    double ink = 0.5;
    std::optional<double> angle;
    std::uint32_t pixels = 64;
    bool is_closed = false;
    std::string look = "dots";
    std::array<double, 2> origin{1, 2};
    SpreadChoice size{SpreadChoice::Kind::constant, 1, 0};
    std::string image;
};

void visit(Keys& keys, Settings& s)
{
    keys.number("ink", s.ink, {0.001, 1}, "the part that is printed");
    keys.number("angle", s.angle, {-7, 7}, "the direction").unit("radians").otherwise("along lines");
    keys.integer("pixels", s.pixels, 16, 128, "the width");
    keys.flag("closed", s.is_closed, "whether the ends meet");
    keys.word("look", s.look, {"dots", "stars"}, "what they look like");
    keys.numbers("origin", s.origin, {{-5, 5}, {0, 5}}, {"x", "y"}, "the corner");
    keys.spread("size", s.size, {0, 1}, "how large they are");
    keys.picture_or_formula("image", s.image, "a picture or a formula").required();
}

Settings settings_of(const std::string& text, const SourceLocation& where = {"c.toml", 1})
{
    const ConfigTable table = read_toml(text, where.file);
    Keys keys(table, where, "[[thing]]");
    Settings settings;
    visit(keys, settings);
    return settings;
}

void expect_refusal(const std::string& text, const std::string& message)
{
    EXPECT_THAT(message_of([&] { settings_of("image = \"x\"\n" + text); }), HasSubstr(message)) << text;
}

TEST(Keys, ReadsWhatIsGivenAndKeepsTheRest)
{
    const Settings read = settings_of("image = \"x+1\"\nink = 1\norigin = [-1, 3.5]\nsize = { uniform = [0.25, 0.5] }");
    EXPECT_EQ(read.ink, 1);
    EXPECT_FALSE(read.angle);
    EXPECT_EQ(read.pixels, 64);
    EXPECT_THAT(read.origin, ElementsAre(-1, 3.5));
    EXPECT_EQ(read.size.kind, SpreadChoice::Kind::uniform);
    EXPECT_EQ(read.size.b, 0.5);
    EXPECT_EQ(settings_of("image = \"x\"\nangle = -2").angle, -2);
}

TEST(Keys, DescribesWithoutChangingAnything)
{
    Keys keys;
    Settings settings;
    visit(keys, settings);
    std::vector<std::string> help;
    for (const KeySpec& spec : keys.described()) help.push_back(spec.value.key + ": " + key_help(spec));
    EXPECT_THAT(help, ElementsAre("ink: The part that is printed: a number from 0.001 to 1; default: 0.5",
                                  "angle: The direction, in radians: a number from -7 to 7; default: along lines",
                                  "pixels: The width: an integer from 16 to 128; default: 64",
                                  "closed: Whether the ends meet: true or false; default: false",
                                  "look: What they look like: one of \"dots\", \"stars\"; default: dots",
                                  "origin: The corner: [x, y]; default: [1, 2]",
                                  "size: How large they are: a number from 0 to 1, { uniform = [a, b] } or { normal = "
                                  "[mean, deviation] } of such; default: 1",
                                  "image: A picture or a formula: a picture's file or a formula, in quotes; needed"));
    EXPECT_EQ(settings.image, "");
}

TEST(Keys, RefusesWithTheLineOfTheValue)
{
    expect_refusal("ink = 2", "c.toml:2: ink = 2: must be a number from 0.001 to 1");
    expect_refusal("ink = [0.1, 0.2]", "c.toml:2: ink = [0.1, 0.2]: must be a number");
    expect_refusal("pixels = 20.5", "pixels = 20.5: must be an integer from 16 to 128");
    expect_refusal("closed = 1", "closed = 1: must be true or false");
    expect_refusal("look = \"star\"", "look = \"star\": must be one of \"dots\", \"stars\"; did you mean \"stars\"?");
    expect_refusal("origin = [1]", "origin = [1]: must be [x, y]");
    expect_refusal("origin = [1, -1]", "origin = [1, -1]: must be [x, y]; y must be a number from 0 to 5");
    expect_refusal("size = { uniform = [0.5, 0.25] }", "size = {...}: must be a number from 0 to 1, { uniform");
    expect_refusal("size = 2", "size = 2: must be a number from 0 to 1, { uniform");
    EXPECT_EQ(message_of([] { settings_of("ink = 0.1", {"c.toml", 7}); }), "c.toml:7: [[thing]]: needs image");
}

TEST(Keys, NamesFilesFromTheFolderOfTheConfig)
{
    const TemporaryFolder folder;
    folder.write("photo.png", "no picture, but a file");
    const SourceLocation where{(folder.path() / "c.toml").string(), 1};
    EXPECT_EQ(settings_of("image = \"photo.png\"", where).image, (folder.path() / "photo.png").string());
    EXPECT_EQ(settings_of("image = \"photo.png\"").image, "photo.png"); // a formula that cannot be understood
}

/// A file of the same name where the program runs is not the one that the config means.
TEST(Keys, LooksForFilesBesideTheConfigAlone)
{
    const TemporaryFolder folder, elsewhere;
    elsewhere.write("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1))");
    const std::string config = (folder.path() / "c.toml").string();
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(elsewhere.path());
    std::string formula;
    const auto region = [&] {
        const ConfigTable table = read_toml("\nregion = \"square.wkt\"\nimage = \"square.wkt\"", config);
        Keys keys(table, {config, 1}, "[[thing]]");
        keys.picture_or_formula("image", formula, "a picture or a formula");
        std::string value;
        keys.region(value);
        return value;
    };
    const std::string beside = (folder.path() / "square.wkt").string();
    EXPECT_EQ(region(), beside);
    EXPECT_EQ(formula, beside);
    EXPECT_EQ(message_of([&] { read_region(beside); }), beside + ": cannot be read: No such file or directory");
    folder.write("square.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2))");
    EXPECT_EQ(region(), beside);
    std::filesystem::current_path(before);
}

TEST(Keys, WhatIsNoPictureIsRefusedAtItsKey)
{
    const TemporaryFolder folder;
    folder.write("photo.png", "no picture, but a file");
    folder.write("grey.pgm", "P2 1 1 255\n7\n");
    const std::string config = (folder.path() / "c.toml").string();
    const auto read = [&](const std::string& text) {
        const ConfigTable table = read_toml(text, config);
        Keys keys(table, {config, 1}, "[[thing]]");
        std::filesystem::path picture;
        keys.picture("exemplar", picture, "a picture");
        return picture;
    };
    EXPECT_EQ(read("exemplar = \"grey.pgm\""), folder.path() / "grey.pgm");
    EXPECT_THAT(message_of([&] { read("\nexemplar = \"photo.png\""); }),
                testing::AllOf(testing::StartsWith(config + ":2: exemplar: "), HasSubstr("cannot read the picture")));
    EXPECT_THAT(message_of([&] { read("\nexemplar = \"gone.png\""); }),
                HasSubstr(":2: exemplar = \"gone.png\": no such file"));
}

TEST(Keys, WhatOfAPictureIsMeantIsForPictures)
{
    const auto read = [&](const std::string& text) {
        const ConfigTable table = read_toml(text, "c.toml");
        Keys keys(table, {"c.toml", 1}, "[[thing]]");
        std::string image, from = "ink";
        keys.picture_or_formula("image", image, from, "a picture or a formula");
        return from;
    };
    EXPECT_EQ(read("image = \"x\"\nimage_from = \"ink\""), "ink") << "which is so without it";
    EXPECT_EQ(message_of([&] { read("image = \"x\"\nimage_from = \"light\""); }),
              "c.toml:2: image_from = \"light\": is for pictures, and image = \"x\" is none");
}

/// Resolved values are all that decide a result, defaults too, and nothing of how it was typed.
TEST(Keys, ResolvesValues)
{
    const auto resolved = [](const std::string& text) {
        const ConfigTable table = read_toml(text, "c.toml");
        Keys keys(table, {"c.toml"}, "[[thing]]");
        Settings settings;
        visit(keys, settings);
        return keys.resolved();
    };
    EXPECT_EQ(resolved("image = \"x\"\nink = 0.50"), resolved("ink = 0.5\nimage = \"x\""));
    EXPECT_EQ(resolved("image = \"x\""), resolved("ink = 0.5\nimage = \"x\""));
    EXPECT_NE(resolved("image = \"x\""), resolved("ink = 0.25\nimage = \"x\""));
    EXPECT_NE(resolved("image = \"x\""), resolved("image = \"x+0\""));
    EXPECT_NE(resolved("image = \"x\""), resolved("image = \"x\"\nangle = 0"));
}

}
}
