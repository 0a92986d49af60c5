// Pictures in dots and strokes: numbers in proportion to ink, tones, and the same places by both engines.
#include "host/distribution/stipple.hpp"

#include "host/distribution/even_points.hpp"
#include "host/distribution/relaxed_places.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/warp/warp.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using testing::HasSubstr;

DistributionPlace stippled_on(Engine engine)
{
    return {engine, []() -> Device& {
                static Device device = Device::open();
                return device;
            }};
}

StippleSettings dots_of(const std::string& image, std::size_t points)
{
    StippleSettings settings;
    settings.image = image;
    settings.points = points;
    settings.by = MarkPlaces::warping;
    settings.method.tiles = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
    return settings;
}

struct Print
{
    InkPicture picture;
    Stippling stippling;
    Coverage coverage;
    TonesOfMarks tones;
};

Print print(const StippleSettings& settings)
{
    Print print;
    print.picture = read_ink(settings);
    print.stippling = stipple(print.picture, settings, 3, stippled_on(Engine::opencl));
    print.coverage = coverage_of(print.stippling.marks, print.picture.ink.width, print.picture.ink.height, 1);
    print.tones = tones_of(print.picture, settings, print.stippling, print.coverage, stippled_on(Engine::opencl));
    return print;
}

/// The grey wedge of eleven steps, from white to half black. Each step has dots in proportion to its ink; borders
/// between steps cut through sqrt(N) even points, each of which is on one side or the other.
TEST(Stippling, HasDotsInProportionToTheStepsOfAWedge)
{
    const Print wedge = print(dots_of("rint((x+1)*5.5 - 0.5)/20", 11'000));
    ASSERT_EQ(wedge.stippling.marks.disks.size(), 11'000);
    std::array<double, 11> counts{}, inks{};
    const auto step = [&](double x) { return static_cast<std::size_t>((2 * std::floor(x) + 1) / 1024 * 5.5); };
    for (const auto& dot : wedge.stippling.marks.disks) ++counts.at(step(dot[0]));
    for (int y = 0; y < 1024; ++y)
        for (int x = 0; x < 1024; ++x) inks.at(step(x)) += wedge.picture.ink.at(x, y);
    const double allowed = 4 * std::sqrt(2 * std::sqrt(11'000.0) / 4);
    EXPECT_EQ(counts[0], 0);
    for (std::size_t i = 1; i < counts.size(); ++i) {
        EXPECT_NEAR(counts[i], inks[i] / wedge.stippling.mark_area, allowed) << i;
        EXPECT_NEAR(counts[i], counts[10] * static_cast<double>(i) / 10, 2 * allowed) << i;
    }
    EXPECT_NEAR(wedge.stippling.mark_area * 11'000, wedge.picture.total, 1e-6);
}

/// Points of the tiling keep their distance, so that dots overlap nowhere: all ink is seen but for what the frame cuts
/// off, and each window of 32 pixels has its tone but for the dots that its border cuts.
TEST(Stippling, PrintsConstantTonesExactly)
{
    for (const double ink : {0.05, 0.2, 0.45}) {
        StippleSettings settings = dots_of(std::to_string(ink), 5000);
        const Print even = print(settings);
        EXPECT_NEAR(even.tones.overlap, 0, 1e-12);
        EXPECT_EQ(even.tones.too_dark, 0);
        EXPECT_GE(even.tones.darkest_ink, 0.45);
        const double radius = even.stippling.mark_width / 2;
        double at_the_frame = 0;
        for (const auto& [x, y, r] : even.stippling.marks.disks)
            at_the_frame += x < radius || y < radius || x > 1024 - radius || y > 1024 - radius ? 1 : 0;
        EXPECT_LE(std::abs(even.coverage.covered - even.picture.total), at_the_frame * even.stippling.mark_area);
        EXPECT_GT(at_the_frame, 0);
        // A window's border of 128 pixels is some 9 dots long, of each of which half may be missing or too much.
        EXPECT_LT(even.tones.error, ink * 0.5 * std::sqrt(9.0) / (32 * 32 / (1024.0 * 1024 / 5000)));
    }
}

TEST(Stippling, SaysWhatIsTooDark)
{
    const Print dark = print(dots_of("x < 0 ? 0.9 : 0.1", 2000));
    EXPECT_NEAR(dark.tones.too_dark, 0.5, 1e-9);
    EXPECT_GT(dark.tones.overlap, 0.05);
    EXPECT_LT(dark.tones.darkest_ink, std::numbers::pi / std::sqrt(12.0));
    // Half of the ink is what dots can print.
    StippleSettings settings = dots_of("x < 0 ? 0.9 : 0.1", 2000);
    settings.ink = 0.5;
    const Print lighter = print(settings);
    EXPECT_LT(lighter.tones.overlap, dark.tones.overlap / 2);
    EXPECT_NEAR(lighter.picture.total, dark.picture.total / 2, 1e-6);
}

TEST(Stippling, HasAsManyDotsOfASizeAsTheInkNeeds)
{
    StippleSettings settings = dots_of("0.3", 0);
    settings.mark_width = 7;
    const Print even = print(settings);
    const double wanted = 0.3 * 1024 * 1024 / (std::numbers::pi * 49 / 4);
    EXPECT_EQ(even.stippling.marks.disks.size(), static_cast<std::size_t>(std::llround(wanted)));
    EXPECT_NEAR(even.stippling.mark_width, 7, 7 / wanted);
    settings.has_strokes = true;
    const double strokes = 0.3 * 1024 * 1024 / (49 * (7 + std::numbers::pi / 4));
    EXPECT_EQ(print(settings).stippling.marks.strokes.size(), static_cast<std::size_t>(std::llround(strokes)));
}

TEST(Stippling, GivesTheSamePlacesByBothEngines)
{
    const StippleSettings settings = dots_of("0.3*(x>0) + 0.1", 700);
    const InkPicture picture = read_ink(settings);
    EXPECT_EQ(stipple(picture, settings, 3, stippled_on(Engine::opencl)).places,
              stipple(picture, settings, 3, stippled_on(Engine::reference)).places);
    EXPECT_NE(stipple(picture, settings, 3, stippled_on(Engine::reference)).places,
              stipple(picture, settings, 4, stippled_on(Engine::reference)).places);
}

TEST(Stippling, TakesRanksInstead)
{
    StippleSettings settings = dots_of("0.2 + 0.2*(x>0)", 4000);
    settings.by = MarkPlaces::ranks;
    settings.method = {};
    const Print ranked = print(settings);
    const auto n = static_cast<double>(ranked.stippling.marks.disks.size());
    EXPECT_NEAR(n, 4000, 4 * std::sqrt(4000));
    EXPECT_NEAR(ranked.stippling.mark_area * n, ranked.picture.total, 1e-6);
    settings.zoom = 4;
    EXPECT_EQ(read_ink(settings).ink.width, 256);
}

/// Gaussian blue noise keeps the numbers that warping puts into the steps of a wedge: only dots at the borders between
/// them may be on the other side.
TEST(Stippling, KeepsTonesByGaussians)
{
    StippleSettings settings = dots_of("rint((x+1)*5.5 - 0.5)/20 + 0.02*(y+1)", 11'000);
    settings.by = MarkPlaces::gaussian;
    const Print relaxed = print(settings);
    ASSERT_EQ(relaxed.stippling.marks.disks.size(), 11'000);
    std::array<double, 11> counts{}, inks{};
    const auto step = [&](double x) { return static_cast<std::size_t>((2 * std::floor(x) + 1) / 1024 * 5.5); };
    for (const auto& dot : relaxed.stippling.marks.disks) ++counts.at(step(dot[0]));
    for (int y = 0; y < 1024; ++y)
        for (int x = 0; x < 1024; ++x) inks.at(step(x)) += relaxed.picture.ink.at(x, y);
    const double allowed = 4 * std::sqrt(2 * std::sqrt(11'000.0) / 4);
    for (std::size_t i = 0; i < counts.size(); ++i)
        EXPECT_NEAR(counts[i], inks[i] / relaxed.stippling.mark_area, allowed) << i;
}

/// Mean and standard deviation of nearest distances of some dots, by comparing all, in parts of the largest that the
/// ink there allows.
std::array<double, 2> nearest_distances(const Print& of)
{
    double sum = 0, squares = 0;
    const auto& dots = of.stippling.marks.disks;
    constexpr std::size_t count = 2000;
    for (std::size_t i = 0; i < count; ++i) {
        double least = 1e9;
        for (std::size_t k = 0; k < dots.size(); ++k)
            if (k != i) least = std::min(least, std::hypot(dots[k][0] - dots[i][0], dots[k][1] - dots[i][1]));
        const double ink = of.picture.ink.at(static_cast<int>(dots[i][0]), static_cast<int>(dots[i][1]));
        const double part = least * std::sqrt(std::sqrt(3.0) / 2 * ink / of.stippling.mark_area);
        sum += part / count;
        squares += part * part / count;
    }
    return {sum, std::sqrt(squares - sum * sum)};
}

/// Where ink changes from row to row, warping stretches distances: dots clump and overlap. Gaussian blue noise makes
/// them even again.
TEST(Stippling, GetsEvenByGaussians)
{
    StippleSettings settings = dots_of("0.22 + 0.18*sin(20*(x^2+y^2))", 8'000);
    const Print warped = print(settings);
    settings.by = MarkPlaces::gaussian;
    const Print relaxed = print(settings);
    const auto [mean_before, deviation_before] = nearest_distances(warped);
    const auto [mean, deviation] = nearest_distances(relaxed);
    EXPECT_GT(mean, mean_before);
    EXPECT_LT(deviation, deviation_before);
    EXPECT_LT(relaxed.tones.overlap, warped.tones.overlap);
    EXPECT_LT(relaxed.tones.error, warped.tones.error);
}

/// Pictures need not be square: points stay inside. Both engines move them alike. Too few points stay where they are.
TEST(Stippling, KeepsGaussiansInThePicture)
{
    Density wide{90, 40, {}}, high{40, 90, {}};
    for (std::uint64_t i = 0; i < 3600; ++i) {
        wide.weights.push_back(full_weight / (1 + i % 90 / 30));
        high.weights.push_back(full_weight - i * (full_weight / 4000));
    }
    const EvenMethod method = read_tile_set(dots_of("0", 1).method.tiles);
    for (const Density& density : {wide, high}) {
        const DistributionPlace plain = stippled_on(Engine::reference);
        const auto warped_of = [&](std::size_t points) {
            return warp_points(density, even_points(method, points, density.width, density.height, 2, plain), plain);
        };
        const PixelPlaces warped = warped_of(500);
        const PixelPlaces relaxed = relaxed_places(density, warped, 20, plain);
        ASSERT_EQ(relaxed.size(), 1000);
        EXPECT_NE(relaxed, warped);
        EXPECT_EQ(relaxed_places(density, warped, 20, stippled_on(Engine::opencl)), relaxed);
        for (std::size_t i = 0; i < relaxed.size(); i += 2) {
            EXPECT_LT(relaxed[i] >> 32, static_cast<std::uint64_t>(density.width));
            EXPECT_LT(relaxed[i + 1] >> 32, static_cast<std::uint64_t>(density.height));
        }
        EXPECT_EQ(relaxed_places(density, warped_of(least_relaxed_places - 1), 20, plain),
                  warped_of(least_relaxed_places - 1));
    }
    EXPECT_EQ(least_relaxed_places, least_gaussian_points(1, 2));
    const Density line{8'388'608, 1, std::vector<std::uint64_t>(8'388'608, full_weight)};
    EXPECT_THAT(
        message_of([&] { relaxed_places(line, PixelPlaces(400), 1, stippled_on(Engine::reference)); }),
        HasSubstr("8388608 x 1 pixels are part of a square of 70368744177664 pixels; must be at most 67108864"));
}

/// Long pictures are reflected at both of their sides: no points flow out of them and come back as images, which may
/// lie on points. The least distance in 100 x 100 pixels is 0.59 to 0.74 of the mean one, in pictures one pixel wide
/// 0.36 to 0.58, and was 0.10 where one side had no images.
TEST(Stippling, KeepsGaussiansApartInLongPictures)
{
    const EvenMethod method = read_tile_set(dots_of("0", 1).method.tiles);
    constexpr std::size_t points = 400;
    for (const auto& [width, height] : {std::pair{100, 300}, {300, 100}, {1, 300}, {300, 1}}) {
        const int area = width * height;
        const Density even{width, height, std::vector<std::uint64_t>(static_cast<std::size_t>(area), full_weight)};
        const DistributionPlace place = stippled_on(Engine::opencl);
        const PixelPlaces places = relaxed_places(
            even, warp_points(even, even_points(method, points, width, height, 1, place), place), 100, place);
        const auto at = [&](std::size_t i) { return std::ldexp(static_cast<double>(places[i]), -32); };
        double least = std::hypot(width, height);
        for (std::size_t i = 0; i < 2 * points; i += 2)
            for (std::size_t k = 0; k < i; k += 2)
                least = std::min(least, std::hypot(at(i) - at(k), at(i + 1) - at(k + 1)));
        EXPECT_GT(least, 1.0 / 3 * std::sqrt(area / static_cast<double>(points))) << width << " x " << height;
    }
}

/// Bands of a quarter of a mean distance along the border have as many points as the ink asks for: no row of points
/// lies there. Counts of five sets vary by less than those of random points, of which four standard deviations are
/// allowed.
TEST(Stippling, HasNoRowsAlongTheBorder)
{
    const EvenMethod method = read_tile_set(dots_of("0", 1).method.tiles);
    constexpr std::size_t points = 4000, bands = 6;
    for (const auto& [width, height] : {std::pair{90, 60}, {60, 90}}) {
        const Density even{width, height, std::vector<std::uint64_t>(5400, full_weight)};
        const double distance = std::sqrt(5400.0 / points);
        std::array<double, bands> counts{};
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const DistributionPlace place = stippled_on(Engine::opencl);
            const PixelPlaces places = relaxed_places(
                even, warp_points(even, even_points(method, points, width, height, seed, place), place), 100, place);
            for (std::size_t i = width > height ? 1 : 0; i < places.size(); i += 2) {
                const double at = std::ldexp(static_cast<double>(places[i]), -32);
                const auto band = static_cast<std::size_t>(4 * std::min(at, 60 - at) / distance);
                if (band < bands) ++counts.at(band);
            }
        }
        const double expected = 5 * 2 * points * distance / 4 / 60;
        for (std::size_t i = 0; i < bands; ++i) EXPECT_NEAR(counts.at(i), expected, 4 * std::sqrt(expected)) << i;
    }
}

/// Ranked tiles keep their proven distance whatever the density does: no ink lies on other ink as long as the darkest
/// tone is below 0.9069 rho^2, and numbers in the steps of a wedge are in proportion.
TEST(Stippling, NeverOverlapsByRanksOfTiles)
{
    StippleSettings settings = dots_of("rint((x+1)*5.5 - 0.5)/20", 11'000);
    settings.by = MarkPlaces::ranks;
    const Print wedge = print(settings);
    const auto n = static_cast<double>(wedge.stippling.marks.disks.size());
    EXPECT_NEAR(n, 11'000, 2 * std::sqrt(11'000));
    const double proven = certify(read_tile_set(settings.method.tiles)).relative_radius;
    const double darkest = wedge.tones.darkest_ink / (std::numbers::pi / std::sqrt(12.0)) * 11'000 / n;
    EXPECT_NEAR(std::sqrt(darkest), proven, 1e-9);
    EXPECT_EQ(wedge.tones.too_dark, 0);
    EXPECT_NEAR(wedge.tones.overlap, 0, 1e-12);
    std::array<double, 11> counts{};
    for (const auto& dot : wedge.stippling.marks.disks)
        ++counts.at(static_cast<std::size_t>((2 * std::floor(dot[0]) + 1) / 1024 * 5.5));
    // Ranks are whole numbers up to 64: a step has up to half of one more or less of each tile's points.
    for (std::size_t i = 0; i < counts.size(); ++i)
        EXPECT_NEAR(counts[i], n * static_cast<double>(i) / 55, n / 55 * 10 / 64 + 30) << i;
    settings.method = {source_folder() + "/runtime/tile_sets/README.md", {}};
    EXPECT_THAT(message_of([&] { stipple(wedge.picture, settings, 1, stippled_on(Engine::reference)); }),
                HasSubstr("README.md"));
}

/// Tiles are as fine as the darkest places ask for, all over the picture.
TEST(Stippling, RefusesRanksOfFarMorePointsThanMarks)
{
    StippleSettings settings = dots_of("abs(x) < 0.001 && abs(y) < 0.001", 10'000);
    settings.by = MarkPlaces::ranks;
    settings.method = {source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles", {}};
    const InkPicture picture = read_ink(settings);
    EXPECT_EQ(picture.total, 4);
    EXPECT_THAT(message_of([&] { stipple(picture, settings, 1, stippled_on(Engine::reference)); }),
                HasSubstr("are chosen of 2621440000 points; must be at most 67108864"));
}

/// Strokes lie along stripes, or along the angle that is given; a window of even ink has its tone.
TEST(Hatching, FollowsLines)
{
    StippleSettings settings = dots_of("0.1 + 0.05*sin(60*x)", 1000);
    settings.has_strokes = true;
    for (const auto& [x0, y0, x1, y1, width] : print(settings).stippling.marks.strokes) {
        EXPECT_NEAR(x0, x1, 1e-6);
        EXPECT_NEAR(std::abs(y1 - y0), 7 * width, 1e-9);
    }
    settings.angle = 0;
    const Print flat = print(settings);
    for (const auto& [x0, y0, x1, y1, width] : flat.stippling.marks.strokes) EXPECT_EQ(y0, y1);
    EXPECT_NEAR(flat.coverage.laid, flat.picture.total, 0.02 * flat.picture.total); // but for the frame
}

TEST(Stippling, RefusesInkThatIsNone)
{
    EXPECT_THAT(message_of([] { read_ink(dots_of("1.5", 8)); }), HasSubstr("pixel (0, 1023): ink 1.5: must be from 0"));
    EXPECT_THAT(message_of([] { read_ink(dots_of("-0.5", 8)); }), HasSubstr("ink -0.5"));
    EXPECT_THAT(message_of([] { read_ink(dots_of("0*x", 8)); }), HasSubstr("0*x: has no ink: is white everywhere"));
    StippleSettings settings = dots_of("0.001", 0);
    settings.mark_width = 9000;
    const InkPicture picture = read_ink(settings);
    EXPECT_THAT(message_of([&] { stipple(picture, settings, 1, stippled_on(Engine::reference)); }),
                HasSubstr("0 marks for the ink of 1048.6 pixels"));
}

}
}
