// Tapers of regions against sine tapers by numpy, Bessel's zeros, and integrals by plain sums.
#include "analysis/regions/region_tapers.hpp"

#include "analysis/regions/random_in_region.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

std::shared_ptr<const FramedRegion> framed_text(const std::string& text)
{
    return std::make_shared<const FramedRegion>(read_region(text), "region");
}

constexpr const char* plate = "rectangle 0 0 4 1";
constexpr const char* bent = "POLYGON ((0 0, 3 0, 3 1, 1 1, 1 3, 0 3, 0 0))";

struct NumpyTaper
{
    double eigenvalue;
    std::array<double, 6> powers;
};

/// The first four sine tapers of `plate`, on 128 x 32 cells, by numpy: eigenvalues of linear elements in closed form,
/// powers by plain sums over points and Gauss's rule of twelve places in each cell.
constexpr std::array<NumpyTaper, 4> numpy_tapers{
    {{41.977661435, {0.140337704359, 0.151049961426, 0.815760467379, 1.5274892165, 1.81611620512, 3.05908651992}},
     {49.3817228234, {0.0262088830086, 0.191417271796, 0.6831657055, 0.779059713257, 1.40659432991, 0.237612431204}},
     {61.7267810119, {0.00979946436922, 0.568171130363, 0.858661267932, 1.13757116145, 0.874775082857, 0.923720660308}},
     {79.0202729403,
      {0.122082959204, 0.0879510030541, 0.000428043977181, 0.969601684152, 0.562827745314, 0.066734360358}}}};
constexpr std::array<std::array<int, 2>, 6> numpy_frequencies{{{0, 1}, {1, 0}, {1, -1}, {2, 3}, {5, -4}, {8, 7}}};
const PointSet ten{2, {0.31, 0.22, 1.05, 0.71, 1.9,  0.4,  2.2,  0.13, 2.75, 0.88,
                       3.3,  0.5,  3.61, 0.07, 0.93, 0.33, 1.47, 0.95, 2.5,  0.52}};

TEST(RegionTapers, OfARectangleAreThoseOfNumpy)
{
    const auto region = framed_text(plate);
    const auto tapers = std::make_shared<const RegionTapers>(*region, 4);
    TaperedPeriodogram exact(region, tapers, 16, true), fast(region, tapers, 16, false);
    const PointSet points = region->framed(ten, "ten");
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(tapers->eigenvalue(k), numpy_tapers[k].eigenvalue, 1e-8 * numpy_tapers[k].eigenvalue);
        HalfSpectrum a, b;
        exact.compute(points, k, a);
        fast.compute(points, k, b);
        for (std::size_t i = 0; i < numpy_frequencies.size(); ++i) {
            const auto [u, v] = numpy_frequencies[i];
            const std::size_t at = static_cast<std::size_t>(u) * 17 + static_cast<std::size_t>(v + 8);
            EXPECT_NEAR(a.power[at], numpy_tapers[k].powers[i], 1e-7) << k << ": " << u << ", " << v;
            EXPECT_NEAR(a.power[at], b.power[at], 1e-5);
        }
    }
}

/// Functions of the grid are a part of all functions that are 0 at the boundary, so that their eigenvalues are above
/// those of the disk; and they have all that is 0 outside a disk which is smaller by two diagonals of cells, nearly, as
/// linear functions are right to (pi step)^2 of a wave.
TEST(RegionTapers, OfADiskHaveTheEigenvaluesOfBesselsZeros)
{
    const auto region = framed_text("disk 5 5 3");
    const RegionTapers tapers(*region, 6);
    const double radius = 1 / std::sqrt(std::numbers::pi), diagonal = std::hypot(tapers.step()[0], tapers.step()[1]);
    const std::array<double, 6> zeros{2.404825557697724, 3.831705970207512, 3.831705970207512,
                                      5.135622301840683, 5.135622301840683, 5.520078110286311};
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_GT(tapers.eigenvalue(k), std::pow(zeros[k] / radius, 2)) << k;
        EXPECT_LT(tapers.eigenvalue(k), std::pow(zeros[k] / (radius - 2 * diagonal), 2)) << k;
    }
}

TEST(RegionTapers, AreOrthogonalAndZeroOutside)
{
    const auto region = framed_text(bent);
    const RegionTapers tapers(*region, 5);
    // Four places of Gauss's rule in each cell are exact for products of two bilinear functions.
    const double near = 0.5 - 0.5 / std::sqrt(3.0), step = 1.0 / 128;
    const double weight = tapers.step()[0] * tapers.step()[1] / 4;
    std::array<std::array<double, 5>, 5> products{};
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 128; ++column)
            for (const double dy : {near, 1 - near})
                for (const double dx : {near, 1 - near}) {
                    const std::array<double, 2> place{(column + dx) * step, (row + dy) * step};
                    std::array<double, 5> at{};
                    for (std::size_t k = 0; k < 5; ++k) at[k] = tapers.at(k, place);
                    if (!region->contains(place)) {
                        ASSERT_EQ(at, (std::array<double, 5>{}));
                    }
                    for (std::size_t k = 0; k < 5; ++k)
                        for (std::size_t l = 0; l < 5; ++l) products[k][l] += at[k] * at[l] * weight;
                }
    for (std::size_t k = 0; k < 5; ++k)
        for (std::size_t l = 0; l < 5; ++l) EXPECT_NEAR(products[k][l], k == l, 1e-9) << k << ", " << l;
}

/// The mean over tapers and sets of independent points is 1 - |H|^2, and it varies as that of so many periodograms.
TEST(TaperedPeriodogram, OfRandomPointsIsOneWithTheSpreadOfTapers)
{
    const auto region = framed_text(bent);
    constexpr std::size_t count = 5, sets = 60, n = 200;
    const auto tapers = std::make_shared<const RegionTapers>(*region, count);
    const RandomInRegion random(*region, nullptr);
    TaperedPeriodogram periodogram(region, tapers, 16, false);
    double sum = 0, squares = 0;
    int frequencies = 0;
    std::vector<double> mean(9 * 17);
    for (std::uint32_t set = 0; set < sets; ++set) {
        const PointSet points = random.points(n, set);
        std::vector<double> of_set(mean.size());
        for (std::size_t k = 0; k < count; ++k) {
            HalfSpectrum power;
            periodogram.compute(points, k, power);
            for (std::size_t i = 0; i < mean.size(); ++i) of_set[i] += power.power[i] / count;
        }
        for (std::size_t u = 4; u < 9; ++u)
            for (std::size_t v = 0; v < 17; ++v) {
                const double power = of_set[u * 17 + v];
                sum += power;
                squares += (power - 1) * (power - 1);
                ++frequencies;
            }
    }
    // Periodograms of a set are independent from some frequencies away on: errors count those of a ninth of all.
    const double effective = frequencies / 9.0;
    EXPECT_NEAR(sum / frequencies, 1, 5 / std::sqrt(count * effective));
    EXPECT_NEAR(squares / frequencies * count, 1, 5 * std::sqrt(8.0 / effective)); // of squares of exponential variates
}

TEST(RegionTapers, NeedRoom)
{
    const auto thin = framed_text("POLYGON ((0 0, 0.001 0, 1 1, 0.999 1, 0 0))");
    EXPECT_THAT(message_of([&] { RegionTapers(*thin, 9); }), testing::HasSubstr("too thin for 9 tapers"));
}

}
}
