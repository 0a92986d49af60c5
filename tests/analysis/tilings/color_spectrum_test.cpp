// The power spectrum of one colour against closed forms.
#include "analysis/tilings/color_statistics.hpp"

#include "base/random/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace poissonlab {
namespace {

ColorField philox_field(std::size_t size, std::uint32_t colors)
{
    ColorField field{colors, size, {}};
    for (std::uint32_t i = 0; field.values.size() < size * size; ++i)
        field.values.push_back(
            static_cast<std::uint8_t>(std::uint64_t{philox({i, 0, 0, 0}, {1, 2})[0]} * colors >> 32));
    return field;
}

TEST(ColorSpectrum, IsThatOfTheDefinition)
{
    const ColorField field = philox_field(10, 3);
    const ColorSpectrum spectrum = color_spectrum(field, 1);
    const double p = static_cast<double>(spectrum.count) / 100;
    for (int v = -5; v < 5; ++v)
        for (int u = -5; u < 5; ++u) {
            std::complex<double> sum = 0;
            for (int y = 0; y < 10; ++y)
                for (int x = 0; x < 10; ++x)
                    if (field.values[static_cast<std::size_t>(10 * y + x)] == 1)
                        sum += std::polar(1.0, -2 * std::numbers::pi * (u * x + v * y) / 10);
            const double expected = u == 0 && v == 0 ? 0 : std::norm(sum) / (100 * p * (1 - p));
            EXPECT_NEAR(spectrum.power[static_cast<std::size_t>(10 * (v + 5) + u + 5)], expected, 1e-12);
        }
}

TEST(ColorSpectrum, HasTheMeanOneAndTheShareOfChance)
{
    const ColorSpectrum spectrum = color_spectrum(philox_field(256, 4), 2);
    const double mean = std::accumulate(spectrum.power.begin(), spectrum.power.end(), 0.0) / (256 * 256);
    EXPECT_NEAR(mean, 1, 1e-12); // Parseval
    // Powers come in pairs of opposite frequencies. The 33 pairs at the top of an exponential distribution have values
    // of standard deviation 1 above a threshold of standard deviation 1 / sqrt(33): their sum has sqrt(8 * 33). Four of
    // these.
    EXPECT_NEAR(spectrum.strongest(0.001), 66.0 / 65536 * (1 - std::log(66.0 / 65536)),
                4 * std::sqrt(8.0 * 33) / 65536);
}

TEST(ColorSpectrum, OfACheckerboardIsOnePeak)
{
    ColorField field{2, 16, {}};
    for (std::size_t i = 0; i < 256; ++i) field.values.push_back((i / 16 + i) % 2);
    const ColorSpectrum spectrum = color_spectrum(field, 0);
    EXPECT_NEAR(spectrum.peak(), 256, 1e-9);
    EXPECT_NEAR(spectrum.power[0], 256, 1e-9); // the highest frequency along both axes
    EXPECT_NEAR(spectrum.strongest(0.001), 1, 1e-12);
}

TEST(ColorSpectrum, RefusesWhatHasNone)
{
    EXPECT_THROW(color_spectrum({2, 4, std::vector<std::uint8_t>(8)}, 0), std::invalid_argument);
    EXPECT_THROW(color_spectrum({2, 4, std::vector<std::uint8_t>(16)}, 0), std::invalid_argument);
    EXPECT_THROW(color_spectrum({2, 4, std::vector<std::uint8_t>(16)}, 1), std::invalid_argument);
}

}
}
