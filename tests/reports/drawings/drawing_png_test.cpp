// The pixels of drawings: areas, edges that shapes share, strokes, what lies over what.
#include "reports/drawings/drawing.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

/// How much of a picture red shapes cover, in pixels.
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

const std::string red = "#ff0000", blue = "#0000ff", white = "#ffffff";

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
    const Drawing drawing{6, 5, {{{{1, 1.5}, {2.75, 1.5}, {2.75, 4}, {1, 4}}, "#204060", {}}}};
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
        fan.push_back({{{3.7, 6.1}, border[i], border[(i + 1) % border.size()]}, i % 2 ? red : blue, {}});
    const auto picture = test::drawn({10, 10, fan}, 317);
    for (const auto& pixel : picture.pixels) ASSERT_EQ(pixel[1], 0);
    std::ranges::reverse(fan);
    EXPECT_EQ(test::drawn({10, 10, fan}, 317).pixels, picture.pixels);
}

TEST(DrawingPng, FillsWhatIsInsideTwice)
{
    // A pentagram: its middle is inside by the non-zero rule, not by the even-odd one.
    const auto corners = regular_polygon(50, 50, 40, 5);
    const Drawing star{100, 100, {{{corners[0], corners[2], corners[4], corners[1], corners[3]}, red, {}}}};
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
    const Drawing square{20, 20, {{{{5, 5}, {15, 5}, {15, 15}, {5, 15}}, blue, red, 2}}};
    const auto picture = test::drawn(square, 20);
    for (int i = 0; i < 20; ++i) {
        const bool outside = i < 4 || i >= 16, inside = i >= 6 && i < 14;
        EXPECT_EQ(picture.at(i, 10), outside ? white : inside ? blue : red) << i;
        EXPECT_EQ(picture.at(10, i), outside ? white : inside ? blue : red) << i;
    }

    // The area of a frame with round corners, which are 16-gons, and that of a slanted line with such ends.
    const int scale = 20;
    const auto error_of_corners = [](int corners, double width) {
        return corners * area_error(regular_polygon(0, 0, width / 2, 16), scale);
    };
    const Drawing frame{20, 20, {{{{5, 5}, {15, 5}, {15, 15}, {5, 15}}, {}, red, 2}}};
    const double disk = 8 * std::sin(std::numbers::pi / 8); // of radius 1
    EXPECT_NEAR(red_area(test::drawn(frame, 20 * scale)), (144 - 64 - 4 + disk) * scale * scale,
                area_error({{4, 4}, {16, 4}, {16, 16}, {4, 16}}, scale) +
                    area_error({{6, 6}, {14, 6}, {14, 14}, {6, 14}}, scale) + error_of_corners(4, 2));
    const double width = 1.5, length = std::hypot(13, 10);
    const double dx = -10 / length * width / 2, dy = 13 / length * width / 2;
    EXPECT_NEAR(red_area(test::drawn({20, 20, {{{{3, 3}, {16, 13}}, {}, red, width}}}, 20 * scale)),
                (width * length + width * width / 4 * disk) * scale * scale,
                area_error({{3 + dx, 3 + dy}, {16 + dx, 13 + dy}, {16 - dx, 13 - dy}, {3 - dx, 3 - dy}}, scale) +
                    error_of_corners(2, width));
}

TEST(DrawingPng, CutsOffWhatIsOutside)
{
    const Drawing drawing{4, 40, {{{{-1e6, -50}, {2, -50}, {2, 90}, {-1e6, 90}}, red, {}}}};
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
    EXPECT_THROW(write_drawing_png(path, {1, 1, {{{{0, nan}}, red, {}}}}, 10), std::logic_error);
    EXPECT_THROW(write_drawing_png(path, {1, 1, {{outline, red, red, -1}}}, 10), std::logic_error);
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
