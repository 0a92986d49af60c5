// `poissonlab tiles picture`: pixels, read by libpng, hold the points of `tiles points --torus`, in an order by rank
// whose first parts are even.
#include "base/points/point_file.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tests/support/raw_png.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

namespace poissonlab {
namespace {

/// A point of a picture: its place in pixels, on the torus.
struct PixelPoint
{
    std::uint32_t number = 0;
    std::array<double, 2> place{};
};

std::vector<PixelPoint> points_of_pixels(const test::RawPng& picture)
{
    std::vector<PixelPoint> points;
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const std::uint16_t* const values = picture.pixel(column, row);
            // A value of 255 is the pixel's far border, in the last pixel that of the torus.
            const double x = std::fmod(column + values[0] / 255.0, picture.width);
            const double y = std::fmod(row + values[1] / 255.0, picture.height);
            if (values[3] > 0)
                points.push_back({(values[3] - 1U) * 256U + values[2], {x, y}});
            else
                EXPECT_EQ(values[0] + values[1] + values[2], 0);
        }
    std::ranges::sort(points, {}, &PixelPoint::number);
    return points;
}

/// The squared distance on a torus of `side` pixels along each axis.
double squared_distance(const std::array<double, 2>& a, const std::array<double, 2>& b, double side)
{
    double sum = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double direct = std::abs(a[axis] - b[axis]);
        sum += std::pow(std::min(direct, side - direct), 2);
    }
    return sum;
}

double least_distance(std::span<const PixelPoint> points, double side)
{
    double least = 1e300;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, squared_distance(points[i].place, points[j].place, side));
    return std::sqrt(least);
}

class TilesPictureCommand : public test::CommandTest
{
protected:
    TilesPictureCommand() : CommandTest("tiles picture") {}

    static inline const std::string file_ = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
};

TEST_F(TilesPictureCommand, HasThePointsOfTheTorus)
{
    const auto json = nlohmann::json::parse(printed(file_ + " --torus 6 --seed 9 --out a.png --json"));
    const test::RawPng picture = test::read_raw_png(folder_.path() / "a.png");
    EXPECT_EQ(picture.channels, 4);
    EXPECT_EQ(picture.width, 128); // with a distance of 0.1008 tiles, 85 would do
    EXPECT_EQ(picture.height, 128);
    const std::vector<PixelPoint> points = points_of_pixels(picture);
    ASSERT_EQ(points.size(), 6U * 6U * 64U);

    // The nearest point of the picture is where the point file has one, but for what 255 steps a pixel leave.
    ASSERT_EQ(
        run_program(folder_.path(), {"tiles", "points", file_, "--torus", "6", "--seed", "9", "--out", "a.npy"}).status,
        0);
    const PointSet expected = read_points(folder_.path() / "a.npy", CoordinateRange{0, 6}).at(0);
    ASSERT_EQ(expected.size(), points.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        double nearest = 1e300;
        for (const PixelPoint& p : points)
            nearest = std::min(nearest, squared_distance(p.place, {expected[i][0] * 128, expected[i][1] * 128}, 128));
        EXPECT_LE(std::sqrt(nearest), std::sqrt(2) / 510 + 1e-9) << i;
    }
    EXPECT_EQ(json["points"], 6 * 6 * 64);
    EXPECT_EQ(json["pixels"], 128);
    EXPECT_NEAR(json["min_distance"].get<double>(), least_distance(points, 128), 1e-9);
    EXPECT_GE(json["relative_radius"].get<double>(), 0.745);
}

/// Every number is there once; numbers follow the ranks; parts of the order are about as even as the whole.
TEST_F(TilesPictureCommand, NumbersPointsSoThatPartsAreEven)
{
    EXPECT_EQ(printed(file_ + " --torus 8 --out a.png"), "");
    const std::vector<PixelPoint> points = points_of_pixels(test::read_raw_png(folder_.path() / "a.png"));
    ASSERT_EQ(points.size(), 8U * 8U * 64U);
    const PoissonTileSet tiles = read_tile_set(file_);
    const ptiles_tiling tiling = runtime_tiling(tiles, {1, 8});
    const double side = 128;
    double level = 0;
    for (std::size_t n = 0; n < points.size(); ++n) {
        EXPECT_EQ(points[n].number, n);
        const double place[] = {points[n].place[0] * 8 / side, points[n].place[1] * 8 / side};
        ptiles_point nearest;
        EXPECT_LT(ptiles_nearest(&tiling, place, &nearest), 1e-7);
        EXPECT_GE(nearest.level, level);
        level = nearest.level;
    }
    for (const std::size_t part : {points.size() / 2, points.size() / 4 + 31}) {
        // No four by four tiles have more or fewer points than their part by a tenth: random points differ by more.
        std::map<std::array<int, 2>, int> counts;
        for (std::size_t n = 0; n < part; ++n)
            ++counts[{static_cast<int>(points[n].place[0] / 64), static_cast<int>(points[n].place[1] / 64)}];
        for (const auto& [square, count] : counts)
            EXPECT_NEAR(count, static_cast<double>(part) / 4, 0.1 * static_cast<double>(part) / 4);
        const double whole = std::sqrt(std::numbers::inv_sqrt3 * 2 / static_cast<double>(part)) * side;
        EXPECT_GT(least_distance(std::span(points).first(part), side), 0.25 * whole) << part; // random points: 0.01
    }
}

TEST_F(TilesPictureCommand, RefusesWhatNoPictureHolds)
{
    expect_error(file_ + " --torus 32 --out a.png",
                 "tiles picture: " + file_ + ": 32 x 32 tiles have 65536 points: must be at most 65280");
    EXPECT_THAT(
        run(file_ + " --torus 8 --pixels 64 --out a.png").error,
        testing::MatchesRegex("poissonlab: error: tiles picture: .*: two points are in the pixel [0-9]+, [0-9]+ of "
                              "64 x 64: more pixels keep them apart\n"));
    write_tile_set(folder_.path() / "space.ptiles",
                   with_random_ranks(random_tile_set(PoissonTileKind::corner, 3, 2, 5)));
    expect_error("space.ptiles --torus 2 --pixels 64 --out a.png",
                 "tiles picture: space.ptiles: tiles of space: must be a tile set in the plane");
    write_tile_set(folder_.path() / "plain.ptiles", random_tile_set(PoissonTileKind::corner, 2, 2, 5));
    expect_error("plain.ptiles --torus 2 --pixels 64 --out a.png",
                 "tiles picture: plain.ptiles: the set is not ranked: tiles build --ranked makes one that is");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "a.png"));
}

}
}
