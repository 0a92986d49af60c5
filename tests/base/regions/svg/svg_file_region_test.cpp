// Drawings of SVG as regions: areas and boxes in closed form, what is left out, and what is refused by name.
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class SvgFileRegions : public testing::Test
{
protected:
    /// A drawing on a sheet from (0, 0) to (200, 100), a line for each of the elements, from the second line on.
    std::string drawing(const std::string& elements) const
    {
        return folder_
            .write("a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:ink=\"http://ink\" "
                            "viewBox=\"0 0 200 100\" width=\"20cm\" height=\"10cm\">\n" +
                                elements + "\n</svg>\n")
            .string();
    }

    PlaneRegion region(const std::string& elements) const { return read_region(drawing(elements)); }

    std::string refusal(const std::string& elements) const
    {
        return message_of([&] { region(elements); });
    }

    /// x and y of the lowest corner, then of the highest one.
    std::vector<double> box(const std::string& elements) const
    {
        const RegionBox box = box_of(region(elements));
        return {box.low[0], box.low[1], box.high[0], box.high[1]};
    }

    TemporaryFolder folder_;
};

/// y goes upwards from the lower left corner of the sheet.
TEST_F(SvgFileRegions, AreUprightInUnitsOfTheSheet)
{
    EXPECT_THAT(box("<rect x='2' y='3' width='10' height='5'/>"), ElementsAre(2, 92, 12, 97));
    EXPECT_EQ(area_of(region("<rect x='2' y='3' width='10' height='5px'/>")), 50);
    const std::string elsewhere =
        folder_.write("b.svg", "<svg viewBox='-10 5 20 10'><polygon points='0,6 2 6,2-7'/></svg>").string();
    const RegionBox box = box_of(read_region(elsewhere));
    EXPECT_THAT(box.low, ElementsAre(10, 9));
    EXPECT_THAT(box.high, ElementsAre(12, 22));
    // Without a viewBox, units are pixels, 96 to an inch.
    const std::string plain =
        folder_.write("c.SVG", "<svg width='2in' height='1in'><rect width='1in' height='0.5in'/></svg>").string();
    EXPECT_THAT(box_of(read_region(plain)).low, ElementsAre(0, 48));
    EXPECT_THAT(box_of(read_region(plain)).high, ElementsAre(96, 96));
}

TEST_F(SvgFileRegions, HaveTheAreasOfTheirShapes)
{
    // Chords are off by 1e-4 of the longest side at most, and take two thirds of that off the area along them.
    const double pi = std::numbers::pi;
    const auto lost = [](double along, double longest) { return 2 / 3.0 * 1e-4 * longest * along * 1.01; };
    EXPECT_NEAR(area_of(region("<circle cx='30' cy='30' r='10'/>")), 100 * pi, lost(20 * pi, 20));
    EXPECT_NEAR(area_of(region("<ellipse cx='30' cy='30' rx='20' ry='10'/>")), 200 * pi, lost(97, 40));
    EXPECT_NEAR(area_of(region("<rect width='40' height='20' rx='5' ry='4'/>")), 800 - (4 - pi) * 20, lost(28.4, 40));
    EXPECT_NEAR(area_of(region("<rect width='40' height='20' ry='30'/>")), 200 * pi, lost(97, 40));
    EXPECT_EQ(area_of(region("<polyline points='0 0 6 0 6 4'/>")), 12);
    EXPECT_EQ(area_of(region("<path d='M0 0h9v9h-9z M3 3h3v3h-3z' fill-rule='evenodd'/>")), 72);
    EXPECT_EQ(area_of(region("<path d='M0 0h9v9h-9z M3 3h3v3h-3z'/>")), 81);
    EXPECT_EQ(area_of(region("<g style='fill:red;fill-rule: evenodd'><path d='M0 0h9v9h-9z M3 3h3v3h-3z'/></g>")), 72);
    EXPECT_EQ(region("<rect width='9' height='9'/>\n<rect x='10' width='9' height='9'/>").polygons.size(), 2U);
}

/// A quarter turn takes (x, y) to (-y, x); then the group moves.
TEST_F(SvgFileRegions, GoWithTheTransformsOfTheirGroups)
{
    const std::string rectangle = "<rect width='4' height='2'/>";
    const auto in_group = [&](const std::string& outer, const std::string& inner) {
        return "<g transform='" + outer + "'><g transform='" + inner + "'>" + rectangle + "</g></g>";
    };
    const auto is = [](double a, double b, double c, double d) {
        return testing::Pointwise(testing::DoubleNear(1e-9), {a, b, c, d});
    };
    EXPECT_THAT(box(in_group("translate(10,20)", "rotate(90)")), is(8, 76, 10, 80));
    EXPECT_THAT(box("<rect width='4' height='2' transform='translate(10,20) rotate(90)'/>"), is(8, 76, 10, 80));
    EXPECT_THAT(box(in_group("rotate(90)", "translate(10,-20)")), is(18, 86, 20, 90));
    EXPECT_THAT(box("<rect width='4' height='2' transform='rotate(180 10 10)'/>"), is(16, 80, 20, 82));
    EXPECT_THAT(box(in_group("scale(2)", "matrix(1 0 0 3 1 1)")), is(2, 86, 10, 98));
    EXPECT_THAT(box(in_group("skewX(45)", "scale(1 .5)")), is(0, 99, 5, 100));
    EXPECT_THAT(box(in_group("skewY(45)", "translate(1-0)")), is(1, 93, 5, 99));
    const double pi = std::numbers::pi;
    EXPECT_NEAR(area_of(region("<g transform='scale(3 1) rotate(30)'><circle cx='30' r='5'/></g>")), 75 * pi, 0.3);
}

TEST_F(SvgFileRegions, LeaveOutWhatIsNotSeen)
{
    EXPECT_EQ(area_of(region("<title>A text</title><metadata><ink:any><rect/></ink:any></metadata>\n"
                             "<ink:view zoom='2'><text>?</text></ink:view>\n"
                             "<defs><circle r='9'/><linearGradient><stop/></linearGradient></defs>\n"
                             "<style>.a { fill: red }</style>\n"
                             "<g display='none'><text>hidden</text></g>\n"
                             "<g style='display:none'><rect width='5' height='5'/></g>\n"
                             "<g visibility='hidden'><rect width='9' height='9'/>\n"
                             "<rect x='20' width='3' height='2' visibility='visible'/></g>")),
              6);
    // Properties that are inherited by name, and those of style sheets' words.
    EXPECT_EQ(area_of(region("<g visibility='hidden'><rect visibility='inherit' width='9' height='9'/></g>\n"
                             "<g visibility='visible'><rect visibility='inherit' width='2' height='3'/></g>\n"
                             "<rect style='display:none !important' x='20' width='3' height='2'/>")),
              6);
    EXPECT_EQ(area_of(region("<g visibility='hidden'><rect style='visibility:initial' width='2' height='3'/></g>\n"
                             "<g visibility='hidden'><rect visibility='unset' x='20' width='9' height='9'/></g>\n"
                             "<rect style='display:none !important; display:inline' x='40' width='3' height='2'/>\n"
                             "<rect clip-path='initial' transform='unset' x='60' width='5' height='1'/>")),
              11);
    EXPECT_EQ(area_of(region("<g fill-rule='evenodd'><path fill-rule='unset' d='M0 0h9v9h-9z M3 3h3v3h-3z'/></g>")),
              72);
    EXPECT_EQ(area_of(region("<g fill-rule='evenodd'><path fill-rule='initial' d='M0 0h9v9h-9z M3 3h3v3h-3z'/></g>")),
              81);
    EXPECT_EQ(area_of(region("<g fill-rule='evenodd'><path fill-rule='inherit' d='M0 0h9v9h-9z M3 3h3v3h-3z'/></g>")),
              72);
    EXPECT_EQ(area_of(region("<g display='none' transform='scale(0)'/><rect width='2' height='3'/>")), 6);
}

TEST_F(SvgFileRegions, RefuseWhatIsNotKnown)
{
    EXPECT_THAT(
        refusal("\n<text>words</text>"),
        EndsWith("a.svg:3: <text>: is not known here: regions are made of path, polygon, polyline, line, rect, circle "
                 "and ellipse, in groups (g)"));
    EXPECT_THAT(refusal("<use href='#a'/>"), HasSubstr("a.svg:2: <use>: is not known here"));
    EXPECT_THAT(refusal("<svg><rect width='1' height='1'/></svg>"), HasSubstr("a.svg:2: <svg>: is not known here"));
    EXPECT_THAT(refusal("<g clip-path='url(#a)'/>"), EndsWith("a.svg:2: <g>: clip-path is not known here"));
    EXPECT_THAT(refusal("<style>\n.a { display: none }</style>"),
                EndsWith("a.svg:3: <style>: says display, which counts in attributes alone here"));
    EXPECT_THAT(refusal("<g transform='turn(3)'/>"), HasSubstr("a.svg:2: <g>: transform \"turn(3)\": must be made of"));
    EXPECT_THAT(refusal("<g transform='scale(0)'/>"), HasSubstr("and leave an area"));
    EXPECT_THAT(refusal("<rect width='50%' height='1'/>"),
                HasSubstr("a.svg:2: <rect>: width \"50%\": must be a length"));
    EXPECT_THAT(refusal("<rect height='1'/>"), EndsWith("<rect>: its width and height must be above 0"));
    EXPECT_THAT(refusal("<circle/>"), EndsWith("<circle>: its radius must be above 0"));
    EXPECT_THAT(refusal("<polygon points='0 0 1 1 2'/>"), HasSubstr("<polygon>: points \"0 0 1 1 2\": must be pairs"));
    EXPECT_THAT(refusal("<path d='M0 0 X'/>"), HasSubstr("a.svg:2: <path>: d: is not a path of SVG"));
    EXPECT_THAT(refusal("<path d='M0 0 L9 9'/>"), EndsWith("a.svg:2: <path>: goes around nothing"));
    EXPECT_THAT(refusal("<path d='M0 0 L9 9 L9 0 L0 9z'/>"), HasSubstr("a.svg:2: <path>: "));
    EXPECT_THAT(refusal("<g>"), HasSubstr("a.svg:3: is not XML: mismatched tag"));
    EXPECT_THAT(refusal(""), HasSubstr("a.svg: has no shape"));
    // What lies over something else may be white.
    EXPECT_THAT(refusal("<rect width='9' height='9'/><rect x='3' y='3' width='3' height='3'/>"), HasSubstr("a.svg: "));
    const std::string html = folder_.write("b.svg", "<html></html>").string();
    EXPECT_THAT(message_of([&] { read_region(html); }), EndsWith("b.svg:1: is no drawing of SVG: begins with <html>"));
}

}
}
