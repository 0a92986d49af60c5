// Regions of pictures and formulas, and points of files as obstacles.
#include "base/regions/region_raster.hpp"

#include "base/images/png_file.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class DrawnRegions : public testing::Test
{
protected:
    /// A picture of one channel, rows from the top.
    std::string picture(const std::string& name, int width, const std::vector<std::uint8_t>& pixels) const
    {
        const std::string file = (folder_.path() / name).string();
        write_png(file, {.width = width, .height = static_cast<int>(pixels.size()) / width, .channels = 1},
                  [&](int first, int) { return &pixels[static_cast<std::size_t>(first * width)]; });
        return file;
    }

    TemporaryFolder folder_;
};

TEST_F(DrawnRegions, ArePixelsBrighterThanHalf)
{
    const PlaneRegion region = read_region(picture("a.png", 3, {255, 127, 0, 128, 255, 0}));
    EXPECT_EQ(area_of(region), 3);
    ASSERT_EQ(region.polygons.size(), 1U);
    EXPECT_THAT(region.polygons[0].outline,
                testing::UnorderedElementsAre(std::array{0.0, 0.0}, std::array{2.0, 0.0}, std::array{2.0, 1.0},
                                              std::array{1.0, 1.0}, std::array{1.0, 2.0}, std::array{0.0, 2.0}));
    EXPECT_THAT(message_of([&] {
                    read_region(picture("b.png", 1, {0, 100}));
                }),
                HasSubstr("b.png: no pixel is brighter than half: nothing is inside"));
}

/// An island that touches the hole around it with all of its corners.
TEST_F(DrawnRegions, MayTouchInAllCorners)
{
    const std::uint8_t o = 0, x = 255;
    const PlaneRegion region = read_region(picture("island.png", 5, {x, x, x, x, x, //
                                                                     x, x, o, x, x, //
                                                                     x, o, x, o, x, //
                                                                     x, x, o, x, x, //
                                                                     x, x, x, x, x}));
    EXPECT_EQ(area_of(region), 21);
    EXPECT_EQ(region.polygons.size(), 2U);
}

/// Random pixels touch in corners, have holes with islands, and rings that come to a corner twice: each pixel's middle
/// is inside where the pixel is bright, and the region is valid.
TEST_F(DrawnRegions, AreThePixelsOfAnyPicture)
{
    std::mt19937 random(5);
    for (int round = 0; round < 6; ++round) {
        constexpr int size = 24;
        std::vector<std::uint8_t> pixels(size * size);
        for (auto& pixel : pixels) pixel = random() % 10 < static_cast<unsigned>(3 + round % 4) ? 255 : 0;
        pixels[0] = pixels[size * size - 1] = 255; // the region's box is that of the picture
        const PlaneRegion plane = read_region(picture("random" + std::to_string(round) + ".png", size, pixels));
        const FixedRegion region(plane);
        int bright = 0;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const bool is_bright = pixels[static_cast<std::size_t>((size - 1 - row) * size + column)] == 255;
                bright += is_bright;
                EXPECT_EQ(region.contains_place({column + 0.5, row + 0.5}), is_bright) << column << " " << row;
            }
        EXPECT_EQ(area_of(plane), bright);
    }
}

TEST(FormulaRegions, HaveAreasOfClosedForm)
{
    // The polygon of a circle that crosses lattice lines: chords of the true circle, nearly.
    const PlaneRegion disk = read_region("formula -2 -2 2 2 1.5^2 - x^2 - y^2");
    EXPECT_NEAR(area_of(disk), std::numbers::pi * 2.25, 1e-4);
    const PlaneRegion ring = read_region("formula -2 -1 2 1 (x^2+y^2 < 0.8) && (x^2+y^2 > 0.2)");
    ASSERT_EQ(ring.polygons.size(), 1U);
    EXPECT_EQ(ring.polygons[0].holes.size(), 1U);
    EXPECT_NEAR(area_of(ring), std::numbers::pi * 0.6, 0.02); // comparisons end at nodes, half a cell too far
    // Positive everywhere: the rectangle; what is cut by its border goes up to it.
    const PlaneRegion whole = read_region("formula 10 20 12 21 1");
    EXPECT_NEAR(area_of(whole), 2, 1e-12);
    EXPECT_EQ(box_of(whole).low, (std::array{10.0, 20.0}));
    EXPECT_EQ(box_of(whole).high, (std::array{12.0, 21.0}));
    EXPECT_NEAR(area_of(read_region("formula 0 0 3 2 sin(7*x)*sin(7*y)")), 3, 0.1); // ambiguous squares
}

TEST(FormulaRegions, SayWhatIsWrong)
{
    const auto message = [](const std::string& text) { return message_of([&] { read_region(text); }); };
    EXPECT_THAT(message("formula 0 0 1 x"), HasSubstr("must be formula X0 Y0 X1 Y1 EXPRESSION with X0 < X1"));
    EXPECT_THAT(message("formula 0 0 1 1"), HasSubstr("must be formula X0 Y0 X1 Y1 EXPRESSION"));
    EXPECT_THAT(message("formula 0 0 1 1 x*-1"), HasSubstr("is nowhere above 0 in its rectangle"));
    EXPECT_THAT(message("formula 0 0 1 1 sin("), HasSubstr("formula \"sin(\": "));
}

TEST_F(DrawnRegions, PointsOfFilesAreObstacles)
{
    const std::string csv = (folder_.path() / "trees.csv").string(), npy = (folder_.path() / "trees.npy").string();
    std::ofstream(csv) << "x,y\n500000.25,-3\n1e6,2.5\n";
    EXPECT_THAT(read_obstacles(csv).points, testing::ElementsAre(std::array{500000.25, -3.0}, std::array{1e6, 2.5}));
    write_points(npy, {2, {7.5, -1e5, 0, 3}});
    EXPECT_THAT(read_obstacles(npy).points, testing::ElementsAre(std::array{7.5, -1e5}, std::array{0.0, 3.0}));
    write_points(npy, {3, {7.5, -1e5, 0}});
    EXPECT_THAT(read_obstacles(npy).points, testing::ElementsAre(std::array{7.5, -1e5})) << "points of the plane";
    write_points(npy, {3, {7.5, -1e5, 1}});
    EXPECT_THAT(message_of([&] { read_obstacles(npy); }), HasSubstr("the points are in space"));
    std::ofstream(csv) << "a tree\n";
    EXPECT_THAT(message_of([&] { read_obstacles(csv); }), HasSubstr("is neither GeoJSON nor WKT, nor a picture"));
}

}
}
