// The pixels of drawings: areas, edges that shapes share, strokes, what lies over what.
#include "reports/drawings/drawing.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "tests/reports/drawings/colors.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

/// The area of a picture that red shapes cover, in pixels.
double red_area(const test::ColorPicture& picture)
{
    double area = 0;
    for (const auto& pixel : picture.pixels) area += (255 - pixel[1]) / 255.0;
    return area;
}

/// The largest possible error of an area: a line crosses at most 4 |dx| + 4 |dy| + 2 of the cells around
/// samples, and only those may count wrongly, by less than a cell; rounding adds half a grey level to each
/// pixel that is crossed.
double area_error(const std::vector<DrawingPoint>& outline, double scale)
{
    double error = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& [x0, y0] = outline[i];
        const auto& [x1, y1] = outline[(i + 1) % outline.size()];
        const double length = (std::abs(x1 - x0) + std::abs(y1 - y0)) * scale;
        error += (4 * length + 2) / 16 + (length + 2) * 0.5 / 255;
    }
    return error;
}

std::vector<DrawingPoint> regular_polygon(double x, double y, double radius, int sides)
{
    std::vector<DrawingPoint> points;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides + 0.1;
        points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
    }
    return points;
}

/// The largest possible error of the area of a disk, whose outline moves by at most 8 radii along the axes and turns
/// around in four places; Cairo's curves and polygons are within half a sample of round.
double disk_error(double radius, double scale)
{
    const double samples = 4 * 8 * radius * scale;
    return (samples + 8 + samples / 2) / 16 + (samples / 4 + 8) * 0.5 / 255;
}

TEST(DrawingPng, CoversTheAreaOfPolygons)
{
    const std::vector<std::vector<DrawingPoint>> outlines{
        regular_polygon(20, 30, 15.3, 3),
        regular_polygon(20, 30, 15.3, 7),
        regular_polygon(20, 30, 15.3, 96),
        {{2.2, 3.1}, {30.7, 3.1}, {30.7, 9.9}, {9.8, 9.9}, {9.8, 55.5}, {2.2, 55.5}}, // an L
        {{3, 50}, {20, 5}, {37, 50}, {20, 20}},                                       // an arrow head
    };
    for (const int scale : {3, 10}) {
        for (auto outline : outlines) {
            const double expected = test::area_of(outline) * scale * scale;
            const double error = area_error(outline, scale);
            ASSERT_LT(error, expected / 3); // or the test would say little
            EXPECT_NEAR(red_area(test::drawn({40, 60, {{outline, red, {}}}}, 40 * scale)), expected, error);
            std::ranges::reverse(outline);
            EXPECT_NEAR(red_area(test::drawn({40, 60, {{outline, red, {}}}}, 40 * scale)), expected, error);
        }
    }
}

TEST(DrawingPng, IsExactOnTheGrid)
{
    // Two pixels a unit. Pixels from (2, 3) to (6, 8), the last column by half.
    const Drawing drawing{6, 5, {{Polygon{{1, 1.5}, {2.75, 1.5}, {2.75, 4}, {1, 4}}, "#204060", {}}}};
    const auto picture = test::drawn(drawing, 12);
    ASSERT_EQ(picture.width, 12);
    ASSERT_EQ(picture.height, 10);
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 12; ++column) {
            const bool in_rows = row >= 3 && row < 8;
            const std::string expected = in_rows && column >= 2 && column < 5 ? "#204060"
                                         : in_rows && column == 5             ? "#90a0b0" // half white
                                                                              : white;
            EXPECT_EQ(picture.at(column, row), expected) << column << ' ' << row;
        }
    }
}

/// Small dots where tones are kept: their picture, decoded as sRGB, has as much ink as their areas are, whatever part
/// of their pixels is grey. 400 dots are sampled at 16 places a pixel: each area errs as disk_error() says, at random.
TEST(DrawingPng, KeepsTones)
{
    Drawing drawing{100, 100, {}};
    drawing.keeps_tones = true;
    constexpr double radius = 1.3;
    for (int i = 0; i < 400; ++i)
        drawing.shapes.push_back(
            {Disk{{5 * (i % 20) + 2.5 + 0.37 * std::sin(9.1 * i), 5.0 * (i / 20) + 2.5}, radius}, black, {}});
    const auto picture = test::drawn(drawing, 100);
    double ink = 0;
    for (const auto& pixel : picture.pixels) {
        const double v = pixel[0] / 255.0;
        ink += 1 - (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    EXPECT_NEAR(ink / (400 * std::numbers::pi * radius * radius), 1, disk_error(radius, 1) / std::sqrt(400.0));
    // By means of bytes it would be far darker.
    drawing.keeps_tones = false;
    double darker = 0;
    for (const auto& pixel : test::drawn(drawing, 100).pixels) darker += 1 - std::pow(pixel[0] / 255.0, 2.2);
    EXPECT_GT(darker, 1.1 * ink);
}

TEST(DrawingPng, HasNoSeams)
{
    // A fan of triangles that fills a square: no white where they meet, whatever is drawn first.
    std::vector<Shape> fan;
    std::vector<DrawingPoint> border;
    for (int i = 0; i < 40; ++i) {
        const double at = i % 10 * 1.0;
        border.push_back(i < 10   ? DrawingPoint{at, 0}
                         : i < 20 ? DrawingPoint{10, at}
                         : i < 30 ? DrawingPoint{10 - at, 10}
                                  : DrawingPoint{0, 10 - at});
    }
    for (std::size_t i = 0; i < border.size(); ++i)
        fan.push_back({Polygon{{3.7, 6.1}, border[i], border[(i + 1) % border.size()]}, i % 2 ? red : blue, {}});
    const auto picture = test::drawn({10, 10, fan}, 317);
    for (const auto& pixel : picture.pixels) ASSERT_EQ(pixel[1], 0);
    std::ranges::reverse(fan);
    EXPECT_EQ(test::drawn({10, 10, fan}, 317).pixels, picture.pixels);
}

TEST(DrawingPng, FillsWhatIsInsideTwice)
{
    // A pentagram: its middle is inside by the non-zero rule, not by the even-odd one.
    const auto corners = regular_polygon(50, 50, 40, 5);
    const Drawing star{100, 100, {{Polygon{corners[0], corners[2], corners[4], corners[1], corners[3]}, red, {}}}};
    const auto picture = test::drawn(star, 100);
    EXPECT_EQ(picture.at(50, 50), red);
    EXPECT_EQ(picture.at(50 + 32, 50 + 3), red); // towards the first point
    EXPECT_EQ(picture.at(50 - 32, 50 - 3), white);
}

TEST(DrawingPng, DrawsLaterOverEarlier)
{
    const std::vector<DrawingPoint> left{{0, 0}, {6, 0}, {6, 4}, {0, 4}}, right{{4, 0}, {9, 0}, {9, 4}, {4, 4}};
    const auto one = test::drawn({10, 4, {{left, red, {}}, {right, blue, {}}}}, 10);
    EXPECT_EQ(one.at(3, 2), red);
    EXPECT_EQ(one.at(5, 2), blue);
    const auto other = test::drawn({10, 4, {{right, blue, {}}, {left, red, {}}}}, 10);
    EXPECT_EQ(other.at(5, 2), red);
    EXPECT_EQ(other.at(7, 2), blue);
    EXPECT_EQ(other.at(9, 2), white);
}

TEST(DrawingPng, CentresStrokesOnOutlines)
{
    // Stroke 2 wide around (5, 5) to (15, 15), over its own fill.
    const Drawing square{20, 20, {{Polygon{{5, 5}, {15, 5}, {15, 15}, {5, 15}}, blue, red, 2}}};
    const auto picture = test::drawn(square, 20);
    for (int i = 0; i < 20; ++i) {
        const bool outside = i < 4 || i >= 16, inside = i >= 6 && i < 14;
        EXPECT_EQ(picture.at(i, 10), outside ? white : inside ? blue : red) << i;
        EXPECT_EQ(picture.at(10, i), outside ? white : inside ? blue : red) << i;
    }

    // The area of a frame with round corners, and that of a slanted line with such ends.
    const int scale = 20;
    const auto error_of_corners = [](int corners, double width) { return corners * disk_error(width / 2, scale); };
    const Drawing frame{20, 20, {{Polygon{{5, 5}, {15, 5}, {15, 15}, {5, 15}}, {}, red, 2}}};
    const double disk = std::numbers::pi; // of radius 1
    EXPECT_NEAR(red_area(test::drawn(frame, 20 * scale)), (144 - 64 - 4 + disk) * scale * scale,
                area_error({{4, 4}, {16, 4}, {16, 16}, {4, 16}}, scale) +
                    area_error({{6, 6}, {14, 6}, {14, 14}, {6, 14}}, scale) + error_of_corners(4, 2));
    const double width = 1.5, length = std::hypot(13, 10);
    const double dx = -10 / length * width / 2, dy = 13 / length * width / 2;
    EXPECT_NEAR(red_area(test::drawn({20, 20, {{Line{{{3, 3}, {16, 13}}}, {}, red, width}}}, 20 * scale)),
                (width * length + width * width / 4 * disk) * scale * scale,
                area_error({{3 + dx, 3 + dy}, {16 + dx, 13 + dy}, {16 - dx, 13 - dy}, {3 - dx, 3 - dy}}, scale) +
                    error_of_corners(2, width));
}

TEST(DrawingPng, CoversTheAreaOfDisks)
{
    for (const double radius : {0.8, 5.0, 17.3}) {
        const auto area = red_area(test::drawn({40, 40, {{Disk{{20.3, 19.8}, radius}, red, {}}}}, 400));
        EXPECT_NEAR(area, std::numbers::pi * radius * radius * 100, disk_error(radius, 10));
        const auto ring = red_area(test::drawn({40, 40, {{Disk{{20.3, 19.8}, radius}, {}, red, 1}}}, 400));
        EXPECT_NEAR(ring, 2 * std::numbers::pi * radius * 100,
                    disk_error(radius - 0.5, 10) + disk_error(radius + 0.5, 10));
    }
}

TEST(DrawingPng, DrawsWords)
{
    const auto drawing = [](const std::string& words, bool is_centred) {
        return test::drawn({60, 20, {{Text{{30, 15}, 12, words, is_centred}, red, {}}}}, 600);
    };
    const auto columns = [&](const std::string& words, bool is_centred) {
        const auto picture = drawing(words, is_centred);
        std::array<int, 2> ends{picture.width, -1};
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column)
                if (picture.at(column, row) != white) ends = {std::min(ends[0], column), std::max(ends[1], column)};
        return ends;
    };
    const auto [left, right] = columns("oo", true);
    EXPECT_NEAR(left + right, 600, 4) << "around the middle";
    EXPECT_NEAR(right - left, 120 * 2 * 0.6, 20) << "letters of DejaVu Sans are 0.6 wide";
    EXPECT_GE(columns("oo", false)[0], 300);
    EXPECT_EQ(drawing("x", false).at(350, 149 - 80), white) << "a small letter is half as high";
    EXPECT_GT(red_area(drawing("(b)", true)), red_area(drawing("(c)", true)));
    EXPECT_EQ(red_area(drawing("", true)), 0);
}

TEST(DrawingPng, ShowsImagesAsTheyAre)
{
    const PngPixels grey{3, 2, 1, {0, 50, 100, 150, 200, 250}};
    const auto same = test::drawn({4, 3, {{Image{{1, 0}, 3, grey}, {}, {}}}}, 4);
    EXPECT_EQ(same.at(0, 0), white);
    EXPECT_EQ(same.at(2, 0), "#323232");
    EXPECT_EQ(same.at(3, 1), "#fafafa");
    EXPECT_EQ(same.at(1, 2), white);
    const auto larger = test::drawn({3, 2, {{Image{{0, 0}, 3, grey}, {}, {}}}}, 30);
    for (int column = 0; column < 30; ++column) EXPECT_EQ(larger.at(column, 15), larger.at(column / 10 * 10, 10));

    // Smaller pictures are means, whatever the number of pixels that become one.
    for (const int block : {2, 4, 8, 20}) {
        PngPixels stripes{40 * block, 40 * block, 3, {}};
        for (int row = 0; row < stripes.height; ++row)
            for (int column = 0; column < stripes.width; ++column)
                for (int channel = 0; channel < 3; ++channel)
                    stripes.values.push_back(static_cast<std::uint8_t>(column % 2 ? 200 : 40 * channel));
        const double side = stripes.width;
        const auto small = test::drawn({side, side, {{Image{{0, 0}, side, stripes}, {}, {}}}}, 40);
        for (const auto& pixel : small.pixels)
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(pixel[channel], 100 + 20.0 * static_cast<double>(channel), 1.5) << block;
    }
}

TEST(DrawingPng, ShowsImagesSmallerWithoutMovingThem)
{
    // A slope of one level a pixel, whatever the number of pixels that become one.
    for (const int block : {2, 3, 5, 6, 7, 11}) {
        PngPixels slope{20 * block, 10 * block, 1, {}};
        for (int row = 0; row < slope.height; ++row)
            for (int column = 0; column < slope.width; ++column)
                slope.values.push_back(static_cast<std::uint8_t>(column));
        const double width = slope.width, height = slope.height;
        const auto small = test::drawn({width, height, {{Image{{0, 0}, width, slope}, {}, {}}}}, 20);
        for (int column = 1; column < 19; ++column)
            for (int row = 0; row < 10; ++row)
                EXPECT_NEAR(small.pixels[static_cast<std::size_t>(row * 20 + column)][0],
                            block * column + (block - 1) / 2.0, 1)
                    << block;
    }
}

TEST(DrawingPng, IsGreyWhereItsColorsAre)
{
    const TemporaryFolder folder;
    const auto channels = [&](const std::vector<Shape>& shapes) {
        write_drawing_png(folder.path() / "a.png", {4, 4, shapes}, 4);
        return read_png(folder.path() / "a.png").channels;
    };
    EXPECT_EQ(channels({}), 1);
    EXPECT_EQ(channels({{Disk{{2, 2}, 1}, "#808080", "#000000", 1}, {Image{{}, 1, {1, 1, 1, {7}}}, {}, {}}}), 1);
    EXPECT_EQ(channels({{Disk{{2, 2}, 1}, "#808080", "#000001", 1}}), 3);
    EXPECT_EQ(channels({{Image{{}, 1, {1, 1, 3, {7, 7, 7}}}, {}, {}}}), 3);
}

TEST(DrawingPng, HasNoSeamsWhereSurfacesOfCairoMeet)
{
    // Wider than 32,767 samples: drawn in parts.
    const Drawing drawing{
        20'000,
        8,
        {{Polygon{{0, 0}, {20'000, 0}, {20'000, 8}, {0, 8}}, red, {}}, {Line{{{0, 0}, {20'000, 8}}}, {}, blue, 1}}};
    const auto picture = test::drawn(drawing, 20'000);
    for (int column = 0; column < picture.width; ++column) {
        const int row = std::min(7, static_cast<int>((column + 0.5) * 8 / 20'000));
        EXPECT_NE(picture.at(column, row), red) << column;
        for (const auto& pixel : {picture.pixels[static_cast<std::size_t>(column)]}) EXPECT_EQ(pixel[1], 0);
    }
}

TEST(DrawingPng, CutsOffWhatIsOutside)
{
    const Drawing drawing{4, 40, {{Polygon{{-1e6, -50}, {2, -50}, {2, 90}, {-1e6, 90}}, red, {}}}};
    const auto picture = test::drawn(drawing, 4);
    ASSERT_EQ(picture.height, 40);
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 4; ++column) EXPECT_EQ(picture.at(column, row), column < 2 ? red : white);
}

TEST(DrawingPng, HasSquarePixels)
{
    EXPECT_EQ(test::drawn({3, 2, {}}, 300).height, 200);
    EXPECT_EQ(test::drawn({0.3, 0.1, {}}, 300).height, 100); // not 101: 0.1 * 300 / 0.3 > 100
    EXPECT_EQ(test::drawn({3, 2.001, {}}, 300).height, 201);
    EXPECT_EQ(test::drawn({1000, 1, {}}, 10).height, 1);
}

TEST(DrawingPng, IsTheSameTwice)
{
    const TemporaryFolder folder;
    const Drawing drawing{40, 60, {{regular_polygon(20, 30, 15.3, 7), red, blue, 1.5}}};
    write_drawing_png(folder.path() / "a.png", drawing, 123);
    write_drawing_png(folder.path() / "b.png", drawing, 123);
    EXPECT_EQ(read_whole_file(folder.path() / "a.png"), read_whole_file(folder.path() / "b.png"));
    EXPECT_EQ(folder.names().size(), 2u);
}

TEST(DrawingPng, RefusesWhatItCannotDraw)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.png";
    const std::vector<DrawingPoint> outline{{0, 0}, {1, 0}, {0, 1}};
    EXPECT_THROW(write_drawing_png(path, {1, 1, {}}, 0), InputError);
    EXPECT_THROW(write_drawing_png(path, {1, 1, {}}, -5), InputError);
    EXPECT_THROW(write_drawing_png(path, {1, 1, {}}, max_drawing_pixels + 1), InputError);
    EXPECT_THROW(write_drawing_png(path, {1, 100, {}}, 1000), InputError);
    EXPECT_THROW(write_drawing_png(folder.path() / "missing" / "a.png", {1, 1, {}}, 10), StorageError);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [width, height] : {std::pair{0.0, 1.0}, {1.0, -1.0}, {nan, 1.0}, {1.0, 1e300}})
        EXPECT_THROW(write_drawing_png(path, {width, height, {}}, 10), std::logic_error);
    for (const std::string color : {"red", "#ff000", "#FF0000", "#ff00000", "#ff 000", "ff0000#"}) {
        EXPECT_THROW(write_drawing_png(path, {1, 1, {{outline, color, {}}}}, 10), std::logic_error) << color;
        EXPECT_THROW(write_drawing_png(path, {1, 1, {{outline, {}, color, 1}}}, 10), std::logic_error);
    }
    EXPECT_THROW(write_drawing_png(path, {1, 1, {{Polygon{{0, nan}}, red, {}}}}, 10), std::logic_error);
    EXPECT_THROW(write_drawing_png(path, {1, 1, {{outline, red, red, -1}}}, 10), std::logic_error);
    EXPECT_THROW(write_drawing_png(path, {1, 1, {{Disk{{0, 0}, -1}, red, {}}}}, 10), std::logic_error);
    EXPECT_THROW(write_drawing_png(path, {1, 1, {{Text{{0, nan}, 1, "x"}, red, {}}}}, 10), std::logic_error);
    EXPECT_TRUE(folder.names().empty());
}

TEST(DrawingColors, AreMixedByChannel)
{
    EXPECT_EQ(mixed_color("#204060", "#ffffff", 0), "#204060");
    EXPECT_EQ(mixed_color("#204060", "#ffffff", 1), "#ffffff");
    EXPECT_EQ(mixed_color("#204060", "#60400a", 0.25), "#30404b"); // 96 - 86 / 4 = 74.5
}

}
}
