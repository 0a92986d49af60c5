#include "analysis/measures/blue_noise_measures.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace poissonlab {
namespace {

using namespace test;
using std::numbers::pi;

/// Bins 1 .. count with the power of a function of frequency and as many samples as an annulus (shell) has
/// area (volume).
template <class Power>
std::vector<RadialBin> radial_of(std::size_t count, int dimension, const Power& power)
{
    std::vector<RadialBin> radial;
    for (std::size_t k = 1; k <= count; ++k) {
        const auto f = static_cast<double>(k);
        const double samples = dimension == 2 ? 2 * pi * f : 4 * pi * f * f;
        radial.push_back({f, power(f), 0, static_cast<std::size_t>(std::lround(samples))});
    }
    return radial;
}

TEST(EffectiveNyquistFrequency, OfTheStepSpectrumIsItsClosedForm)
{
    for (const int d : {2, 3}) {
        for (const double first : {20.0, 57.0}) {
            // C(f) = (f^d - e^d) / (f^d - 2^-d) with the edge e half a bin below the first bin with power.
            const auto radial = radial_of(200, d, [&](double f) { return f < first ? 0.0 : 1.0; });
            const double e = std::pow(first - 0.5, d);
            const double expected = std::pow((e - 0.1 * std::pow(0.5, d)) / 0.9, 1.0 / d);
            const std::size_t points = d == 2 ? 4096 : 262144; // s = 64
            EXPECT_NEAR(effective_nyquist_frequency(radial, points, d).value(), expected / 64, 1e-12);
        }
    }
}

TEST(EffectiveNyquistFrequency, OfALatticeIsThatOfTheLattice)
{
    // Half a bin below the first peak, plus what the rise to 0.1 takes within the bin.
    const Spectrum spectrum{2, 128, 1024, 1, exact_periodogram(square_lattice(32, 2), 128)};
    const double nu = effective_nyquist_frequency(radial_statistics(spectrum), 1024, 2).value();
    EXPECT_GE(nu, 31.5 / 32);
    EXPECT_LE(nu, 32.5 / 32);
}

TEST(EffectiveNyquistFrequency, IsZeroWithoutAnEmptyRegionAndUnknownWithoutAnEndOfIt)
{
    EXPECT_EQ(effective_nyquist_frequency(radial_of(100, 2, [](double) { return 1.0; }), 1024, 2), 0);
    for (const auto& ends_early : {radial_of(100, 2, [](double) { return 0.0; }), std::vector<RadialBin>{}})
        EXPECT_FALSE(effective_nyquist_frequency(ends_early, 1024, 2));
}

TEST(EffectiveNyquistFrequency, TakesTheLastCrossingBelowTheRise)
{
    // A low bump lifts C to 4.6^2/... above 0.1 and down again: frequencies 4 and 5 of power 1, then none
    // to 40.
    const auto radial = radial_of(200, 2, [](double f) { return f == 4 || f == 5 || f >= 40 ? 1.0 : 0.0; });
    // C(f) = (5.5^2 - 3.5^2 + f^2 - 39.5^2) / (f^2 - 1/4) = 0.1.
    const double expected = std::sqrt((39.5 * 39.5 - 18 - 0.025) / 0.9);
    EXPECT_NEAR(effective_nyquist_frequency(radial, 4096, 2).value(), expected / 64, 1e-12);
}

TEST(EffectiveNyquistFrequency, TakesARiseToOneHalfOnly)
{
    // Frequencies 33 to 36, beyond s / 2 = 32, lift C to 0.2; it falls again until the step at 80.
    const auto band = [](double f) { return (f >= 33 && f <= 36) || f >= 80 ? 1.0 : 0.0; };
    const double expected = std::sqrt((79.5 * 79.5 - (36.5 * 36.5 - 32.5 * 32.5) - 0.025) / 0.9);
    EXPECT_NEAR(effective_nyquist_frequency(radial_of(200, 2, band), 4096, 2).value(), expected / 64, 1e-12);
    const auto low = [](double f) { return f < 40 ? 0.0 : 0.45; };
    EXPECT_FALSE(effective_nyquist_frequency(radial_of(200, 2, low), 4096, 2));
}

/// The radial power of the jittered grid with n x n cells, 1 - mean over directions of sinc^2 sinc^2.
double jittered_power(double f, int n)
{
    const auto sinc = [](double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); };
    double sum = 0;
    constexpr int directions = 64; // of an eighth turn, midpoints: periodic, so spectrally accurate
    for (int i = 0; i < directions; ++i) {
        const double angle = (i + 0.5) * pi / 4 / directions;
        const double product = sinc(f * std::cos(angle) / n) * sinc(f * std::sin(angle) / n);
        sum += product * product;
    }
    return 1 - sum / directions;
}

TEST(BlueNoiseMeasures, OfTheJitteredGridAreThoseOfItsKnownSpectrum)
{
    constexpr int n = 128, size = 512;
    Spectrum spectrum{2, size, n * n, 1, {}};
    const auto sinc = [](double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); };
    for (int v = -size / 2; v < size / 2; ++v) {
        for (int u = -size / 2; u < size / 2; ++u) {
            const double product = sinc(static_cast<double>(u) / n) * sinc(static_cast<double>(v) / n);
            spectrum.power.push_back(1 - product * product);
        }
    }
    const auto radial = radial_statistics(spectrum);

    // C(f) = 2 / f^2 int P f df by small steps; f* where it crosses 0.1 (it grows up to there and beyond).
    constexpr double step = 0.01;
    double integral = 0, f = 0;
    while (f < 1 || 2 * integral / (f * f) < 0.1) {
        integral += jittered_power(f + step / 2, n) * (f + step / 2) * step;
        f += step;
    }
    // Bins of width 1 at f* = 33 see the curve to the order of (1/2)^2 / 33^2, 2e-4 relative, and as few
    // samples as 2 pi 33 in a ring deviate from its area by some percent of one of 33 rings.
    EXPECT_NEAR(effective_nyquist_frequency(radial, n * n, 2).value(), f / n, 2e-3 * f / n);

    const Oscillation measured = oscillation(radial, n * n, 2);
    EXPECT_EQ(measured.end, size / 2 - 1);
    EXPECT_GE(jittered_power(measured.begin + 0.5, n), 0.98);
    EXPECT_LT(jittered_power(measured.begin - 1.5, n), 0.98);
    double squares = 0, weight = 0;
    for (double g = measured.begin - 0.5; g < measured.end + 0.5; g += step) {
        const double mid = g + step / 2;
        squares += (jittered_power(mid, n) - 1) * (jittered_power(mid, n) - 1) * mid;
        weight += mid;
    }
    EXPECT_NEAR(measured.value, 10 * std::sqrt(squares / weight), 1e-2 * measured.value);
}

TEST(Oscillation, IsTheRootMeanSquareDeviationFromOne)
{
    // 0 up to f = 9, then alternately 1.5 and 0.5: ten times one half.
    const auto radial = radial_of(100, 2, [](double f) { return f < 10 ? 0 : std::fmod(f, 2) == 0 ? 1.5 : 0.5; });
    const Oscillation o = oscillation(radial, 100, 2);
    EXPECT_EQ(o.begin, 10);
    EXPECT_EQ(o.end, 60); // 10 + 5 sqrt 100
    EXPECT_NEAR(o.value, 5, 1e-12);
    const auto step = radial_of(100, 3, [](double f) { return f < 10 ? 0.0 : 1.0; });
    EXPECT_EQ(oscillation(step, 1000, 3).value, 0);
    // Never up to 0.98: from the largest power on.
    const auto low = radial_of(10, 2, [](double f) { return f == 7 ? 0.5 : 0.25; });
    EXPECT_EQ(oscillation(low, 100, 2).begin, 7);
}

/// Relaxation from random points leaves the power of the lowest rings near 1, above or below it by chance.
TEST(Oscillation, BeginsBeyondHalfTheFrequencyOfTheGrid)
{
    const auto with_lowest = [](double lowest) {
        return radial_of(100, 2, [=](double f) { return f == 1 ? lowest : f < 10 ? 0 : f < 20 ? 1.5 : 1; });
    };
    const Oscillation above = oscillation(with_lowest(1.1), 100, 2), below = oscillation(with_lowest(0.9), 100, 2);
    EXPECT_EQ(above, below);
    EXPECT_EQ(above.begin, 10);
    // A spectrum that ends before has no better begin than its largest power.
    EXPECT_EQ(oscillation(radial_of(4, 2, [](double f) { return f / 10; }), 100, 2).begin, 4);
}

/// The effect of the noise of K periodograms on a flat spectrum: power is exponentially distributed, and f and -f have
/// the same, so that the mean over the n samples of a bin has the variance 2 / (K n).
double squared_noise_floor(const std::vector<RadialBin>& radial, const Oscillation& measured, int realizations)
{
    double noise = 0, samples = 0;
    for (const RadialBin& bin : radial) {
        if (bin.frequency < measured.begin || bin.frequency > measured.end) continue;
        noise += 2.0 / realizations;
        samples += static_cast<double>(bin.samples);
    }
    return 100 * noise / samples;
}

TEST(Oscillation, OfWhiteNoiseIsItsNoiseFloor)
{
    std::mt19937_64 random(1);
    std::vector<double> ratios;
    for (int i = 0; i < 40; ++i) {
        SpectrumEstimate estimate(2, 64);
        for (int k = 0; k < 3; ++k) estimate.add(random_points(300, 2, random));
        const auto radial = radial_statistics(estimate.mean());
        const Oscillation o = oscillation(radial, 300, 2);
        ratios.push_back(o.value * o.value / squared_noise_floor(radial, o, 3));
    }
    // f and -f weigh the same, so means of squares compare; a first bin of at least 0.98 is as good as
    // chosen, which changes one bin of 30.
    const Mean mean = mean_of(ratios);
    EXPECT_LT(std::abs(mean.value - 1), z_bound(1) * mean.standard_error + 1 / 30.0);
}

TEST(BlueNoiseMeasures, RejectWhatHasNoMeaning)
{
    const auto radial = radial_of(10, 2, [](double) { return 1.0; });
    EXPECT_THROW(effective_nyquist_frequency(radial, 0, 2), InputError);
    EXPECT_THROW(effective_nyquist_frequency(radial, 10, 4), InputError);
    EXPECT_THROW(oscillation(radial, 0, 2), InputError);
    EXPECT_THROW(oscillation(radial, 10, 1), InputError);
    EXPECT_EQ(oscillation({}, 10, 2).value, 0);
}

}
}
