// Plots as gnuplot draws them: keys below overlays, and what is left of long labels there.
#include "reports/plots/gnuplot_text.hpp"

#include "base/files/whole_file.hpp"
#include "reports/plots/plot_thumbnail.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>

namespace poissonlab {
namespace {

using testing::HasSubstr;

const std::string long_label = "Lloyd relaxation of a Poisson disk set by dart throwing, N = 16,384, rho = 0.75, "
                               "iterations = 1,000, starts from the same set as the one before";

Plot plot_with(const std::vector<std::string>& labels)
{
    Plot plot{.x = {.label = "frequency", .high = 10}, .y = {.label = "power", .step = 1}};
    for (std::size_t i = 0; i < labels.size(); ++i)
        plot.curves.push_back({.index = i, .label = labels[i], .x = {0, 5, 10}, .y = {0, 0.1, 0.9}, .end = 10});
    return together(plot);
}

TEST(KeyLabel, ShortOnesStayAsTheyAre)
{
    EXPECT_EQ(key_label("Dart throwing, rho = 0.7", 3), "Dart throwing, rho = 0.7");
}

TEST(KeyLabel, LongOnesLoseTheirMiddleAndHaveANumber)
{
    const auto label = key_label(long_label, 3);
    EXPECT_THAT(label, testing::StartsWith("Lloyd relaxation of a"));
    EXPECT_THAT(label, HasSubstr("…"));
    EXPECT_THAT(label, testing::EndsWith("the one before [3]"));
    EXPECT_NE(label, key_label(long_label, 4));
}

TEST(KeyLabel, NoCharacterIsCutInTwo)
{
    std::string label;
    for (int i = 0; i < 200; ++i) label += "é";
    const auto cut = key_label("x" + label, 1);
    EXPECT_EQ(cut.substr(0, 3), "xé");
    EXPECT_EQ(std::ranges::count(cut, '\xc3'), std::ranges::count(cut, '\xa9'));
}

/// No letter reaches the right border of the picture, and every entry has a line of its own within it.
void check_key(const std::vector<std::string>& labels)
{
    const TemporaryFolder folder;
    const auto picture = gnuplot_picture(plot_with(labels), folder.path() / "a");
    draw_with_gnuplot({picture}, PrintPictures::drawn);
    const auto svg = read_whole_file(folder.path() / "a.svg");
    for (std::size_t i = 0; i < labels.size(); ++i)
        EXPECT_THAT(svg, HasSubstr(">" + key_label(labels[i], i + 1) + "<"));
    const auto png = test::decode_png(read_whole_file(folder.path() / "a.png"));
    EXPECT_EQ(png.height, 2 * picture.height);
    const auto dark = [&](int x, int y) {
        return png.grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(png.width) +
                        static_cast<std::size_t>(x)] < 160;
    };
    int at_border = 0, in_key = 0, at_foot = 0;
    for (int y = 2 * overlay_height; y < png.height; ++y)
        for (int x = 0; x < png.width; ++x) {
            at_border += dark(x, y) && x >= png.width - 8;
            at_foot += dark(x, y) && y >= png.height - 6;
            in_key += dark(x, y);
        }
    EXPECT_EQ(at_border, 0) << labels.front();
    EXPECT_EQ(at_foot, 0) << labels.front();
    EXPECT_GT(in_key, 100 * static_cast<int>(labels.size())) << labels.front();
}

TEST(OverlayKey, EveryLabelIsInThePicture)
{
    check_key({"Random"});
    check_key({long_label, "Random", long_label + ", x"});
    check_key(std::vector<std::string>(24, long_label));
}

TEST(OverlayKey, LeavesThePlotItsSize)
{
    const auto few = gnuplot_picture(plot_with({"a", "b"}), "a");
    const auto many = gnuplot_picture(plot_with(std::vector<std::string>(12, "a")), "a");
    EXPECT_EQ(few.width, many.width);
    EXPECT_GT(many.height, few.height);
}

TEST(Plots, OfOneSeriesKeepTheAxesOfAll)
{
    Plot all = plot_with({"a", "b"});
    all.y.high = 7;
    all.curves[1].end = 3;
    const Plot one = alone(all, 1);
    ASSERT_EQ(one.curves.size(), 1);
    EXPECT_EQ(one.curves[0].label, "b");
    EXPECT_EQ(one.y.high, 7);
    EXPECT_EQ(one.x.high, 3);
    EXPECT_TRUE(has_curve(all, 1));
    EXPECT_FALSE(has_curve(all, 2));
}

/// Digits of DejaVu Sans are 0.636 of the font's size wide.
TEST(Plots, NumbersBelowTheAxisDoNotRunIntoEachOther)
{
    const TemporaryFolder folder;
    for (const double high : {9.5, 95.0, 511.0, 999.0, 1023.0, 1999.0, 2047.0, 4095.0, 8191.0, 9999.0, 65'535.0, 1e6}) {
        Plot plot = plot_with({"a"});
        plot.x.high = plot.curves[0].end = high;
        draw_with_gnuplot({gnuplot_picture(alone(plot, 0), folder.path() / "a")}, PrintPictures::none);
        const auto svg = read_whole_file(folder.path() / "a.svg");
        const std::regex number("translate\\(([0-9.]+),([0-9.]+)\\)[^>]*font-size=\"([0-9.]+)\"[^>]*middle\">\\s*"
                                "<text><tspan[^>]*> *([0-9.]+)</tspan>");
        double end_of_last = -1;
        int numbers = 0;
        for (std::sregex_iterator it(svg.begin(), svg.end(), number), none; it != none; ++it, ++numbers) {
            const double middle = std::stod((*it)[1]), size = std::stod((*it)[3]);
            const double half = 0.5 * 0.636 * size * static_cast<double>((*it)[4].length());
            EXPECT_GT(middle - half, end_of_last + 3) << (*it)[4] << " of " << high;
            end_of_last = middle + half;
        }
        EXPECT_GE(numbers, 4) << high;
    }
}

TEST(PlotThumbnail, IsThePlotWithoutWords)
{
    Plot plot = plot_with({"a"});
    plot.references = {{0.5, "", 0}};
    plot.curves[0].y[1] = std::nan("");
    const Drawing drawing = plot_thumbnail(plot);
    ASSERT_GT(drawing.shapes.size(), 2);
    const Line first_dash = std::get<Line>(drawing.shapes.front().form);
    EXPECT_EQ(first_dash.points.front(), (DrawingPoint{0, 60}));
    const Line curve = std::get<Line>(drawing.shapes.back().form);
    ASSERT_EQ(curve.points.size(), 2) << "a gap is left out";
    EXPECT_EQ(curve.points.front(), (DrawingPoint{0, 120}));
    EXPECT_NEAR(curve.points.back()[0], 160, 1e-9);
    EXPECT_NEAR(curve.points.back()[1], 12, 1e-9);
    for (const Shape& shape : drawing.shapes) EXPECT_FALSE(std::holds_alternative<Text>(shape.form));
}

}
}
