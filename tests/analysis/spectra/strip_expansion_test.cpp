#include "analysis/spectra/strip_expansion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

TEST(StripExpansion, TermsAreEnoughAndNotFarTooMany)
{
    // The bound is met with R terms and missed with R - 1, by the factorial's own definition (lgamma).
    for (const int strips : {4, 16, 64, 1024}) {
        for (const int frequency : {1, 8, 64, 512, 2048}) {
            const int terms = expansion_terms(strips, frequency);
            const double half_z = 0.5 * std::numbers::pi * frequency / strips;
            const auto log_rest = [&](int r) {
                return std::log(2.0) + r * std::log(half_z) - std::lgamma(r + 1.0) - std::log1p(-half_z / (r + 1));
            };
            EXPECT_LT(log_rest(terms), std::log(0x1p-53) + 1e-9);
            if (half_z < terms) {
                EXPECT_GE(log_rest(terms - 1), std::log(0x1p-53) - 1e-9);
            }
        }
    }
}

TEST(StripExpansion, FoldedMomentsGiveThePhasesOfAPoint)
{
    // One point in each strip in turn, so that the moments are T_r(t): cos and sin of 2 pi v y come back.
    const int max_frequency = 40;
    const StripExpansion expansion{16, expansion_terms(16, max_frequency)};
    const auto table = strip_coefficients(expansion, max_frequency);
    const auto terms = static_cast<std::size_t>(expansion.terms);
    for (int strip = 0; strip < expansion.strips; ++strip) {
        const double t = -1.0 + 2.0 * (strip + 0.25) / expansion.strips; // somewhere else in every strip
        const double y = (strip + 0.5 * (1.0 + t)) / expansion.strips;
        std::vector<double> moments(terms), nothing(terms);
        for (std::size_t r = 0; r < terms; ++r) moments[r] = std::cos(static_cast<double>(r) * std::acos(t));

        for (int v = 0; v <= max_frequency; ++v) {
            double cosine = 0.0, sine = 0.0;
            for (int k = 0; k < expansion.strips / 4; ++k) {
                std::array<const double*, 4> four;
                for (std::size_t i = 0; i < 4; ++i) {
                    four[i] = folded_strips(expansion, k)[i] == strip ? moments.data() : nothing.data();
                }
                std::vector<double> folded_cosine(terms), folded_sine(terms);
                fold(four, expansion.terms, 1, v % 2 == 1, folded_cosine.data(), folded_sine.data());
                const std::size_t row = static_cast<std::size_t>(v / 2) * expansion.folded_moments() + k * terms;
                for (std::size_t r = 0; r < terms; ++r) {
                    cosine += table.cosine[v % 2][row + r] * folded_cosine[r];
                    sine += table.sine[v % 2][row + r] * folded_sine[r];
                }
            }
            // At most 40 products below 1, each with a few roundings: 40 * 4 * 2^-53 = 1.8e-14; the reference
            // phase 2 pi v y <= 252 is rounded to 2^-46 = 1.4e-14 once more.
            EXPECT_NEAR(cosine, std::cos(2.0 * std::numbers::pi * v * y), 4e-14) << strip << " " << v;
            EXPECT_NEAR(sine, std::sin(2.0 * std::numbers::pi * v * y), 4e-14) << strip << " " << v;
        }
    }
}

}
}
