// Drawings as SVG: short, and the same picture as the PNG.
#include "reports/drawings/drawing.hpp"

#include "reports/drawings/cube_tile_image.hpp"
#include "reports/drawings/tile_image.hpp"
#include "tests/reports/drawings/colors.hpp"
#include "tests/reports/support/drawn.hpp"
#include "tests/reports/support/tile_grids.hpp"
#include "tests/support/browser.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>

namespace poissonlab {
namespace {

const Polygon square{{1, 1}, {3, 1}, {3, 3}, {1, 3}};
const Polygon backwards{{5, 1}, {5, 3}, {7, 3}, {7, 1}};
const Polygon slanted{{0, -0.25}, {1.005, 2.999}, {-10.5, 0.1}};

std::size_t count(const std::string& text, const std::string& word)
{
    std::size_t n = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
    return n;
}

TEST(DrawingSvg, IsShort)
{
    // The second square runs the same way round as the first: the path covers both by any rule.
    EXPECT_EQ(drawing_svg({8, 4.5, {{square, red, {}}, {backwards, red, {}}, {slanted, {}, blue, 0.5}}}),
              "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 8 4.5\" stroke-linejoin=\"round\" "
              "stroke-linecap=\"round\">\n"
              "<rect width=\"8\" height=\"4.5\" fill=\"#ffffff\"/>\n"
              "<path fill=\"#ff0000\" stroke=\"#ff0000\" stroke-width=\"1\" "
              "vector-effect=\"non-scaling-stroke\" d=\"M1 1h2v2h-2zM5 1h2v2h-2z\"/>\n"
              "<path fill=\"none\" stroke=\"#0000ff\" stroke-width=\".5\" "
              "d=\"M0-.25l1 3.25l-11.5-2.9z\"/>\n"
              "</svg>\n");
}

TEST(DrawingSvg, JoinsOnlyWhatLooksTheSame)
{
    const auto paths = [](std::vector<Shape> shapes) { return count(drawing_svg({8, 4, std::move(shapes)}), "<path"); };
    EXPECT_EQ(paths({}), 0u);
    EXPECT_EQ(paths({{square, {}, {}}}), 0u);
    EXPECT_EQ(paths({{square, red, {}}, {backwards, red, {}}}), 1u);
    EXPECT_EQ(paths({{square, {}, red, 1}, {backwards, {}, red, 1}}), 1u);
    EXPECT_EQ(paths({{square, {}, red, 1}, {backwards, {}, red, 2}}), 2u);
    EXPECT_EQ(paths({{square, red, {}}, {backwards, blue, {}}}), 2u);
    EXPECT_EQ(paths({{square, red, {}}, {backwards, {}, red, 1}}), 2u);
    EXPECT_EQ(paths({{square, red, {}}, {square, blue, {}}, {square, red, {}}}), 3u);
    EXPECT_EQ(paths({{square, red, blue, 1}, {backwards, red, blue, 1}}),
              2u); // the second may hide the first
}

TEST(DrawingSvg, HasDotsDisksLinesAndWords)
{
    const auto body = [](std::vector<Shape> shapes) {
        const std::string svg = drawing_svg({8, 4, std::move(shapes)});
        const auto start = svg.find("/>\n") + 3;
        return svg.substr(start, svg.find("</svg>") - start);
    };
    EXPECT_EQ(body({{Disk{{1, 2}, 0.5}, red, {}}, {Disk{{3, 2.25}, 0.5}, red, {}}}),
              "<path fill=\"none\" stroke=\"#ff0000\" stroke-width=\"1\" d=\"M1 2h0M3 2.25h0\"/>\n");
    EXPECT_EQ(body({{Disk{{1, 2}, 0.5}, red, blue, 0.25}}),
              "<path fill=\"#ff0000\" stroke=\"#0000ff\" stroke-width=\".25\" "
              "d=\"M.5 2a.5 .5 0 1 0 1 0a.5 .5 0 1 0-1 0z\"/>\n");
    EXPECT_EQ(body({{Line{{{1, 2}, {3, 4}, {3, 5}}}, {}, red, 1}, {Line{{{0, 0}, {1, 0}}}, {}, red, 1}}),
              "<path fill=\"none\" stroke=\"#ff0000\" stroke-width=\"1\" d=\"M1 2l2 2v1M0 0h1\"/>\n");
    EXPECT_EQ(body({{Text{{4, 2}, 12, "(a)", true}, red, {}}}),
              "<text x=\"4\" y=\"2\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"12\" text-anchor=\"middle\" "
              "fill=\"#ff0000\">(a)</text>\n");
}

TEST(DrawingSvg, RefusesWhatItCannotDraw)
{
    EXPECT_THROW(drawing_svg({8, 4, {{Text{{0, 0}, 1, "</text><script>"}, red, {}}}}), std::logic_error);
    EXPECT_THROW(drawing_svg({8, 4, {{Image{{0, 0}, 1, {1, 1, 1, {0}}}, {}, {}}}}), std::logic_error);
    EXPECT_THROW(drawing_svg({8, 4, {{square, "\"/><script>", {}}}}), std::logic_error);
    EXPECT_THROW(drawing_svg({8, 4, {{Polygon{{0, std::numeric_limits<double>::infinity()}}, red, {}}}}),
                 std::logic_error);
    EXPECT_THROW(drawing_svg({0, 4, {}}), std::logic_error);
}

/// The light that may come through from below where two shapes meet, in grey levels. A border at distance t from the
/// middle of a pixel leaves (1/2 - t) of it to one fill and (1/2 + t) to the other, of which strokes one
/// pixel wide leave t: the product is t^2 (1/4 - t^2) <= 1/64 or 4 levels. Four blends round by at most one
/// each.
constexpr int seam = 8;

/// The page shows a drawing 900 pixels wide at its upper left.
test::ColorPicture in_browser(const Drawing& drawing)
{
    const TemporaryFolder folder;
    folder.write("a.svg", drawing_svg(drawing));
    const auto page = folder.write("a.html", "<!doctype html><body style=\"margin: 0\">"
                                             "<img src=\"a.svg\" width=\"900\" style=\"display: block\">");
    static test::Browser browser; // of all tests: starting one takes longer than a picture
    browser.resize(1280, 1200);
    browser.open(page);
    return test::decode_color_png(browser.screenshot());
}

const auto& pixel(const test::ColorPicture& picture, int column, int row)
{
    return picture.pixels[static_cast<std::size_t>(row * picture.width + column)];
}

bool is_even(const test::ColorPicture& picture, int column, int row)
{
    for (int y = row - 2; y <= row + 2; ++y)
        for (int x = column - 2; x <= column + 2; ++x)
            if (pixel(picture, x, y) != pixel(picture, column, row)) return false;
    return true;
}

bool is_near(const std::array<std::uint8_t, 3>& a, const std::array<std::uint8_t, 3>& b)
{
    return std::abs(a[0] - b[0]) <= seam && std::abs(a[1] - b[1]) <= seam && std::abs(a[2] - b[2]) <= seam;
}

/// Wherever the PNG has the same colour for two pixels around, the browser has that colour, but for seams of
/// shapes in this colour, and the drawing shows at least so many colours there.
void expect_same_picture(const Drawing& drawing, std::size_t colors)
{
    const auto png = test::drawn(drawing, 900);
    const auto browser = in_browser(drawing);
    ASSERT_LE(png.height, browser.height);
    std::set<std::string> compared;
    std::map<std::string, int> different;
    for (int row = 2; row < png.height - 2; ++row)
        for (int column = 2; column < png.width - 2; ++column) {
            if (!is_even(png, column, row)) continue;
            compared.insert(png.at(column, row));
            if (!is_near(pixel(png, column, row), pixel(browser, column, row)))
                ++different[png.at(column, row) + " is " + browser.at(column, row)];
        }
    EXPECT_THAT(different, testing::IsEmpty());
    EXPECT_GE(compared.size(), colors);
}

TEST(DrawingSvg, LooksLikeThePngInABrowser)
{
    const Tiling tiling(DirectAlgorithm::corner, {3, 3}, HashKind::xxh64, 1);
    expect_same_picture(draw_tile_regions(tiling_grid(tiling, {0, 0, 5, 5}), 0.12), 7); // 3, 3 pale, white
    const CubeTiling cubes(2, HashKind::xxh64, 1);
    expect_same_picture(draw_cube_regions(cube_tiling_grid(cubes, {0, 0, 0, 3, 3, 3}), 0.09), 15);
    expect_same_picture(draw_cubes(cube_tiling_grid(cubes, {0, 0, 0, 3, 3, 3})), 5); // 2, and 3 faces
}

TEST(DrawingSvg, HasDisksLinesAndWordsInABrowser)
{
    // Lines and words are too thin to compare: only their colour is there.
    const Drawing drawing{100,
                          60,
                          {{Disk{{20, 20}, 12}, red, {}},
                           {Disk{{60, 20}, 12}, red, blue, 5},
                           {Line{{{5, 50}, {40, 45}}}, {}, blue, 6},
                           {Text{{70, 55}, 40, "oo", true}, "#008000", {}}}};
    expect_same_picture(drawing, 4);
}

TEST(DrawingSvg, HasNoSeamsInABrowser)
{
    // Red and blue bands at an angle, side by side: no white comes through where they meet.
    std::vector<Shape> bands;
    for (int i = -40; i < 40; ++i) {
        const double x = i * 2.7;
        bands.push_back({Polygon{{x, 0}, {x + 2.7, 0}, {x + 40.7, 100}, {x + 38, 100}}, i % 2 ? red : blue, {}});
    }
    const auto picture = in_browser({100, 100, bands});
    int red_pixels = 0, blue_pixels = 0;
    for (int row = 5; row < 895; ++row)
        for (int column = 5; column < 895; ++column) {
            const auto& [r, g, b] = pixel(picture, column, row);
            ASSERT_LE(g, seam) << column << ' ' << row; // without strokes 64
            red_pixels += r == 255;
            blue_pixels += b == 255;
        }
    EXPECT_GT(red_pixels, 100'000);
    EXPECT_GT(blue_pixels, 100'000);
}

}
}
