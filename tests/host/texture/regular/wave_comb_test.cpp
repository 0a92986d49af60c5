// Planks with thin lines, whose power is in many weak harmonics, are found and straightened; pictures without a period
// are refused.
#include "host/texture/exemplar.hpp"
#include "host/texture/regular/straightening.hpp"
#include "host/texture/regular/wave_comb.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

constexpr int side = 512;

/// Boards of one width, or of any from 20 to 60 pixels, which differ in lightness, with grain along them and noise, and
/// dark lines between them.
struct Boards
{
    double period = 40;
    double first = 0; ///< the place of a line, in periods
    double turn = 0;
    double line_width = 2;
    double contrast = 40;
    double noise = 10;
    bool has_period = true;

    /// Returns the phase, which is a whole number in the middles of lines.
    double phase(double x, double y) const { return (x * std::sin(turn) + y * std::cos(turn)) / period + first; }
};

PngPixels drawn(const Boards& boards, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> lightness(200), lines{-20};
    for (double& light : lightness) light = 0.5 * boards.noise * normal(random);
    while (lines.back() < 2 * side) lines.push_back(lines.back() + 20 + static_cast<double>(random() % 41));
    PngPixels picture{side, side, 1, {}};
    for (int y = 0; y < side; ++y) {
        double grain = 0;
        for (int x = 0; x < side; ++x) {
            const double phase = boards.phase(x, y);
            double away = std::abs(phase - std::round(phase)) * boards.period;
            auto board = static_cast<std::size_t>(std::floor(phase) + 100);
            if (!boards.has_period) {
                board = static_cast<std::size_t>(std::ranges::upper_bound(lines, y) - lines.begin());
                away = std::min(y - lines[board - 1], lines[board] - y);
            }
            grain = 0.97 * grain + 0.5 * boards.noise * std::sqrt(1 - 0.97 * 0.97) * normal(random);
            const double cover = std::clamp(boards.line_width / 2 + 0.5 - away, 0.0, 1.0);
            const double value = 128 + lightness[board] + grain + boards.noise * normal(random);
            picture.values.push_back(
                static_cast<std::uint8_t>(std::clamp(std::lround(value - boards.contrast * cover), 0L, 255L)));
        }
    }
    return picture;
}

Boards random_boards(unsigned seed)
{
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    Boards boards;
    boards.period = uniform(20, 60);
    boards.first = uniform(0, 1);
    boards.turn = uniform(-0.05, 0.05);
    return boards;
}

/// Returns the largest distance in pixels of lines from their places at whole numbers of periods over tiles of the
/// straightened picture.
double largest_offset(const Straightening& map, const Boards& boards, int size)
{
    const auto phase = [&](double x, double y) {
        const auto& m = map.to_source;
        const double w = m[6] * x + m[7] * y + m[8];
        return boards.phase((m[0] * x + m[1] * y + m[2]) / w, (m[3] * x + m[4] * y + m[5]) / w);
    };
    const double middle = phase(map.width / 2.0, map.height / 2.0);
    const auto whole = [&](double dx, double dy) {
        return std::round(phase(map.width / 2.0 + dx, map.height / 2.0 + dy) - middle) / size;
    };
    const double east = whole(size, 0), south = whole(0, size);
    double most = 0;
    for (int y = 0; y < map.height; y += 8)
        for (int x = 0; x < map.width; x += 8)
            most = std::max(
                most, std::abs(phase(x, y) - middle - east * (x - map.width / 2.0) - south * (y - map.height / 2.0)));
    return most * boards.period;
}

RegularWave known_wave(const Boards& boards)
{
    return {std::sin(boards.turn) / boards.period, std::cos(boards.turn) / boards.period, 0, 0};
}

/// Lines have one to three pixels and are four times as dark as the noise.
TEST(WaveComb, FindsThinLines)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
        for (const double line_width : {1, 2, 3}) {
            Boards boards = random_boards(seed);
            boards.line_width = line_width;
            boards.noise = seed % 2 == 0 ? 4 : 12;
            boards.contrast = 4 * boards.noise;
            SCOPED_TRACE(testing::Message() << seed << ": " << line_width << " of " << boards.period);
            const auto waves = regular_waves(lightness_map(drawn(boards, seed)));
            ASSERT_EQ(waves.size(), 1u);
            const RegularWave known = known_wave(boards);
            const double sign = waves[0].x * known.x + waves[0].y * known.y > 0 ? 1 : -1;
            const double away = std::hypot(sign * waves[0].x - known.x, sign * waves[0].y - known.y);
            EXPECT_LT(away * side / 2 * boards.period, 1) << "pixels at the rim";
        }
}

TEST(Straightening, PutsThinLinesWhereTilesHaveThem)
{
    for (unsigned seed = 1; seed <= 4; ++seed) {
        Boards boards = random_boards(seed);
        boards.line_width = 1 + seed % 3;
        boards.contrast = 40;
        SCOPED_TRACE(testing::Message() << seed << ": " << boards.line_width << " of " << boards.period);
        const Straightening map = straightening_for(drawn(boards, seed), 64);
        ASSERT_EQ(map.periods.size(), 1u);
        EXPECT_NEAR(map.periods[0] / map.scale, boards.period, 0.02 * boards.period);
        EXPECT_LT(largest_offset(map, boards, 64), most_crest_offset);
    }
}

/// Boards of all widths have lines, but no period, and more than one part of their line of the spectrum is many times
/// what is around it; noise and grain without lines have none.
TEST(WaveComb, FindsNoneWithoutAPeriod)
{
    for (unsigned seed = 1; seed <= 30; ++seed) {
        Boards boards = random_boards(seed);
        boards.line_width = 1 + seed % 3;
        boards.has_period = false;
        boards.contrast = seed % 4 > 0 ? 40 : 0;
        EXPECT_TRUE(regular_waves(lightness_map(drawn(boards, seed))).empty()) << seed;
    }
    for (const char* name :
         {"gravel", "cork", "sand", "grass", "turf", "leaves", "granite", "pebbles", "stones", "clouds"}) {
        const PngPixels picture = read_exemplar(source_folder() + "/configs/exemplars/" + name + ".png");
        EXPECT_FALSE(stands_out_together(strongest_comb(WaveSpectrum(windowed(lightness_map(picture)))))) << name;
    }
}

TEST(Straightening, RefusesBoardsWithoutAPeriod)
{
    Boards boards = random_boards(1);
    boards.has_period = false;
    EXPECT_THAT(message_of<InputError>([&] { straightening_for(drawn(boards, 1), 64); }),
                testing::HasSubstr("and no harmonics stand out together"));
}

}
}
