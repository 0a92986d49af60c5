// Spectrum and pair correlation of saturated sets, against what statistical physics knows of random
// sequential addition.
#include "analysis/measures/low_frequency_power.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

constexpr std::size_t points = 16384;
constexpr std::uint32_t realizations = 40;

double saturated_distance(int dimension)
{
    return min_distance_for(saturation_relative_radius(dimension), points, dimension);
}

const std::vector<PointSet>& saturated_sets(int dimension)
{
    const auto make = [](int d) {
        DartThrower thrower(Device::open());
        DartThrowingRequest request;
        request.dimension = d;
        request.min_distance = saturated_distance(d);
        std::vector<PointSet> sets;
        for (std::uint32_t k = 0; k < realizations; ++k) {
            request.stream = stream_key(7, Purpose::dart_throwing, k);
            sets.push_back(thrower.throw_darts(request));
        }
        return sets;
    };
    if (dimension == 2) {
        static const std::vector<PointSet> plane = make(2);
        return plane;
    }
    static const std::vector<PointSet> space = make(3);
    return space;
}

/// The power at frequency 0, from frequencies up to a quarter of the peak's.
LowFrequencyPower power_at_zero(int dimension)
{
    SpectrumEstimate estimate(dimension, dimension == 2 ? 128 : 32, true);
    for (const PointSet& set : saturated_sets(dimension)) estimate.add(set);
    return low_frequency_power(radial_statistics(estimate.mean()), low_frequency_range(points, dimension)).value();
}

// The limits are those of Zhang and Torquato, Precise algorithm to generate random sequential addition of
// hard hyperspheres at saturation, Phys. Rev. E 88, 053312 (2013).
TEST(SaturatedSpectrum, HasTheKnownPowerTowardsFrequencyZero)
{
    const LowFrequencyPower power = power_at_zero(2);
    RecordProperty("intercept", std::to_string(power.intercept));
    EXPECT_LT(power.intercept_standard_error, 0.001);
    EXPECT_NEAR(power.intercept, 0.0587, test::z_bound(1) * power.intercept_standard_error);
}

TEST(SaturatedSpectrum, HasTheKnownPowerTowardsFrequencyZeroIn3D)
{
    const LowFrequencyPower power = power_at_zero(3);
    RecordProperty("intercept", std::to_string(power.intercept));
    EXPECT_LT(power.intercept_standard_error, 0.001);
    EXPECT_NEAR(power.intercept, 0.0558, test::z_bound(1) * power.intercept_standard_error);
}

/// g between the distances d (1 + 2^-(j+1)) and d (1 + 2^-j), and the largest g below d.
struct NearContact
{
    double value = 0;
    double below = 0;
};

NearContact near_contact(const PointSet& set, double d, int j)
{
    const double width = std::ldexp(d, -(j + 1));
    const std::size_t bins = (std::size_t{1} << (j + 1)) + 2;
    PairCorrelationEstimate estimate(set.dimension, static_cast<double>(bins) * width, bins);
    estimate.add(set);
    const auto curve = estimate.mean();
    NearContact result{curve.back().value, 0};
    // The last bin below d may hold pairs at d itself, by the rounding of its end.
    for (std::size_t k = 0; k + 3 < bins; ++k) result.below = std::max(result.below, curve[k].value);
    return result;
}

// Pomeau, Some asymptotic estimates in the random parking problem, J. Phys. A 13, L193 (1980); Swendsen,
// Dynamics of random sequential adsorption, Phys. Rev. A 24, 504 (1981): g grows as the logarithm of the gap.
// The value grows from one quarter of the gap to the next by the same amount, where a finite value at contact would
// take smaller and smaller steps and a power larger ones.
TEST(SaturatedSpectrum, PairCorrelationGrowsLogarithmicallyTowardsContact)
{
    for (const int dimension : {2, 3}) {
        const double d = saturated_distance(dimension);
        std::vector<double> growth, bend;
        for (const PointSet& set : saturated_sets(dimension)) {
            const NearContact far = near_contact(set, d, 6), middle = near_contact(set, d, 8),
                              close = near_contact(set, d, 10);
            EXPECT_EQ(std::max({far.below, middle.below, close.below}), 0);
            growth.push_back(close.value - far.value);
            bend.push_back(close.value - 2 * middle.value + far.value);
        }
        const test::Mean grown = test::mean_of(growth), bent = test::mean_of(bend);
        EXPECT_LT(std::abs(bent.value), test::z_bound(2) * bent.standard_error) << dimension;
        EXPECT_LT(test::z_bound(2) * bent.standard_error, grown.value / 4) << "the check sees steps of different size";
    }
}

}
}
