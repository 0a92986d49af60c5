// Keys of plots: long labels stay inside the picture, and labels that differ do so there.
#include "reports/plots/key_layout.hpp"

#include "base/files/whole_file.hpp"
#include "reports/plots/plot_style.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <set>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr KeyRoom room{16, 440, 44};
const std::string lloyd = "Lloyd relaxation, N = 16,384, i = 128, start = Dart throwing (rho = 0.70)";
const std::string two_starts =
    "Repulsion, N = 16,384, i = 1024, start = Lloyd relaxation (i = 128, start = Relaxation dart throwing "
    "(r = 0.5, factor = 0.99, attempts = 100))";

std::string repeated(const std::string& text, int times)
{
    std::string result;
    for (int i = 0; i < times; ++i) result += text;
    return result;
}

/// Sizes and lines of a layout are as promised, for every kind of label.
void check(const std::vector<std::string>& labels)
{
    const auto layout = lay_out_key(labels, room);
    EXPECT_GE(layout.scale, least_key_scale);
    EXPECT_LE(layout.scale, 1);
    ASSERT_EQ(layout.lines.size(), labels.size());
    for (const auto& lines : layout.lines) {
        EXPECT_GE(lines.size(), 1);
        EXPECT_LE(lines.size(), 2);
        for (const auto& line : lines)
            EXPECT_LE(layout.scale * (room.sample_size + room.font_size * text_width(line)), room.width) << line;
    }
    const std::set<std::string> different(labels.begin(), labels.end());
    const std::set<std::vector<std::string>> shown(layout.lines.begin(), layout.lines.end());
    EXPECT_EQ(shown.size(), different.size());
}

TEST(KeyLayout, WidthsAreThoseOfDejaVuSans)
{
    EXPECT_NEAR(text_width("Lloyd relaxation, N = 256, i = 128, start = Dart throwing (rho = 0.70)"), 34.904, 0.001);
    EXPECT_GT(text_width("ä"), text_width("a"));
    EXPECT_LT(text_width("ä"), 1);
}

TEST(KeyLayout, ShortLabelsStayAsTheyAre)
{
    const auto layout = lay_out_key({"Random", "Jittered, N = 256"}, room);
    EXPECT_EQ(layout.scale, 1);
    EXPECT_THAT(layout.lines, ElementsAre(ElementsAre("Random"), ElementsAre("Jittered, N = 256")));
}

TEST(KeyLayout, LettersBecomeSmallerFirst)
{
    const auto layout = lay_out_key({"Random", lloyd}, room);
    EXPECT_GT(layout.scale, least_key_scale);
    EXPECT_LT(layout.scale, 0.8);
    EXPECT_THAT(layout.lines, ElementsAre(ElementsAre("Random"), ElementsAre(lloyd)));
}

TEST(KeyLayout, ThenLabelsBreakAtACommaAndLettersGrow)
{
    const auto layout = lay_out_key({"Random", lloyd + ", engine = reference"}, room);
    EXPECT_GT(layout.scale, 0.75);
    EXPECT_THAT(layout.lines, ElementsAre(ElementsAre("Random"), ElementsAre("Lloyd relaxation, N = 16,384, i = 128,",
                                                                             "    start = Dart throwing (rho = 0.70), "
                                                                             "engine = reference")));
}

TEST(KeyLayout, ThenTheMiddleIsLeftOut)
{
    const auto layout = lay_out_key({two_starts + ", " + two_starts + ", the end"}, room);
    EXPECT_EQ(layout.scale, least_key_scale);
    ASSERT_EQ(layout.lines[0].size(), 2);
    EXPECT_THAT(layout.lines[0][0], testing::StartsWith("Repulsion, N = 16,384"));
    EXPECT_THAT(layout.lines[0][1], HasSubstr("…"));
    EXPECT_THAT(layout.lines[0][1], testing::EndsWith(", the end"));
}

TEST(KeyLayout, EveryLabelFitsAndDiffers)
{
    check({});
    check({""});
    check({"Random"});
    check({lloyd, two_starts, two_starts + " (run-2)", lloyd + "\n" + two_starts});
    check({repeated("W", 1000), repeated("W", 1001), repeated("W", 999) + "i"});
    check({repeated("\u00e9", 500), repeated("\u00e9", 501)});
    check({repeated("\u6c34", 500), repeated("\u6c34", 501), "\U0001f4a7"});
    check({repeated("a ", 500), repeated("a, ", 500), repeated("a  ", 500)});
    // They differ at every hundredth letter, one after the other.
    std::vector<std::string> labels;
    for (std::size_t at = 0; at < 1000; at += 100) {
        labels.emplace_back(1000, 'x');
        labels.back()[at] = 'y';
    }
    check(labels);
}

TEST(KeyLayout, EveryLengthFits)
{
    for (std::size_t length = 1; length < 300; ++length)
        check({repeated("rho = 0.7, ", 30).substr(0, length), "Random"});
}

/// No letter reaches the right border of the picture, whatever the labels; what the plot itself has there is
/// the last number of its axis.
void check_picture(const std::vector<std::string>& labels)
{
    const TemporaryFolder folder;
    std::vector<KeyEntry> key;
    for (std::size_t i = 0; i < labels.size(); ++i) key.push_back({i, labels[i]});
    const auto commands = axes("frequency", 0, 10, {"power", 0, 1, 1, 0}) + "set lmargin 8.5\n";
    draw_with_gnuplot({with_key(commands, "plot x notitle", key, folder.path() / "a")});
    const auto picture = test::decode_png(read_whole_file(folder.path() / "a.png"));
    std::size_t dark_at_border = 0;
    std::size_t dark_near_it = 0;
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y)
        for (int from_right = 1; from_right <= 120; ++from_right) {
            const auto grey =
                picture.grey[(y + 1) * static_cast<std::size_t>(picture.width) - static_cast<std::size_t>(from_right)];
            (from_right <= 8 ? dark_at_border : dark_near_it) += grey < 160;
        }
    EXPECT_EQ(dark_at_border, 0) << labels.front();
    EXPECT_GT(dark_near_it, 500) << "the key does not use its room: " << labels.front();
}

TEST(KeyLayout, NoLetterIsCutOffInThePicture)
{
    check_picture({lloyd});
    check_picture({lloyd, lloyd + ", x", "Random"});
    check_picture({two_starts, lloyd});
    check_picture({two_starts + two_starts, two_starts + ", " + two_starts});
    check_picture({repeated("W", 40)});
    check_picture({repeated("W", 200)});
    check_picture({repeated("i", 400)});
}

TEST(KeyLayout, SecondLinesHaveNoSample)
{
    const auto picture = with_key("", "plot x notitle", {{0, two_starts}, {1, "Random"}}, "a");
    EXPECT_THAT(picture.commands, HasSubstr("keyentry with lines lt nodraw title '    "));
    std::vector<KeyEntry> short_ones;
    std::vector<KeyEntry> long_ones;
    for (std::size_t i = 0; i < 6; ++i) {
        short_ones.push_back({i, "Repulsion"});
        long_ones.push_back({i, two_starts + std::to_string(i)});
    }
    EXPECT_GT(with_key("", "plot x notitle", long_ones, "a").height,
              with_key("", "plot x notitle", short_ones, "a").height);
}

}
}
