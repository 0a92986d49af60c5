// Paintings at points of recursive tiles: stamps where they belong, and ink that is theirs.
#include "base/errors/errors.hpp"
#include "base/images/srgb_light.hpp"
#include "host/distribution/recursive_tiles/recursive_tile_run.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

RecursiveTileSettings settings_of(std::uint32_t width, std::uint32_t height, std::size_t points)
{
    RecursiveTileSettings settings;
    settings.window.size = {width, height};
    settings.points = points;
    settings.points_per_tile = 128;
    return settings;
}

StampedWindow window_of(const RecursiveTileSettings& settings, std::uint64_t seed = 1)
{
    return stamped_window(settings, seed, {});
}

/// A picture without alpha of one colour, some pixels wide and high.
std::filesystem::path colored(const TemporaryFolder& folder, int width, int height, std::array<std::uint8_t, 3> color)
{
    PngPixels pixels{width, height, 3, {}};
    for (int i = 0; i < width * height; ++i) pixels.values.insert(pixels.values.end(), color.begin(), color.end());
    const auto file = folder.path() / ("stamp" + std::to_string(color[0]) + ".png");
    write_png(file, pixels);
    return file;
}

double light_at(const PngPixels& picture, int column, int row, int channel)
{
    return light_of_bytes()[picture.values[picture.at(column, row, channel)]] / 65535.0;
}

/// The ink of dots is their area: each is half as wide as its square. Dots are so small that none overlap, and those at
/// the border reach beyond it by a part of their area, at most the share of points that are so near.
TEST(Paintings, HaveTheInkOfTheirDots)
{
    RecursiveTileSettings settings = settings_of(3, 2, 900);
    settings.stamp_size = 0.7;
    const StampedWindow window = window_of(settings);
    double area = 0; // in tiles
    for (const StampedPoint& point : window.points)
        area += std::numbers::pi / 4 * std::pow(0.5 * settings.stamp_size * window.spacing * point.size, 2);
    for (const int pixels : {300, 600, 1200}) {
        const PngPixels picture = painting(settings, window, pixels);
        ASSERT_EQ(picture.width, pixels);
        ASSERT_EQ(picture.height, pixels * 2 / 3);
        double ink = 0;
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column) ink += 1 - light_at(picture, column, row, 0);
        const double part = ink / (std::pow(pixels / 3.0, 2) * area);
        EXPECT_GT(part, 0.96) << pixels; // 2 % of the points lie near the border
        EXPECT_LT(part, 1.02) << pixels;
    }
}

/// One point with one stamp of 40 x 20 pixels: red is where it is turned to, and nothing elsewhere.
TEST(Paintings, LayStampsAtPoints)
{
    const TemporaryFolder folder;
    RecursiveTileSettings settings = settings_of(1, 1, 1);
    settings.stamps = {colored(folder, 40, 20, {255, 0, 0})};
    StampedWindow window = window_of(settings);
    for (const double turn : {0.0, 0.5, std::numbers::pi / 2, 3.0}) {
        window.spacing = 0.25;
        window.points = {{{0.4, 0.7}, 0, turn, 1.2}};
        const PngPixels picture = painting(settings, window, 200);
        const double half = 0.25 * 1.2 * 200 / 2; // of its longer side
        int wrong = 0, red = 0;
        for (int row = 0; row < 200; ++row)
            for (int column = 0; column < 200; ++column) {
                const double dx = column + 0.5 - 80, up = 60 - (row + 0.5);
                const double along = std::cos(turn) * dx + std::sin(turn) * up;
                const double across = std::cos(turn) * up - std::sin(turn) * dx;
                const double from_edge = std::min(half - std::abs(along), half / 2 - std::abs(across));
                const bool is_red = picture.values[picture.at(column, row, 1)] == 0;
                const bool is_white = picture.values[picture.at(column, row, 1)] == 255;
                red += is_red;
                wrong += picture.values[picture.at(column, row, 0)] != 255 || (from_edge > 2.5 && !is_red) ||
                         (from_edge < -2.5 && !is_white);
            }
        EXPECT_EQ(wrong, 0) << turn;
        EXPECT_NEAR(red, 60 * 30, 2.5 * 2 * 90);
    }
}

/// Black squares of any number of pixels that are drawn a few pixels wide have the ink and the middle of squares: each
/// of 100 lies elsewhere among the samples, which are half a pixel apart: its middle is at most a quarter of a pixel
/// wrong, with a deviation of at most 0.145, and the mean of 100 of at most 0.0145, five times which is allowed.
TEST(Paintings, KeepTheSizeOfStampsThatAreDrawnSmall)
{
    const TemporaryFolder folder;
    RecursiveTileSettings settings = settings_of(1, 1, 1);
    for (const int pixels : {1, 3, 64, 65, 127, 129})
        for (const double side : {1.7, 4.1, 7.3}) {
            settings.stamps = {colored(folder, pixels, pixels, {0, 0, 0})};
            StampedWindow window = window_of(settings);
            window.spacing = side / 400;
            window.points.clear();
            for (int i = 0; i < 100; ++i)
                window.points.push_back(
                    {{(20.0 + 37 * (i % 10) + 0.137 * i) / 400, (20.0 + 37 * (i / 10) + 0.071 * i) / 400}, 0, 0, 1});
            const PngPixels picture = painting(settings, window, 400);
            double ink = 0, right = 0, up = 0; // from the points
            for (const StampedPoint& point : window.points) {
                const double x = 400 * point.place[0], y = 400 * (1 - point.place[1]);
                for (int row = static_cast<int>(y) - 15; row < static_cast<int>(y) + 15; ++row)
                    for (int column = static_cast<int>(x) - 15; column < static_cast<int>(x) + 15; ++column) {
                        const double dark = 1 - light_at(picture, column, row, 0);
                        ink += dark;
                        right += dark * (column + 0.5 - x);
                        up += dark * (y - (row + 0.5));
                    }
            }
            EXPECT_NEAR(ink / 100, side * side, 0.03 * side * side) << pixels << " " << side;
            EXPECT_NEAR(right / ink, 0, 0.075) << pixels << " " << side;
            EXPECT_NEAR(up / ink, 0, 0.075) << pixels << " " << side;
        }
}

TEST(Paintings, TakeStampsInTurnByTheirPoints)
{
    const TemporaryFolder folder;
    RecursiveTileSettings settings = settings_of(4, 4, 2000);
    settings.is_upright = true;
    settings.stamps = {colored(folder, 3, 3, {10, 0, 0}), colored(folder, 2, 1, {20, 0, 0}),
                       colored(folder, 1, 1, {30, 0, 0})};
    const StampedWindow window = window_of(settings);
    std::array<int, 3> counts{};
    double sum = 0, smallest = 9, largest = 0;
    for (const StampedPoint& point : window.points) {
        ++counts.at(point.stamp);
        EXPECT_EQ(point.turn, 0);
        sum += point.size;
        smallest = std::min(smallest, point.size);
        largest = std::max(largest, point.size);
    }
    const auto all = static_cast<double>(window.points.size());
    EXPECT_NEAR(all, 2000, 16);
    for (const int count : counts) EXPECT_NEAR(count, all / 3, 5 * std::sqrt(all * 2 / 9));
    EXPECT_NEAR(sum / all, 1, 5 * 0.6 / std::sqrt(12 * all));
    EXPECT_GE(smallest, 0.7);
    EXPECT_LE(largest, 1.3);
    EXPECT_FALSE(painting(settings, window, 64).values.empty());
}

TEST(Paintings, FollowAPicture)
{
    const TemporaryFolder folder;
    PngPixels half{8, 8, 1, {}};
    for (int i = 0; i < 64; ++i) half.values.push_back(i % 8 < 4 ? 255 : 0);
    write_png(folder.path() / "half.png", half);
    RecursiveTileSettings settings = settings_of(2, 2, 3000);
    settings.density.text = (folder.path() / "half.png").string();
    const StampedWindow window = window_of(settings);
    EXPECT_NEAR(static_cast<double>(window.points.size()), 3000, 60);
    EXPECT_NEAR(window.spacing, std::sqrt(2.0 / 3000), 1e-6);
    for (const StampedPoint& point : window.points) EXPECT_LT(point.place[0], 1);
}

TEST(Paintings, OfFewPointsAreMade)
{
    for (const std::size_t points : {1U, 2U, 3U}) {
        const RecursiveTileSettings settings = settings_of(1, 1, points);
        const StampedWindow window = window_of(settings);
        EXPECT_NEAR(static_cast<double>(window.points.size()), static_cast<double>(points), 1);
        for (const int pixels : {1, 2, 3}) EXPECT_EQ(painting(settings, window, pixels).height, pixels);
        EXPECT_FALSE(recursive_tile_numbers(settings, window).empty());
    }
    EXPECT_NE(window_of(settings_of(1, 1, 500)).points.front().place,
              window_of(settings_of(1, 1, 500), 2).points.front().place);
}

}
}
