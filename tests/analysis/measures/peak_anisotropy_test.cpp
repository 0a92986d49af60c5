#include "analysis/measures/peak_anisotropy.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

TEST(PeakAnisotropy, IsTheLargestOfRingsWithEnoughSamples)
{
    const std::vector<RadialBin> radial = {{15, 1, 3.0, 96, 0},
                                           {16, 1, -9.0, 100, 0},
                                           {17, 1, -4.0, 108, 0},
                                           {18, 1, -4.0, 112, 0},
                                           {19, 1, -8.0, 120, 0}};
    const auto peak = peak_anisotropy(radial, 10);
    ASSERT_TRUE(peak);
    EXPECT_EQ(peak->db, -4);
    EXPECT_EQ(peak->frequency, 17) << "the first of several";
    EXPECT_EQ(peak->samples, 108U);
    EXPECT_EQ(peak->standard_error_db, anisotropy_standard_error_db(108, 10));
    EXPECT_FALSE(peak_anisotropy(radial, 1)->standard_error_db);
    EXPECT_FALSE(peak_anisotropy({radial[0]}, 10));
    EXPECT_FALSE(peak_anisotropy({}, 10));
}

TEST(PeakAnisotropy, ErrorIsTheSpreadOfRingsOfChance)
{
    // 5,000 independent powers in a ring: terms beyond the delta method are of the order 1/5,000. A variance over 2,000
    // rings has the relative standard error sqrt(2 / 2,000).
    constexpr int rings = 2000, independent = 5000;
    std::mt19937_64 random(7);
    for (const int realizations : {1, 4, 10}) {
        std::gamma_distribution<double> gamma(realizations, 1.0 / realizations);
        double sum = 0, squares = 0;
        for (int ring = 0; ring < rings; ++ring) {
            double powers = 0, squared = 0;
            for (int i = 0; i < independent; ++i) {
                const double power = gamma(random);
                powers += power / independent;
                squared += power * power / independent;
            }
            const double db = 10 * std::log10((squared - powers * powers) / (powers * powers));
            sum += db / rings;
            squares += db * db / rings;
        }
        const double expected = anisotropy_standard_error_db(2 * independent, realizations);
        EXPECT_NEAR((squares - sum * sum) / (expected * expected), 1, 4 * std::sqrt(2.0 / rings) + 0.01)
            << realizations;
    }
}

}
}
