// The cube with one eighth cut away: which plane is where, and which way round.
#include "reports/images/cube_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr int cube_size = 64;

std::vector<Spectrum> grey_planes()
{
    return {6, Spectrum{2, cube_size, 1, 1, std::vector<double>(cube_size * cube_size, 1.0)}};
}

/// Makes a square of 9 x 9 frequencies around one white.
void add_spot(Spectrum& plane, int fx, int fy)
{
    for (int y = fy - 4; y <= fy + 4; ++y)
        for (int x = fx - 4; x <= fx + 4; ++x)
            plane.power[static_cast<std::size_t>((y + cube_size / 2) * cube_size + x + cube_size / 2)] = 10;
}

/// The grey where a place of the cube [-1, 1]^3 is seen from (1, 1, 1): x to the lower left, y to the lower
/// right.
int grey_at(GreyImage image, double x, double y, double z)
{
    const double pixels = cube_size / 2.0;
    const double right = (y - x) / std::sqrt(2.0), up = (2 * z - x - y) / std::sqrt(6.0);
    return image.at(static_cast<int>(std::lround(image.width / 2.0 + right * pixels)),
                    static_cast<int>(std::lround(image.height / 2.0 - up * pixels)));
}

constexpr double half = 0.5;
constexpr int quarter = cube_size / 4; // 0.5 of the way to the border

TEST(CubeImage, ShowsCoordinatePlanesWhereTheEighthIsMissing)
{
    const double places[3][3] = {{half, half, 0}, {half, 0, half}, {0, half, half}};
    for (std::size_t i = 0; i < 3; ++i) {
        auto planes = grey_planes();
        const int plain =
            grey_at(draw_spectrum_cube(planes, report_tone_mapping), places[i][0], places[i][1], places[i][2]);
        EXPECT_GT(plain, 100);
        EXPECT_LT(plain, 255);
        add_spot(planes[i], quarter, quarter);
        const auto image = draw_spectrum_cube(planes, report_tone_mapping);
        EXPECT_EQ(grey_at(image, places[i][0], places[i][1], places[i][2]), 255) << i;
    }
}

TEST(CubeImage, ShowsOuterFacesMirrored)
{
    // Plane 3 is z = -M/2: power there at (f, g) is that at z = M/2 and (-f, -g).
    const double places[3][3] = {{half, -half, 1}, {half, 1, -half}, {1, half, -half}};
    for (std::size_t i = 0; i < 3; ++i) {
        auto planes = grey_planes();
        add_spot(planes[3 + i], -quarter, quarter);
        EXPECT_EQ(grey_at(draw_spectrum_cube(planes, report_tone_mapping), places[i][0], places[i][1], places[i][2]),
                  255)
            << i;
    }
}

TEST(CubeImage, IsAHexagonOnWhite)
{
    auto image = draw_spectrum_cube(grey_planes(), report_tone_mapping);
    EXPECT_EQ(image.width, std::ceil(std::sqrt(2.0) * cube_size) + 2);
    EXPECT_EQ(image.height, std::ceil(2 * std::sqrt(2.0 / 3) * cube_size) + 2);
    EXPECT_EQ(image.at(0, 0), 255);
    EXPECT_EQ(image.at(image.width - 1, image.height - 1), 255);
    const auto filled = image.pixels.size() - static_cast<std::size_t>(std::ranges::count(image.pixels, 255));
    EXPECT_NEAR(static_cast<double>(filled), std::sqrt(3.0) * cube_size * cube_size, 6 * cube_size)
        << "the projection of a cube of side M has area sqrt 3 M^2, a border of one pixel apart";
}

TEST(CubeImage, HasNoDC)
{
    auto planes = grey_planes();
    for (std::size_t i = 0; i < 3; ++i) planes[i].power[cube_size / 2 * cube_size + cube_size / 2] = 1e9;
    auto image = draw_spectrum_cube(planes, report_tone_mapping);
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) EXPECT_LT(image.at(image.width / 2 + x, image.height / 2 + y), 255);
}

}
}
