// Masks of samples: exact numbers, and distances by all pairs in whole numbers.
#include "host/distribution/masks/sampling_mask.hpp"

#include "base/files/whole_file.hpp"
#include "host/distribution/masks/mask_measures.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace poissonlab {
namespace {

struct MaskCase
{
    SamplingMaskSettings settings;
    std::size_t samples;
};

SamplingMaskSettings grid_of(std::uint32_t rows, std::uint32_t columns, double acceleration)
{
    SamplingMaskSettings settings;
    settings.shape = {rows, columns};
    settings.acceleration = acceleration;
    return settings;
}

std::vector<MaskCase> mask_cases()
{
    std::vector<MaskCase> cases{{grid_of(64, 48, 6), 512}, {grid_of(64, 64, 7.7), 532}, {grid_of(33, 50, 4), 413}};
    cases[0].settings.calibration = {10, 8};
    cases[1].settings.power = 0;
    cases[1].settings.has_corners = true;
    cases[2].settings.density.text = "exp(-3*(x*x+y*y))";
    cases[2].settings.calibration = {3, 5};
    return cases;
}

SamplingMask mask_of(const MaskCase& c, std::uint64_t seed = 1)
{
    const MaskField field = mask_field(c.settings);
    return sampling_mask(field, asked_samples(c.settings, field), seed);
}

TEST(SamplingMasks, HaveAsManySamplesAsAskedFor)
{
    for (const MaskCase& c : mask_cases()) {
        const SamplingMask mask = mask_of(c);
        const std::vector<std::uint8_t> pixels = mask.pixels();
        EXPECT_EQ(std::ranges::count(pixels, 1), static_cast<std::ptrdiff_t>(c.samples));
        EXPECT_EQ(std::set(mask.samples.begin(), mask.samples.end()).size(), c.samples);
    }
}

/// Whole numbers of 128 bits; the costs are those of the field.
TEST(SamplingMasks, KeepDistancesOfAllPairs)
{
    __extension__ using Wide = __int128;
    for (const MaskCase& c : mask_cases()) {
        const MaskField field = mask_field(c.settings);
        const SamplingMask mask = mask_of(c);
        ASSERT_GT(mask.scale, 0U);
        const auto is_always = [&](std::uint32_t p) {
            return std::ranges::find(field.always, p) != field.always.end();
        };
        double least_part = INFINITY;
        for (const std::uint32_t p : mask.samples)
            for (const std::uint32_t q : mask.samples) {
                if (p >= q || (is_always(p) && is_always(q))) continue;
                const std::int64_t y = p / mask.columns, x = p % mask.columns, v = q / mask.columns,
                                   u = q % mask.columns;
                const auto squared = static_cast<std::uint64_t>((x - u) * (x - u) + (y - v) * (y - v));
                const std::uint64_t cost = std::max(field.costs[p], field.costs[q]);
                const Wide asked = static_cast<Wide>(mask.scale) * cost + mask.offset(p) + mask.offset(q);
                EXPECT_GE(static_cast<Wide>(squared) << 32, asked);
                EXPECT_LE(std::abs(mask.offset(p)), most_offset);
                if (asked > 0)
                    least_part = std::min(
                        least_part, std::sqrt(static_cast<double>(squared) / (static_cast<double>(asked) * 0x1p-32)));
            }
        EXPECT_NEAR(mask_distances(field, mask).least_part, least_part, 1e-9);
        EXPECT_LT(least_part, 1.2); // and no larger scale would do
        EXPECT_EQ(mask.offsets.empty(), c.settings.power == 0);
    }
}

/// Where all pixels are samples no distance is asked for, nor where costs are 0: no part of one is told.
TEST(SamplingMasks, TellNoPartOfADistanceThatIsNotAskedFor)
{
    for (const std::array<std::uint32_t, 2> shape :
         {std::array<std::uint32_t, 2>{33, 47}, {8, 8}, {5, 40}, {1, 320}, {40, 1}})
        for (const double acceleration : {1.0, 1.02, 1.3, 2.0, 4.0})
            for (const double power : {0.0, 0.5, 1.0, 4.0, 12.0}) {
                SamplingMaskSettings settings;
                settings.shape = shape;
                settings.acceleration = acceleration;
                settings.power = power;
                settings.has_corners = true;
                const MaskField field = mask_field(settings);
                const SamplingMask mask = sampling_mask(field, asked_samples(settings, field), 3);
                EXPECT_GE(mask_distances(field, mask).least_part, 1) << acceleration << " " << power;
                if (mask.scale == 0) {
                    EXPECT_EQ(mask_distances(field, mask).least_part, INFINITY);
                }
            }
}

TEST(SamplingMasks, TakeTheCalibrationAreaAndNoCorners)
{
    const MaskCase c = mask_cases()[0];
    const std::vector<std::uint8_t> pixels = mask_of(c).pixels();
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 48; ++column) {
            const bool is_sample = pixels[static_cast<std::size_t>(row * 48 + column)] == 1;
            const bool is_calibration = row >= 27 && row < 37 && column >= 20 && column < 28;
            const double y = (row - 32) / 32.0, x = (column - 24) / 24.0;
            EXPECT_TRUE(is_sample || !is_calibration) << row << ", " << column;
            EXPECT_TRUE(!is_sample || x * x + y * y < 1) << row << ", " << column;
        }
}

/// The number of samples in rings over that of pixels is as the density, where that asks for far fewer than all.
TEST(SamplingMasks, FollowTheirDensity)
{
    SamplingMaskSettings settings = grid_of(256, 256, 20);
    settings.power = 2;
    const std::vector<std::uint8_t> pixels = mask_of({settings, 0}).pixels();
    std::array<double, 2> samples{}, all{};
    for (int row = 0; row < 256; ++row)
        for (int column = 0; column < 256; ++column) {
            const double r = std::hypot(row - 128, column - 128) / 128;
            const int ring = r >= 0.4 && r < 0.5 ? 0 : r >= 0.8 && r < 1 ? 1 : -1;
            if (ring < 0) continue;
            samples[static_cast<std::size_t>(ring)] += pixels[static_cast<std::size_t>(row * 256 + column)];
            all[static_cast<std::size_t>(ring)] += 1;
        }
    // Means of r^-2 over the rings: 2 log(b / a) / (b^2 - a^2).
    const double expected = std::log(0.5 / 0.4) / (0.25 - 0.16) / (std::log(1 / 0.8) / (1 - 0.64));
    EXPECT_NEAR(samples[0] / all[0] / (samples[1] / all[1]) / expected, 1, 0.15);
}

TEST(SamplingMasks, AreOthersForOtherSeeds)
{
    const MaskCase c = mask_cases()[1];
    EXPECT_EQ(mask_of(c, 4).samples, mask_of(c, 4).samples);
    EXPECT_NE(mask_of(c, 4).samples, mask_of(c, 5).samples);
}

TEST(SamplingMasks, SayWhatCannotBe)
{
    const auto message = [](SamplingMaskSettings settings) {
        const MaskField field = mask_field(settings);
        return message_of([&] { asked_samples(settings, field); });
    };
    EXPECT_THAT(message(grid_of(64, 64, 1)),
                testing::HasSubstr("these are 4096 samples, but only 3205 of 4096 pixels"));
    SamplingMaskSettings few = grid_of(64, 64, 20);
    few.calibration = {32, 32};
    EXPECT_THAT(message(few),
                testing::HasSubstr("the calibration area alone has 1024: an acceleration of at most 4.0000"));
}

TEST(MaskFiles, AreThoseOfBart)
{
    const TemporaryFolder folder;
    const SamplingMask mask{2, 3, {1, 5}, 1, {}}; // 0 1 0 / 0 0 1
    write_mask(folder.path() / "a.cfl", mask);
    write_mask(folder.path() / "a.npy", mask);
    EXPECT_EQ(read_whole_file(folder.path() / "a.hdr"), "# Dimensions\n1 2 3 1 1 1 1 1 1 1 1 1 1 1 1 1\n");
    const std::string bytes = read_whole_file(folder.path() / "a.cfl");
    ASSERT_EQ(bytes.size(), 48U);
    std::array<float, 12> values{};
    std::memcpy(values.data(), bytes.data(), bytes.size());
    EXPECT_EQ(values, (std::array<float, 12>{0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0})); // columns one after the other
    const std::string npy = read_whole_file(folder.path() / "a.npy");
    EXPECT_EQ(npy.substr(npy.size() - 6), std::string("\0\1\0\0\0\1", 6));
}

}
}
