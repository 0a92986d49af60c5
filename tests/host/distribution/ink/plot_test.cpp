// Plots of marks whose places, order and sizes on paper are known; files are read back element by element.
#include "host/distribution/ink/plot.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <regex>
#include <sstream>

namespace poissonlab {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

/// The numbers of the attributes of each element of this name.
std::vector<std::vector<double>> elements_of(const std::string& svg, const std::string& name)
{
    std::vector<std::vector<double>> elements;
    const std::regex element("<" + name + "( [^>]*)/>"), attribute("\"([^\"]*)\"");
    for (std::sregex_iterator found(svg.begin(), svg.end(), element), end; found != end; ++found) {
        const std::string attributes = (*found)[1];
        elements.emplace_back();
        for (std::sregex_iterator at(attributes.begin(), attributes.end(), attribute); at != end; ++at)
            elements.back().push_back(std::stod((*at)[1]));
    }
    return elements;
}

/// Three dots of radius 1 in a picture of 100 x 50 pixels; those on 200 mm are at (20, 20), (180, 20) and (24, 20).
MarkGroup three_dots()
{
    MarkGroup marks;
    marks.disks = {{10, 40, 1}, {90, 40, 1}, {12, 40, 1}};
    return marks;
}

TEST(Plots, HaveLengthsOnPaper)
{
    EXPECT_EQ(millimetres_of("200mm"), 200);
    EXPECT_EQ(millimetres_of("20 cm"), 200);
    EXPECT_EQ(millimetres_of("0.5in"), 12.7);
    for (const char* text : {"", "mm", "200", "200px", "-3mm", "0mm", "2,5mm", "1e999mm", "3mm x", "nanmm"})
        EXPECT_FALSE(millimetres_of(text)) << text;
}

TEST(Plots, AreCirclesInTheOrderOfAShortWay)
{
    const Plot plot = plot_of(three_dots(), 100, 50, 0, {.width = 200});
    EXPECT_DOUBLE_EQ(plot.way, 4 + 156);
    EXPECT_DOUBLE_EQ(plot.way_as_made, 160 + 156);
    const std::string svg = plot_svg(plot);
    EXPECT_THAT(svg, HasSubstr("width=\"200mm\" height=\"100mm\" viewBox=\"0 0 200 100\""));
    EXPECT_THAT(svg, HasSubstr("fill=\"#000000\" stroke=\"none\""));
    EXPECT_THAT(elements_of(svg, "circle"),
                ElementsAre(ElementsAre(20, 20, 2), ElementsAre(24, 20, 2), ElementsAre(180, 20, 2)));
    const Plot as_made = plot_of(three_dots(), 100, 50, 0, {.travel = PenTravel::as_made});
    EXPECT_DOUBLE_EQ(as_made.way, 80 + 78);
    EXPECT_THAT(elements_of(plot_svg(as_made), "circle"),
                ElementsAre(ElementsAre(10, 10, 1), ElementsAre(90, 10, 1), ElementsAre(12, 10, 1)));
}

/// The picture is as wide as the sheet asks for, and the sheet wider by the margin of 1.5 pixels of 2 mm on each side.
TEST(Plots, HaveMarginsAroundThePicture)
{
    MarkGroup marks = three_dots();
    marks.disks.push_back({0.5, 40, 1});
    const Plot plot = plot_of(marks, 100, 50, 1.5, {.width = 200, .travel = PenTravel::as_made});
    EXPECT_DOUBLE_EQ(plot.width, 206);
    EXPECT_DOUBLE_EQ(plot.height, 106);
    EXPECT_THAT(elements_of(plot_svg(plot), "circle").front(), ElementsAre(23, 23, 2));
    EXPECT_THAT(elements_of(plot_svg(plot), "circle").back(), ElementsAre(4, 23, 2));
}

/// The outer edge of the pen's line is that of the dot: 4 mm across, so that the line's middle has a radius of 1.75.
TEST(Plots, AllowForThePen)
{
    const Plot plot = plot_of(three_dots(), 100, 50, 0, {.width = 200, .pen = 0.5});
    EXPECT_EQ(plot.widest_hole, 3);
    EXPECT_THAT(plot_svg(plot), HasSubstr("fill=\"none\" stroke=\"#000000\" stroke-width=\"0.5\""));
    for (const auto& circle : elements_of(plot_svg(plot), "circle")) EXPECT_EQ(circle[2], 1.75);
    // A pen that is wider than the dots draws circles that are there.
    const Plot wide = plot_of(three_dots(), 100, 50, 0, {.width = 200, .pen = 5});
    for (const auto& circle : elements_of(plot_svg(wide), "circle")) EXPECT_EQ(circle[2], 0.005);
    EXPECT_THAT(plot_words(wide), HasSubstr("the pen is wider than 3 marks, which become too dark"));
    EXPECT_EQ(plot.narrow, 0U);
}

TEST(Plots, MayHaveShortStrokes)
{
    const std::string svg = plot_svg(plot_of(three_dots(), 100, 50, 0, {.width = 200, .dots = DotForm::strokes}));
    EXPECT_THAT(svg, HasSubstr("stroke-width=\"4\" stroke-linecap=\"round\""));
    const auto lines = elements_of(svg, "line");
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_THAT(lines[1], Pointwise(DoubleNear(1e-9), {23.995, 20.0, 24.005, 20.0}));
}

/// Strokes of 1 mm whose ends are 10 mm apart are as long with a pen of 0.4 mm, and begin with the end that is nearer.
TEST(Plots, TurnStrokesRound)
{
    MarkGroup marks;
    marks.strokes = {{30, 90, 20, 90, 1}, {40, 90, 50, 90, 1}};
    const Plot plot = plot_of(marks, 100, 100, 0, {.width = 100, .pen = 0.4});
    EXPECT_DOUBLE_EQ(plot.way, 10);
    EXPECT_DOUBLE_EQ(plot.way_as_made, 20);
    EXPECT_THAT(elements_of(plot_svg(plot), "line"),
                ElementsAre(ElementsAre(19.7, 10, 30.3, 10), ElementsAre(39.7, 10, 50.3, 10)));
}

/// Each mark is the nearest one that is left: found among all of them, one by one.
TEST(Plots, GoToTheNearestMark)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> side(0.5, 63.5); // whole disks lie in the picture
    MarkGroup marks;
    for (int i = 0; i < 700; ++i) marks.disks.push_back({side(random), side(random), 0.5});
    const Plot plot = plot_of(marks, 64, 64, 0, {});
    std::vector<std::array<double, 2>> left;
    for (const auto& [x, y, radius] : marks.disks) left.push_back({x, 64 - y});
    std::array<double, 2> pen{0, 0};
    ASSERT_EQ(plot.marks.disks.size(), left.size());
    for (const auto& [x, y, radius] : plot.marks.disks) {
        const auto nearest = std::ranges::min_element(
            left, {}, [&](const auto& at) { return std::hypot(at[0] - pen[0], at[1] - pen[1]); });
        ASSERT_EQ((std::array{x, y}), *nearest);
        pen = *nearest;
        left.erase(nearest);
    }
    EXPECT_LT(plot.way, 0.1 * plot.way_as_made);
}

/// DXF is pairs of lines, a group's code and its value; y goes upwards.
TEST(Plots, AreEntitiesOfDxf)
{
    std::istringstream dxf(plot_dxf(plot_of(three_dots(), 100, 50, 0, {.width = 200}), "what"));
    std::vector<std::pair<std::string, std::string>> groups;
    for (std::string code, value; std::getline(dxf, code) && std::getline(dxf, value);)
        groups.emplace_back(code, value);
    EXPECT_THAT(groups.front(), testing::Pair("999", "what"));
    EXPECT_THAT(groups.back(), testing::Pair("0", "EOF"));
    std::vector<std::array<double, 3>> circles;
    for (std::size_t i = 0; i + 6 < groups.size(); ++i)
        if (groups[i] == std::pair<std::string, std::string>("0", "CIRCLE"))
            circles.push_back(
                {std::stod(groups[i + 2].second), std::stod(groups[i + 3].second), std::stod(groups[i + 5].second)});
    EXPECT_THAT(circles, ElementsAre(ElementsAre(20, 80, 2), ElementsAre(24, 80, 2), ElementsAre(180, 80, 2)));
}

}
}
