// The picture of a spectrum: where frequencies lie, and what becomes of DC and of single spikes.
#include "reports/images/spectrum_image.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace poissonlab {
namespace {

/// Power 1 everywhere but at DC and at one frequency.
Spectrum with_spike(int size, int fx, int fy, double power)
{
    Spectrum spectrum;
    spectrum.size = size;
    spectrum.power.assign(static_cast<std::size_t>(size * size), 1.0);
    const auto index = [&](int x, int y) { return static_cast<std::size_t>((y + size / 2) * size + x + size / 2); };
    spectrum.power[index(0, 0)] = 256;
    spectrum.power[index(fx, fy)] = power;
    return spectrum;
}

TEST(SpectrumImage, FrequenciesGrowRightAndUp)
{
    auto image = draw_spectrum(with_spike(16, 3, 5, 10), report_tone_mapping);
    EXPECT_EQ(image.width, 16);
    EXPECT_EQ(image.at(8 + 3, 7 - 5), 255);
    EXPECT_EQ(image.at(0, 0), report_tone_mapping.grey(1));
}

TEST(SpectrumImage, LeavesOutDc)
{
    auto image = draw_spectrum(with_spike(16, 3, 5, 10), report_tone_mapping);
    EXPECT_EQ(image.at(8, 7), 0);
}

TEST(SpectrumImage, SmallPicturesShowMeanPower)
{
    auto image = draw_spectrum(with_spike(16, 2, 4, 13), report_tone_mapping, 2);
    EXPECT_EQ(image.width, 8);
    EXPECT_EQ(image.at(4 + 1, 3 - 2), report_tone_mapping.grey((13 + 3) / 4.0));
    // DC's neighbours are white noise, and DC does not count.
    EXPECT_EQ(image.at(4, 3), report_tone_mapping.grey(1));
}

TEST(SpectrumImage, SmallPicturesKeepSpikes)
{
    for (const int block : {1, 2, 4, 8}) {
        auto image = draw_spectrum(with_spike(16, 2, 4, 40), report_tone_mapping, block);
        EXPECT_EQ(image.at((8 + 2) / block, 16 / block - 1 - (8 + 4) / block), 255) << block;
    }
    EXPECT_LT(report_tone_mapping.grey(40 / 64.0 + 1), 255) << "the mean would hide it";
}

TEST(SpectrumImage, SpikesAreTheseOfTheirRing)
{
    // Powers of 0.1, where 10 is a spike, and of 1.5, where 28 is none.
    for (const auto& [around, power, is_spike] : {std::tuple{0.1, 10.0, true}, {1.5, 28.0, false}}) {
        Spectrum spectrum = with_spike(16, 2, 4, power / around);
        for (double& value : spectrum.power) value *= around;
        const auto pixel = draw_spectrum(spectrum, report_tone_mapping, 8).at(1, 0);
        EXPECT_EQ(pixel, report_tone_mapping.grey(is_spike ? power : (62 * around + power) / 63)) << around;
    }
}

TEST(SpectrumImage, PagesShowAtMost512Pixels)
{
    EXPECT_EQ(page_block(64), 1);
    EXPECT_EQ(page_block(512), 1);
    EXPECT_EQ(page_block(1024), 2);
    EXPECT_EQ(page_block(4096), 8);
    EXPECT_EQ(page_block(1026), 2); // no further power of two divides it
}

}
}
