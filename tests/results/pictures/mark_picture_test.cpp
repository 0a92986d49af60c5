// Pictures of marks, written, read and drawn.
#include "results/pictures/mark_picture.hpp"

#include "reports/drawings/mark_image.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

MarkPicture some_marks()
{
    MarkPicture picture;
    picture.width = 20;
    picture.height = 10;
    picture.pixels = 200;
    picture.groups = {{"#ff0000", {{5, 2.5, 1}}, {}},
                      {"#0000ff", {}, {{12, 8, 18, 8, 1}}},
                      {"#00ff00", {}, {}, {{{1, 6}, {3, 6}, {3, 9}, {1, 9}}, {{6, 6}, {8, 6}, {8, 8}}}}};
    picture.words = {{{10, 5}, 1, "words"}};
    return picture;
}

TEST(MarkPicture, IsReadAsItWasWritten)
{
    const TemporaryFolder folder;
    folder.write("marks.json", mark_picture_json(some_marks()));
    EXPECT_EQ(read_mark_picture(folder.path() / "marks.json"), some_marks());
}

/// y goes up in pictures and down in drawings; a unit is ten pixels.
TEST(MarkPicture, IsDrawnWhereMarksAre)
{
    MarkPicture picture = some_marks();
    picture.words.clear();
    const Drawing drawing = draw_marks(picture, "");
    EXPECT_EQ(drawing.width, 200);
    EXPECT_EQ(drawing.height, 100);
    const test::Pixels pixels(drawing, 1);
    EXPECT_EQ(pixels.at(50, 75), "#ff0000");
    EXPECT_EQ(pixels.at(50, 62), "#ffffff");
    EXPECT_EQ(pixels.at(150, 20), "#0000ff");
    EXPECT_EQ(pixels.at(150, 28), "#ffffff");
    EXPECT_EQ(pixels.at(20, 25), "#00ff00");
    EXPECT_EQ(pixels.at(35, 25), "#ffffff");
    EXPECT_EQ(pixels.at(75, 35), "#00ff00");
    EXPECT_EQ(pixels.at(65, 25), "#ffffff");
}

TEST(MarkPicture, IsRefusedWhereItIsDamaged)
{
    const auto refusal = [](const std::string& from, const std::string& to) {
        const TemporaryFolder folder;
        std::string text = mark_picture_json(some_marks());
        text.replace(text.find(from), from.size(), to);
        folder.write("marks.json", text);
        return message_of([&] { read_mark_picture(folder.path() / "marks.json"); });
    };
    EXPECT_THAT(refusal("poissonlab-marks", "else"), HasSubstr("must be \"poissonlab-marks\""));
    EXPECT_THAT(refusal("#ff0000", "red"), HasSubstr("must be #rrggbb"));
    EXPECT_THAT(refusal("\"polygons\":[4", "\"polygons\":[40"), HasSubstr("must have the number of corners"));
    EXPECT_THAT(refusal("\"polygons\":[4", "\"polygons\":[2"), HasSubstr("must have the number of corners"));
    EXPECT_THAT(refusal("5.0,2.5,1.0", "5.0,2.5"), HasSubstr("must have 3 numbers for each mark"));
    EXPECT_THAT(refusal("\"width\":20.0", "\"width\":0"), HasSubstr("must be a rectangle"));
    EXPECT_THAT(refusal("\"pixels\":200", "\"pixels\":99999"), HasSubstr("must be at most"));
}

}
}
