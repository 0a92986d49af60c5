// Tests of regularity in exemplars: waves of known place and share are found, and none in noise; a plane seen at a
// known angle becomes straight; windows may lie exactly where a count of pixels says; joints of a wall run through.
#include "host/texture/joint/phase_rule.hpp"
#include "host/texture/regular/seen_waves.hpp"
#include "host/texture/regular/straightening.hpp"
#include "host/texture/synthetic_exemplar.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>
#include <utility>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// Waves of an amplitude over noise of a standard deviation.
LightMap wave_map(int width, int height, const std::vector<RegularWave>& waves, double amplitude, double noise)
{
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, noise);
    LightMap map{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double value = 100 + normal(random);
            for (const RegularWave& wave : waves)
                value += amplitude * std::cos(2 * std::numbers::pi * (wave.x * x + wave.y * y));
            map.values.push_back(value);
        }
    return map;
}

/// A share is that of the variance: A^2 / 2 each, of cosines over noise. Places are as exact as promised.
TEST(RegularWaves, FindsKnownWaves)
{
    constexpr int width = 192, height = 160;
    const std::vector<RegularWave> known{{0.0801, 0.0104, 0, 0}, {-0.011, 0.0617, 0, 0}};
    const std::vector<RegularWave> found = regular_waves(wave_map(width, height, known, 12, 16));
    ASSERT_EQ(found.size(), 2u);
    const double share = 72 / (2 * 72 + 16.0 * 16);
    for (const RegularWave& wave : known)
        EXPECT_TRUE(std::ranges::any_of(found,
                                        [&](const RegularWave& other) {
                                            const double sign = other.x * wave.x + other.y * wave.y > 0 ? 1 : -1;
                                            return std::abs(sign * other.x - wave.x) * width < 0.03 &&
                                                   std::abs(sign * other.y - wave.y) * height < 0.03;
                                        }))
            << wave.x << " " << wave.y;
    // A wave between whole numbers of periods is spread over more places than are added up, by up to a tenth.
    for (const RegularWave& wave : found) EXPECT_NEAR(wave.share, share, 0.1 * share + 0.02);
}

/// Steps after which waves that span all of a picture repeat: those are all steps with whole numbers of periods, whose
/// area is one over the waves' determinant. `tolerance`: in pixels.
void expect_lattice(const std::vector<RegularWave>& waves, Place first, Place second, double tolerance)
{
    ASSERT_EQ(waves.size(), 2u);
    for (const RegularWave& wave : waves)
        for (const Place& step : {first, second})
            EXPECT_LE(std::abs(std::remainder(wave.x * step.x + wave.y * step.y, 1.0)) * wave.period(), tolerance)
                << "a wave of " << wave.x << ", " << wave.y << " and a step of " << step.x << ", " << step.y;
    const double area = 1 / std::abs(waves[0].x * waves[1].y - waves[0].y * waves[1].x);
    EXPECT_NEAR(area, std::abs(first.x * second.y - first.y * second.x), area * 0.02);
}

TEST(RegularWaves, FindsNoneInNoise)
{
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const PngPixels noise = test::random_picture(160, 128, 1, seed);
        EXPECT_TRUE(regular_waves(lightness_map(noise)).empty());
        EXPECT_LT(strongest_wave(lightness_map(noise)).times, 5);
    }
    EXPECT_TRUE(regular_waves(LightMap{64, 64, std::vector<double>(64 * 64, 7.0)}).empty());
}

/// Bricks of 32 x 16 pixels, every other course half a brick further: the lattice of (32, 0) and (16, 16).
TEST(RegularWaves, FindsTheCoursesOfBricks)
{
    const std::vector<RegularWave> waves = regular_waves(lightness_map(synthetic_exemplar("bricks", 256, 1, {})));
    ASSERT_EQ(waves.size(), 2u);
    EXPECT_NEAR(waves[0].x, 0, 1e-3);
    EXPECT_NEAR(waves[0].y, 1.0 / 16, 1e-3);
    expect_lattice(waves, {32, 0}, {16, 16}, 0.05);
    for (const RegularWave& wave : waves) EXPECT_TRUE(fits_tiles(wave, 64)) << wave.x << " " << wave.y;
    EXPECT_FALSE(fits_tiles(waves[0], 56));
}

/// Threads of 8 pixels lie over each other by turns, so that the weave repeats after two of them, and after one along
/// both axes; waves along an axis alone would say after one.
TEST(RegularWaves, FindsTheTurnsOfAWeave)
{
    for (const std::uint64_t seed : {1, 2, 3})
        expect_lattice(regular_waves(lightness_map(synthetic_exemplar("fabric", 256, seed, {}))), {16, 0}, {8, 8}, 0.1);
}

/// Dots of a lattice, of which some are darker, so that it repeats after several of them only; over noise.
LightMap dotted_map(int side, double pitch, int columns, int rows, int shift, double noise)
{
    std::mt19937 random(11);
    std::normal_distribution<double> normal(0, noise);
    LightMap map{side, side, {}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int i = static_cast<int>(x / pitch), j = static_cast<int>(y / pitch);
            const double u = x / pitch - i - 0.5, v = y / pitch - j - 0.5;
            const bool is_dark = j % rows == 0 && (i + j / rows * shift) % columns == 0;
            map.values.push_back(100 + normal(random) + (is_dark ? 45 : 80) * std::exp(-12 * (u * u + v * v)));
        }
    return map;
}

TEST(RegularWaves, FindsTheWholePeriodOfDots)
{
    // All alike; every other one, in columns, along both axes and by turns; every third, also a step further a row.
    for (const auto& [columns, rows, shift] :
         {std::array{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {2, 1, 1}, {3, 1, 0}, {3, 1, 1}, {3, 1, 2}, {1, 3, 0}}) {
        SCOPED_TRACE(testing::Message() << columns << " " << rows << " " << shift);
        constexpr double pitch = 9.3;
        for (const double noise : {0.5, 12.0})
            expect_lattice(regular_waves(dotted_map(300, pitch, columns, rows, shift, noise)), {columns * pitch, 0},
                           {-shift * pitch, rows * pitch}, 0.06);
    }
}

/// Light and dark planks of a plane that is seen at a slope: see Straightening for the map.
PngPixels planks(int side, double east, double south, double period, double turn)
{
    PngPixels picture{side, side, 1, {}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double u = (column + 0.5) * 2 / side - 1, v = (row + 0.5) * 2 / side - 1;
            const double nearness = 1 / (1 - east * u - south * v); // u = x / nearness, nearness = 1 + east x + south y
            const double x = u * nearness * side / 2, y = v * nearness * side / 2;
            const double phase = (x * std::cos(turn) + y * std::sin(turn)) / period + 0.25;
            picture.values.push_back(phase - std::floor(phase) < 0.2 ? 200 : 90);
        }
    return picture;
}

TEST(Straightening, UndoesAKnownSlope)
{
    const PngPixels seen = planks(320, 0.07, -0.16, 21.3, 0.05);
    const Straightening map = straightening_for(seen, 64);
    const PngPixels made = straightened(seen, map);
    ASSERT_GE(made.width, 160);
    ASSERT_GE(made.height, 160);
    // Three planks a tile, and each row is like the next one but for rims of planks: light differs in few places.
    ASSERT_EQ(map.periods.size(), 1u);
    EXPECT_DOUBLE_EQ(map.periods[0], 64.0 / 3);
    EXPECT_NEAR(map.scale, 64.0 / 3 / 21.3, 0.03);
    int changed = 0, shifted = 0;
    for (int y = 0; y < made.height; ++y)
        for (int x = 0; x + 64 < made.width; ++x) {
            const auto differs = [&](int other_x, int other_y) {
                return std::abs(made.values[made.at(x, y, 0)] - made.values[made.at(other_x, other_y, 0)]) > 55;
            };
            changed += differs(x, made.height / 2) ? 1 : 0;
            shifted += differs(x + 64, y) ? 1 : 0;
        }
    // There are six rims in 64 columns: each may be a pixel away.
    EXPECT_LT(changed, made.height * (made.width - 64) * 6 / 64);
    EXPECT_LT(shifted, made.height * (made.width - 64) * 6 / 64);
}

/// Draws what a plane shows that is seen at a slope, around its middle, with noise.
PngPixels seen_at_slope(const PngPixels& plane, int side, const Slope& slope)
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 6);
    PngPixels picture{side, side, 1, {}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const Place place = slope.above({(column + 0.5) * 2 / side - 1, (row + 0.5) * 2 / side - 1});
            const auto at = [side](double part, int pixels) {
                return std::clamp(static_cast<int>(pixels / 2.0 + part * side / 2), 0, pixels - 1);
            };
            const double value = plane.values[plane.at(at(place.x, plane.width), at(place.y, plane.height), 0)];
            picture.values.push_back(static_cast<std::uint8_t>(std::clamp(value + normal(random), 0.0, 255.0)));
        }
    return picture;
}

/// 128 threads along a side are too fine for the first look, and in the whole picture their number changes from side to
/// side: they are found in its middle and followed to its rim, to a tenth of a period. Turns need all of this.
TEST(SeenWaves, FollowsFineThreadsToTheRim)
{
    const PngPixels weave = synthetic_exemplar("fabric", 1600, 4, {});
    for (const Slope& slope : {Slope{0, 0}, Slope{0.06, -0.1}}) {
        SCOPED_TRACE(slope.east);
        const SeenWaves seen = seen_waves(seen_at_slope(weave, 1024, slope));
        ASSERT_FALSE(seen.is_lost);
        EXPECT_NEAR(seen.slope.east, slope.east, 0.1 / 64);
        EXPECT_NEAR(seen.slope.south, slope.south, 0.1 / 64);
        expect_lattice(seen.waves, {16, 0}, {8, 8}, 0.03);
    }
}

/// A hundred periods over the side; light goes up and down in each, so that no pixels make waves of their own.
TEST(SeenWaves, FindsAHundredWaves)
{
    constexpr int side = 768;
    constexpr double period = 7.7, turn = 0.03;
    const Slope slope{-0.05, 0.11};
    PngPixels picture = test::random_picture(side, side, 1, 4);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Place place = slope.above({(x + 0.5) * 2 / side - 1, (y + 0.5) * 2 / side - 1});
            const double periods = (place.x * std::cos(turn) + place.y * std::sin(turn)) * side / 2 / period;
            std::uint8_t& value = picture.values[picture.at(x, y, 0)];
            value = static_cast<std::uint8_t>(value / 4 + 95 + 60 * std::cos(2 * std::numbers::pi * periods));
        }
    const SeenWaves seen = seen_waves(picture);
    ASSERT_EQ(seen.waves.size(), 1u);
    const double sign = seen.waves[0].x > 0 ? 1 : -1;
    EXPECT_NEAR(sign * seen.waves[0].x * 384, std::cos(turn) / period * 384, 0.1);
    EXPECT_NEAR(sign * seen.waves[0].y * 384, std::sin(turn) / period * 384, 0.1);
    EXPECT_NEAR(seen.slope.east, slope.east, 0.1 / 50);
    EXPECT_NEAR(seen.slope.south, slope.south, 0.1 / 50);
}

/// Planks in the middle of noise are no planks to the rim.
TEST(SeenWaves, SaysWhereWavesDoNotGoOn)
{
    PngPixels picture = test::random_picture(1024, 1024, 1, 9);
    const PngPixels middle = planks(300, 0, 0, 9, 0);
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x)
            picture.values[picture.at(362 + x, 362 + y, 0)] = middle.values[middle.at(x, y, 0)];
    EXPECT_TRUE(seen_waves(picture).is_lost);
    EXPECT_THAT(message_of<InputError>([&] { straightening_for(picture, 64); }),
                HasSubstr("what is regular in the picture's middle does not go on to its rim"));
}

/// Courses of the whole picture are straightened although its middle has a finer pattern.
TEST(SeenWaves, KeepsWhatIsEverywhere)
{
    constexpr int side = 1024, patch = 340;
    PngPixels picture = test::random_picture(side, side, 1, 10);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            std::uint8_t& value = picture.values[picture.at(x, y, 0)];
            value = static_cast<std::uint8_t>(value / 8 + 95 + 40 * std::cos(2 * std::numbers::pi * y / 40.0));
            if (std::abs(x - side / 2) < patch / 2 && std::abs(y - side / 2) < patch / 2)
                value = static_cast<std::uint8_t>(value / 4 + 90 + 60 * std::cos(2 * std::numbers::pi * x / 7.5));
        }
    const SeenWaves seen = seen_waves(picture);
    EXPECT_FALSE(seen.is_lost);
    ASSERT_GE(seen.waves.size(), 1u);
    EXPECT_NEAR(seen.waves[0].period(), 40, 0.4);
}

TEST(SeenWaves, AreTheSameOnAnyNumberOfThreads)
{
    const PngPixels picture = seen_at_slope(synthetic_exemplar("fabric", 900, 2, {}), 600, {0.05, 0});
    const auto found = [&] {
        const Straightening map = straightening_for(picture, 64);
        return std::pair(map.to_source, straightened(picture, map).values);
    };
    const auto of_all = found();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(found(), of_all);
}

TEST(Straightening, LeavesAStraightPictureItsPixels)
{
    const PngPixels bricks = synthetic_exemplar("bricks", 256, 1, {});
    const Straightening map = straightening_for(bricks, 64);
    EXPECT_GE(map.width, 253);
    EXPECT_GE(map.height, 253);
    EXPECT_NEAR(map.scale, 1, 0.005);
}

/// An exemplar that is straight and fits already is not sampled between its pixels.
TEST(Straightening, MovesNoPixelsOfWhatFits)
{
    const PngPixels picture = planks(256, 0, 0, 16, 0);
    const Straightening map = straightening_for(picture, 64);
    const PngPixels made = straightened(picture, map);
    const int left = static_cast<int>(map.to_source[2]), top = static_cast<int>(map.to_source[5]);
    ASSERT_GE(made.width, 250);
    for (int y = 0; y < made.height; ++y)
        for (int x = 0; x < made.width; ++x)
            ASSERT_EQ(made.values[made.at(x, y, 0)], picture.values[picture.at(x + left, y + top, 0)]);
}

/// Threads of less than six pixels are not found, nor waves of which they are harmonics, or that single pixels of
/// smaller copies would show.
TEST(Straightening, SeesNoWavesThatAreNotThere)
{
    PngPixels threads = test::random_picture(1024, 1024, 1, 7);
    for (std::size_t i = 0; i < threads.values.size(); ++i) {
        const double thread = std::cos(2 * std::numbers::pi * static_cast<double>(i % 1024) / 4.4);
        threads.values[i] = static_cast<std::uint8_t>(128 + 90 * thread + (threads.values[i] - 128) / 8);
    }
    EXPECT_THAT(message_of<InputError>([&] { straightening_for(threads, 64); }),
                HasSubstr("its strongest wave of 6 pixels and more has"));
    EXPECT_THAT(regularity_note(threads, 64), testing::Not(HasSubstr("--straighten")));
}

TEST(Straightening, TakesNumbersOfAllKindsAlike)
{
    const PngPixels picture = planks(128, 0.05, 0.1, 16, 0);
    RawPicture bytes{128, 128, SampleType::byte, {"Y"}, picture.values}, reals{128, 128, SampleType::real, {"Y"}, {}};
    for (const std::uint8_t value : picture.values) {
        const auto real = static_cast<float>(value);
        std::array<std::uint8_t, sizeof(float)> its;
        std::memcpy(its.data(), &real, sizeof(float));
        reals.bytes.insert(reals.bytes.end(), its.begin(), its.end());
    }
    const Straightening map = straightening_for(picture, 32);
    const PngPixels made = straightened(picture, map);
    EXPECT_EQ(straightened(bytes, map).bytes, made.values);
    const RawPicture real = straightened(reals, map);
    ASSERT_EQ(real.bytes.size(), made.values.size() * sizeof(float));
    for (std::size_t i = 0; i < made.values.size(); ++i) {
        float value = 0;
        std::memcpy(&value, &real.bytes[i * sizeof(float)], sizeof(float));
        EXPECT_LE(std::abs(value - static_cast<float>(made.values[i])), 0.5F + 1e-4F);
        EXPECT_TRUE(value >= 90 && value <= 200) << value; // no more than what is around
    }
}

TEST(Straightening, SaysWhatItCannotDo)
{
    const auto message = [](const PngPixels& picture, int size) {
        return message_of<InputError>([&] { straightening_for(picture, size); });
    };
    EXPECT_THAT(message(test::random_picture(128, 128, 1, 3), 32),
                HasSubstr("straighten = true: nothing in the picture"));
    EXPECT_THAT(message(planks(256, 0, 0, 30, 0), 16), HasSubstr("size = 16: the picture repeats every 30.0 pixels"));
    EXPECT_THAT(regularity_note(planks(256, 0, 0, 20, 0), 64), HasSubstr("with --size 60"));
    EXPECT_EQ(regularity_note(planks(256, 0, 0, 16, 0), 64), "");
    const PngPixels black{128, 128, 1, std::vector<std::uint8_t>(128 * 128)},
        line{64, 1, 1, std::vector<std::uint8_t>(64)};
    EXPECT_THAT(message(black, 32), HasSubstr("has 0.0 times the power around it"));
    EXPECT_EQ(message(line, 32), "size = 32: must be at most the exemplar's, 64 x 1 pixels");
    EXPECT_EQ(message(PngPixels{600, 64, 1, std::vector<std::uint8_t>(600 * 64)}, 32),
              "straighten = true: the picture has 600 x 64 pixels: must be at most 8 times as long as wide");
    EXPECT_EQ(regularity_note(black, 64), "");
    EXPECT_THAT(regularity_note(planks(256, 0, 0, 30, 0), 16), testing::Not(HasSubstr("--straighten")));
    EXPECT_EQ(regularity_note(test::random_picture(128, 128, 1, 3), 64), "");
}

/// Distances of windows are counted in pixels: rows of one phase are 16 apart.
TEST(PhaseRule, LetsWindowsLieAWholeNumberOfPeriodsApart)
{
    PngPixels picture{160, 160, 1, {}};
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x)
            picture.values.push_back(y % 16 < 3 ? 200 : static_cast<std::uint8_t>(90 + y / 16));
    const std::vector<RegularWave> waves = fitting_waves(picture, 32);
    ASSERT_EQ(waves.size(), 1u);
    const PhaseRule rule(picture, waves, 32);
    const ExemplarWindow first = rule.nearest({40, 40, 32}, picture, 0, 0);
    ASSERT_TRUE(rule.holds(first, 0, 0));
    EXPECT_EQ(first.x, 40);
    for (int y = 0; y + 32 <= 160; ++y) {
        const auto offset = [&](double place) { return std::abs(std::remainder(y - first.y - place, 16.0)); };
        for (const double place : {0.0, 5.0, 16.0, 27.0}) {
            // The first window is itself up to a pixel away from its phase, and places of waves are nearly exact.
            if (offset(place) > 2.2) {
                EXPECT_FALSE(rule.holds({7, y, 32}, 3, place)) << y << " " << place;
            }
            if (offset(place) > 3.2) {
                EXPECT_FALSE(rule.holds({7, y, 32}, 3, place, 1)) << y << " " << place;
            }
        }
    }
    int held = 0;
    for (int y = 0; y < 112; ++y) held += rule.holds({7, y, 32}, 3, 0) ? 1 : 0;
    EXPECT_GE(held, 7 * 2);
    EXPECT_LE(held, 7 * 3);
    EXPECT_TRUE(PhaseRule().holds({1, 2, 3}, 4, 5));
}

TEST(PhaseRule, MeansAreThoseOfEqualPhases)
{
    const PngPixels picture = test::random_picture(88, 70, 3, 2);
    const PhaseMeans all(picture, {});
    for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int i = 0; i < 88 * 70; ++i) sum += picture.values[static_cast<std::size_t>(3 * i + c)];
        EXPECT_EQ(all.at(5, 6, c), sum / (88 * 70));
    }
    const PhaseMeans by_column(picture, {{0.125, 0, 0, 0}});
    for (int x = 0; x < 8; ++x) {
        double sum = 0;
        for (int y = 0; y < 70; ++y)
            for (int k = 0; k < 11; ++k) sum += picture.values[picture.at(x + 8 * k, y, 1)];
        EXPECT_NEAR(by_column.at(x + 16, 3, 1), sum / (11 * 70), 1e-9);
    }
}

/// The wall's joints are where rows and columns say, so that each pixel has to come from a row of its own phase: a
/// period is 16 rows.
TEST(JointTexture, JointsOfBricksRunThrough)
{
    const PngPixels bricks = synthetic_exemplar("bricks", 256, 1, {});
    TextureRequest request;
    request.colors = {2, 2};
    request.size = 32;
    request.joint = true;
    request.rounds = 4;
    const TextureSet set = build_texture(request, bricks, [](const std::string&, std::size_t, std::size_t) {}).set;
    std::array<int, 16> phases{};
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                ++phases[static_cast<std::size_t>(
                    (set.sources_of(tile)[static_cast<std::size_t>(32 * y + x)].y - y + 32) % 16)];
    // One pixel away from the phase on both sides at most.
    const auto most = std::ranges::max_element(phases) - phases.begin();
    int within = 0;
    for (const auto away : {-1, 0, 1}) within += phases[static_cast<std::size_t>((most + away + 16) % 16)];
    EXPECT_EQ(within, 16 * 32 * 32);
    EXPECT_GT(phases[static_cast<std::size_t>(most)], 16 * 32 * 32 * 3 / 5);
}

/// Rows of planks, eight each, on which colours differ.
PngPixels rows_of_planks(int side)
{
    PngPixels picture{side, side, 1, {}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            picture.values.push_back(y % 8 < 2 ? 200 : static_cast<std::uint8_t>(90 + y / 8 * 37 % 29 + x * x % 7));
    return picture;
}

/// The note says what helps, and goes away with it.
TEST(JointTexture, SaysWhereAPictureHasTooFewWindowsOfOnePhase)
{
    const auto notes_of = [](int side, int size) {
        TextureRequest request;
        request.colors = {2, 2};
        request.size = size;
        request.joint = true;
        request.rounds = 1;
        return build_texture(request, rows_of_planks(side), [](const std::string&, std::size_t, std::size_t) {}).notes;
    };
    const std::vector<std::string> notes = notes_of(64, 64);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0],
              "the picture repeats every 8.0 pixels, but too little of its 64 x 64 is beside a tile of 64 for "
              "2 windows that lie alike in that: joints do not run through; they do with a picture of 80 x "
              "80, or with --size 48");
    EXPECT_THAT(notes_of(80, 64), testing::IsEmpty());
    EXPECT_THAT(notes_of(64, 48), testing::IsEmpty());
}

}
}
