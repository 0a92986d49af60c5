// The picture of a 3D spectrum: where the planes lie, and that they are named.
#include "reports/drawings/points_image.hpp"

#include "tests/reports/support/drawn.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

namespace poissonlab {
namespace {

constexpr int size = 16;
constexpr int strip = 10;
constexpr int gap = 2;

/// White noise with power 10 at one frequency of one plane.
std::vector<Spectrum> planes_with_spike(std::size_t plane, int fx, int fy)
{
    std::vector<Spectrum> planes(3, Spectrum{2, size, 1, 1, std::vector<double>(size * size, 1.0)});
    planes[plane].power[static_cast<std::size_t>((fy + size / 2) * size + fx + size / 2)] = 10;
    return planes;
}

/// True if the pixel of a frequency is white, in the cell at a column and row of the picture.
bool is_white(const Drawing& drawing, int cell_column, int cell_row, int fx, int fy)
{
    const int left = cell_column * (size + gap);
    const int top = cell_row * (strip + size) + strip;
    const auto picture = test::drawn(drawing, static_cast<int>(drawing.width));
    return picture.at(left + size / 2 + fx, top + size / 2 - 1 - fy) == "#ffffff";
}

TEST(PlaneImage, UnfoldsACube)
{
    const auto picture = [](std::size_t plane) {
        return draw_spectrum_planes(planes_with_spike(plane, 3, 5), report_tone_mapping);
    };
    EXPECT_EQ(picture(0).width, 2 * size + gap);
    EXPECT_EQ(picture(0).height, 2 * (size + strip));
    EXPECT_TRUE(is_white(picture(0), 0, 1, 3, 5)) << "xy below";
    EXPECT_TRUE(is_white(picture(1), 0, 0, 3, 5)) << "xz above it: x to the right, z upwards";
    EXPECT_TRUE(is_white(picture(2), 1, 0, 3, 5)) << "yz beside that: z upwards";
    EXPECT_FALSE(is_white(picture(2), 0, 0, 3, 5));
}

TEST(PlaneImage, NamesThePlanes)
{
    const Drawing drawing = draw_spectrum_planes(planes_with_spike(0, 0, 1), report_tone_mapping);
    std::map<DrawingPoint, std::string> names;
    for (const Shape& shape : drawing.shapes)
        if (const auto* text = std::get_if<Text>(&shape.form)) names[text->start] = text->words;
    const std::map<DrawingPoint, std::string> expected{
        {{1, 7}, "xz"}, {{1, strip + size + 7}, "xy"}, {{size + gap + 1, 7}, "yz"}};
    EXPECT_EQ(names, expected);

    // In the strips above the planes there are dark pixels, and nowhere beyond them.
    const auto picture = test::drawn(drawing, static_cast<int>(drawing.width));
    const auto dark = [&](int left, int top, int high) {
        int count = 0;
        for (int row = top; row < top + high; ++row)
            for (int column = left; column < left + size; ++column) count += picture.at(column, row) < "#808080";
        return count;
    };
    EXPECT_GT(dark(0, 0, strip), 10);
    EXPECT_GT(dark(size + gap, 0, strip), 10);
    EXPECT_GT(dark(0, strip + size, strip), 10);
    EXPECT_EQ(dark(size + gap, strip + size, strip + size), 0);
}

TEST(PlaneImage, PutsPlanesSideBySide)
{
    auto planes = planes_with_spike(2, -4, 2);
    const Drawing image = draw_plane_row(planes, {"xy", "xy", "xz"}, report_tone_mapping);
    EXPECT_EQ(image.width, 3 * size + 2 * gap);
    EXPECT_EQ(image.height, strip + size);
    EXPECT_TRUE(is_white(image, 2, 0, -4, 2));
    EXPECT_FALSE(is_white(image, 1, 0, -4, 2));
}

TEST(PlaneImage, ACloseUpIsTheMiddle)
{
    const auto planes = planes_with_spike(0, -5, 4);
    const Spectrum middle = spectrum_close_up(planes[0]);
    EXPECT_EQ(middle.size, 10) << "five eighths of 16";
    EXPECT_EQ(middle.at(-5, 4), 10);
    EXPECT_EQ(std::accumulate(middle.power.begin(), middle.power.end(), 0.0), 99 + 10);
}

}
}
