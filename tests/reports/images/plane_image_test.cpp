// The picture of a 3D spectrum: where the planes lie, and that they are named.
#include "reports/images/plane_image.hpp"

#include <gtest/gtest.h>

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

/// Whether the pixel of a frequency is white, in the cell at a column and row of the picture.
bool is_white(GreyImage image, int cell_column, int cell_row, int fx, int fy)
{
    const int left = cell_column * (size + gap);
    const int top = cell_row * (strip + size) + strip;
    return image.at(left + size / 2 + fx, top + size / 2 - 1 - fy) == 255;
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
    auto image = draw_spectrum_planes(planes_with_spike(0, 0, 1), report_tone_mapping);
    const auto name = [&](int left, int top) {
        std::string pixels;
        for (int y = top; y < top + 5; ++y) {
            for (int x = left; x < left + 11; ++x) pixels += image.at(x, y) == 0 ? '#' : ' ';
            pixels += '\n';
        }
        return pixels;
    };
    EXPECT_EQ(name(1, 3), "#   # #####\n"
                          " # #     # \n"
                          "  #     #  \n"
                          " # #   #   \n"
                          "#   # #####\n");
    EXPECT_EQ(name(1, strip + size + 3), "#   # #   #\n"
                                         " # #  #   #\n"
                                         "  #    ####\n"
                                         " # #      #\n"
                                         "#   #  ### \n");
}

TEST(PlaneImage, PutsPlanesSideBySide)
{
    auto planes = planes_with_spike(2, -4, 2);
    auto image = draw_plane_row(planes, {"xy", "xy", "xz"}, report_tone_mapping);
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
