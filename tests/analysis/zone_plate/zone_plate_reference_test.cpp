#include "analysis/zone_plate/zone_plate_reference.hpp"

#include "analysis/zone_plate/reconstruction.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <map>

namespace poissonlab {
namespace {

using namespace test;

/// The mean of exp(i x^2) weighted by the filter, by Simpson's rule in long double on a grid that has all
/// knots.
std::complex<long double> wave_by_simpson(int index, int size)
{
    constexpr int steps = 1 << 16; // a pixel
    const long double centre = index + 0.5L, pixel = 48.0L / size;
    const long double low = std::max(centre - 2, 0.0L);
    const auto count = static_cast<int>((std::min(centre + 2, static_cast<long double>(size)) - low) * steps);
    std::complex<long double> sum = 0;
    long double weights = 0;
    for (int k = 0; k <= count; ++k) {
        const long double u = low + static_cast<long double>(k) / steps, x = u * pixel;
        const long double weight = (k == 0 || k == count ? 1
                                    : k % 2 == 1         ? 4
                                                         : 2) *
                                   static_cast<long double>(mitchell_weight(static_cast<double>(std::abs(u - centre))));
        sum += weight * std::polar(1.0L, x * x);
        weights += weight;
    }
    return sum / weights;
}

TEST(ZonePlateReference, AgreesWithSimpsonsRule)
{
    for (const int size : {512, 100, 16}) {
        const auto image = zone_plate_reference(size);
        ASSERT_EQ(image.pixels.size(), static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
        std::map<int, std::complex<long double>> waves; // along one axis, of some pixels
        for (const int index : {0, 1, size / 3, size - 2, size - 1}) waves[index] = wave_by_simpson(index, size);
        for (const auto& [row, wave_of_row] : waves)
            for (const auto& [column, wave_of_column] : waves) {
                const auto wave = wave_of_row * wave_of_column;
                // Simpson's error: (step size)^4 / 180 times the fourth derivative, at most (2 x)^4 x 2.
                const double step = 48.0 / size / 65536;
                const double simpson = std::pow(96 * step, 4) / 90;
                EXPECT_NEAR(image.at(column, row), 0.5 + 0.5 * static_cast<double>(wave.imag()), 2e-12 + simpson)
                    << size << ": " << column << ", " << row;
            }
    }
}

TEST(ZonePlateReference, AgreesWithStratifiedSamples)
{
    // The dissertation's own way, with a quarter of its million samples a pixel: at pixels in the middle, at
    // the border and in the corner.
    const int size = 512, strata = 2000; // along the four pixels of the support
    const auto image = zone_plate_reference(size);
    std::mt19937_64 random(1);
    for (const auto& [column, row] : {std::pair{0, 0}, {200, 131}, {510, 20}}) {
        double weights = 0, sum = 0;
        for (int j = 0; j < strata; ++j)
            for (int i = 0; i < strata; ++i) {
                const double u = (i + uniform_32(random)) * 4 / strata - 2;
                const double v = (j + uniform_32(random)) * 4 / strata - 2;
                const double x = 48 * (column + 0.5 + u) / size, y = 48 * (row + 0.5 + v) / size;
                if (x < 0 || x >= 48 || y < 0 || y >= 48) continue;
                const double weight = mitchell_weight(std::abs(u)) * mitchell_weight(std::abs(v));
                weights += weight;
                sum += weight * zone_plate(x, y);
            }
        // A stratum is d = 4 / strata pixels wide. Over it, weight times function, whose gradient is below 6
        // a pixel, has a standard deviation below 6 d / sqrt 6, and d^2 times that enters the mean, once for
        // each of strata^2; at the corners the weights sum to no less than 1/4. Five times that.
        const double d = 4.0 / strata;
        EXPECT_NEAR(image.at(column, row), sum / weights, 5 * 4 * d * d * d * strata * 6 / std::sqrt(6.0))
            << column << ", " << row;
    }
}

TEST(ZonePlateReference, IsSymmetricAndFadesToGrey)
{
    const auto image = zone_plate_reference(512);
    for (int row = 0; row < 512; row += 7)
        for (int column = 0; column < row; column += 5) ASSERT_EQ(image.at(column, row), image.at(row, column));
    EXPECT_GT(image.at(13, 0), 0.95);
    // At 1.4 cycles per pixel the filter lets nearly nothing through.
    for (int i = 330; i < 360; ++i) EXPECT_NEAR(image.at(i, i), 0.5, 0.02);
}

TEST(ZonePlateReference, OfOnePixelIsTheMeanOfThePlate) { EXPECT_NEAR(zone_plate_reference(1).at(0, 0), 0.5, 0.01); }

}
}
