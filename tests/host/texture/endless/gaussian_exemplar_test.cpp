// Gaussian exemplars: the normal distribution against the C library's, ranks, ways back, and colours of noise that are
// those of its exemplar.
#include "host/texture/endless/gaussian_exemplar.hpp"

#include "host/texture/endless/endless_texture.hpp"
#include "tests/host/texture/random_picture.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace poissonlab {
namespace {

using namespace contract::endless_texture;

TEST(NormalDistribution, IsTheLibrarys)
{
    for (double x = -8; x <= 8; x += 0.0625) {
        const double expected = std::erfc(-x / std::sqrt(2.0)) / 2;
        EXPECT_NEAR(normal_probability(x), expected, 1e-13 + (x < -3 ? -1e-13 + 1e-10 * expected : 0)) << x;
    }
}

/// Ranks are symmetric, so the mean is 0 to the last bit; the variance of quantiles falls short of 1 by what is beyond
/// the last of them, less than 4 ln N / N, and rounding adds a twelfth of a squared step.
TEST(GaussianExemplar, HasTheMeanAndTheVariance)
{
    const GaussianExemplar gaussian = gaussian_exemplar(test::random_picture(100, 80, 3, 1));
    for (std::size_t k = 0; k < 3; ++k) {
        std::int64_t sum = 0, squares = 0;
        for (std::size_t i = k; i < gaussian.numbers.size(); i += 3) {
            const std::int64_t number = gaussian.numbers[i] - GAUSSIAN_ZERO;
            sum += number;
            squares += number * number;
        }
        EXPECT_EQ(sum, 0);
        const double variance = static_cast<double>(squares) / 8000 / (GAUSSIAN_STEPS * GAUSSIAN_STEPS);
        EXPECT_LT(variance, 1);
        EXPECT_GT(variance, 1 - 4 * std::log(8000) / 8000);
    }
}

/// Larger values have larger numbers, equal ones are told apart by their neighbourhoods, and tables lead back to what a
/// value was, within a 128th of a standard deviation.
TEST(GaussianExemplar, LeadsBack)
{
    const PngPixels exemplar = test::random_picture(60, 50, 1, 2, 40);
    const GaussianExemplar gaussian = gaussian_exemplar(exemplar);
    for (std::size_t i = 0; i < exemplar.values.size(); i += 7)
        for (std::size_t j = 0; j < exemplar.values.size(); j += 11)
            if (exemplar.values[i] < exemplar.values[j]) {
                EXPECT_LT(gaussian.numbers[i], gaussian.numbers[j]);
            }
    // Entries are at the middles of their numbers: only values beside a jump may come back as their neighbours.
    int different = 0;
    for (std::size_t i = 0; i < exemplar.values.size(); ++i) {
        const float back = gaussian.inverse[static_cast<std::size_t>(gaussian.numbers[i] / 32)] + gaussian.means[0];
        EXPECT_NEAR(back, exemplar.values[i], 1.01);
        different += std::abs(back - exemplar.values[i]) > 0.5f ? 1 : 0;
    }
    // 39 jumps, each within half an entry of numbers: of 3,000 values about 3000 / 128 / 2 x 0.4 at most.
    EXPECT_LT(different, 39 * 5);
}

/// Colours along a line have it for their first axis, and axes are a rotation.
TEST(GaussianExemplar, FindsThePrincipalAxes)
{
    PngPixels exemplar{40, 40, 3, {}};
    for (const std::uint8_t value : test::random_picture(40, 40, 1, 5, 80).values)
        for (const int part : {3, 2, 1}) exemplar.values.push_back(static_cast<std::uint8_t>(part * value));
    const GaussianExemplar gaussian = gaussian_exemplar(exemplar);
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        double along = 0;
        for (std::size_t c = 0; c < 3; ++c) along += gaussian.axes[3 * k + c] * (3.0 - static_cast<double>(c));
        most = std::max(most, std::abs(along) / std::sqrt(14.0));
        for (std::size_t other = 0; other < 3; ++other) {
            double product = 0;
            for (std::size_t c = 0; c < 3; ++c) product += gaussian.axes[3 * k + c] * gaussian.axes[3 * other + c];
            EXPECT_NEAR(product, k == other ? 1 : 0, 6.0 / 16'384) << "axes are rounded to 16,384ths";
        }
    }
    EXPECT_NEAR(most, 1, 1e-4);
}

/// The largest difference of the cumulative distributions of two pictures' values.
double largest_difference(const PngPixels& one, const PngPixels& other)
{
    double largest = 0;
    for (int level = 0; level < 256; ++level) {
        const auto share = [&](const PngPixels& picture) {
            return static_cast<double>(std::ranges::count_if(picture.values, [&](int v) { return v <= level; })) /
                   static_cast<double>(picture.values.size());
        };
        largest = std::max(largest, std::abs(share(one) - share(other)));
    }
    return largest;
}

/// Kolmogorov and Smirnov: of 40,000 independent values the distribution is missed by 1.95 / 200 once in a thousand
/// times; tables add half an entry at the middle, 0.4 / 256. Linear blending, which takes variance, is far off.
TEST(ByExampleNoise, HasTheHistogramOfItsExemplar)
{
    PngPixels exemplar = test::random_picture(160, 150, 1, 8);
    for (std::uint8_t& value : exemplar.values) value = static_cast<std::uint8_t>(value * value / 255); // not even
    EndlessRequest request;
    request.method = EndlessMethod::blended;
    const PixelWindow window{0, 0, 200, 200};
    EXPECT_LT(largest_difference(reference_endless_window(endless_texture(request, exemplar), window), exemplar),
              1.95 / 200 + 0.4 / 256);
    request.method = EndlessMethod::hexagons;
    request.exponent = 1;
    request.falloff = 0;
    EXPECT_GT(largest_difference(reference_endless_window(endless_texture(request, exemplar), window), exemplar), 0.05);
}

}
}
