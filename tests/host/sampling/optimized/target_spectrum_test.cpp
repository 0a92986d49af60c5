// Sets that follow a spectrum: the gradient is that of the difference, and steps are as good as sets can have.
#include "host/sampling/optimized/target_spectrum.hpp"

#include "analysis/measures/blue_noise_measures.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "results/curve_tables.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/set_features.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

PointSet random_target_start(std::size_t points, unsigned seed)
{
    std::mt19937_64 random(seed);
    return test::random_points(points, 2, random);
}

/// Half the width of a ring, over the root of 1,024 points. Frequencies are whole, and a ring reaches from half below
/// one to half above it.
constexpr double half_a_ring = 0.5 / 32;

std::vector<RadialBin> radial_bins(const PointSet& points)
{
    const std::vector<double> radial = test::radial_power(points, 128); // of 1, 2, ... cycles
    std::vector<RadialBin> bins;
    for (std::size_t k = 1; k <= radial.size(); ++k)
        bins.push_back({.frequency = static_cast<double>(k), .power = radial[k - 1], .samples = 8 * k});
    return bins;
}

TEST(TargetCurves, AreLinesBetweenValues)
{
    const TargetCurve curve({0.5, 1}, {2, 4});
    EXPECT_EQ(curve.at(0.1), 2);
    EXPECT_DOUBLE_EQ(curve.at(0.75), 3);
    EXPECT_EQ(curve.at(1.1), 1);
    EXPECT_EQ(step_curve(0.5, 0).at(0.49), 0);
    EXPECT_DOUBLE_EQ(step_curve(0.5, 0).at(0.51), 1);
    EXPECT_DOUBLE_EQ(step_curve(0.5, 2).at(0.5), 3);
}

/// The difference by the definition, from a periodogram that is summed term by term, and its derivatives by
/// differences.
TEST(SpectrumDifferences, HaveTheGradientThatDifferencesHave)
{
    constexpr std::size_t n = 36; // rings up to 12
    const PointSet points = random_target_start(n, 3);
    const TargetCurve target = step_curve(0.5, 1);
    SpectrumDifference difference(n, target);
    const double value = difference.of(points);
    const std::vector<double> gradient = difference.gradient(points);

    constexpr int size = 26;
    const auto power = exact_periodogram(points, size);
    std::vector<double> sums(13), samples(13);
    for (int v = -12; v <= 12; ++v)
        for (int u = -12; u <= 12; ++u) {
            const auto ring = static_cast<std::size_t>(std::lround(std::hypot(u, v)));
            if (ring == 0 || ring > 12) continue;
            sums[ring] += power[static_cast<std::size_t>((v + size / 2) * size + u + size / 2)];
            samples[ring] += 1;
        }
    double expected = 0;
    for (std::size_t k = 1; k < sums.size(); ++k) {
        const double off = sums[k] / samples[k] - target.at(static_cast<double>(k) / 6);
        expected += off * off / 12;
    }
    EXPECT_NEAR(value, expected, 1e-5);

    for (std::size_t i = 0; i < points.coordinates.size(); i += 7) {
        PointSet above = points, below = points;
        above.coordinates[i] += 1e-4;
        below.coordinates[i] -= 1e-4;
        const double slope = (difference.of(above) - difference.of(below)) / 2e-4;
        EXPECT_NEAR(gradient[i], slope, 1e-2 * std::abs(slope) + 1e-3) << i;
    }
}

/// Step blue noise (Heck and others 2013): a step at s sqrt(N) has an effective Nyquist frequency of s / sqrt(0.9) as
/// this laboratory defines it. Beyond the step, power differs from 1 by what single sets scatter; here they hardly do.
TEST(TargetSpectrum, HasTheStepThatIsAskedFor)
{
    constexpr std::size_t n = 1024;
    const LloydResult result = follow_curve(random_target_start(n, 5), step_curve(0.54, 0), 150);
    for (std::size_t i = 1; i < result.iterations.size(); ++i)
        EXPECT_LT(result.iterations[i].energy, result.iterations[i - 1].energy);
    EXPECT_LT(result.iterations.back().energy, 1e-3);
    const std::vector<RadialBin> bins = radial_bins(result.points);
    for (std::size_t k = 1; k <= 16; ++k) EXPECT_LT(bins[k - 1].power, 0.1) << k;
    EXPECT_NEAR(effective_nyquist_frequency(bins, n, 2).value(), 0.54 / std::sqrt(0.9), half_a_ring);
}

/// The farthest step that sets can have, sqrt(N / pi), has 0.595; behind it, power differs from 1 by no more than that
/// of random points does: by 1 / (pi k) squared in ring k of one set, as there are 2 pi k frequencies, two by two
/// alike. The oscillation of these is 10 sqrt(2 / pi (a + b)) between rings a and b.
TEST(TargetSpectrum, HasTheFarthestStepAndTheOscillationOfNoise)
{
    constexpr std::size_t n = 1024;
    const LloydResult result = follow_curve(random_target_start(n, 6), step_curve(0.5642, 0), 300);
    const std::vector<RadialBin> bins = radial_bins(result.points);
    EXPECT_NEAR(effective_nyquist_frequency(bins, n, 2).value(), 0.595, half_a_ring);
    EXPECT_LT(oscillation(bins, n, 2).value, 10 * std::sqrt(2 / (std::numbers::pi * (0.5642 * 32 + 63))));
    for (std::size_t k = 1; k <= 17; ++k) EXPECT_LT(bins[k - 1].power, 0.1) << k;
}

/// A peak of 1 + 2 behind it lets the step be at 0.7 sqrt(N): the mean power comes to 0.1 at a frequency f with
/// 3 (f^2 - 0.49) = 0.1 f^2. Where a step alone is asked for there, sets cannot follow.
TEST(TargetSpectrum, HasASinglePeakWhereNoStepCanBe)
{
    constexpr std::size_t n = 1024;
    const PointSet start = random_target_start(n, 7);
    const LloydResult result = follow_curve(start, step_curve(0.7, 2), 300);
    const std::vector<RadialBin> bins = radial_bins(result.points);
    EXPECT_NEAR(effective_nyquist_frequency(bins, n, 2).value(), 0.7 / std::sqrt(1 - 0.1 / 3), half_a_ring);
    const auto highest = std::ranges::max_element(bins, {}, &RadialBin::power);
    EXPECT_NEAR(highest->power, 3, 0.5);
    EXPECT_NEAR(highest->frequency, 0.7 * 32, 1);
    const LloydResult step = follow_curve(start, step_curve(0.7, 0), 300);
    EXPECT_GT(step.iterations.back().energy, 3 * result.iterations.back().energy);
}

TEST(TargetSpectrumSampler, TakesCurvesFromTables)
{
    const SamplerSpec spec = target_spectrum_sampler();
    const TemporaryFolder folder;
    const auto set = [&](Parameters& parameters, const std::string& key, ParameterValue value) {
        parameters.set(key, std::move(value), {(folder.path() / "test.toml").string(), 3});
    };
    const auto refusal = [&](const Parameters& parameters) {
        return refusal_of([&] { spec.check(parameters, {256, 2, 1}, {"test.toml", 2}); });
    };
    Parameters parameters(spec.parameters);
    set(parameters, "target", std::string("curve"));
    EXPECT_THAT(refusal(parameters),
                testing::HasSubstr("test.toml:2: sampler = \"target-spectrum\": target = \"curve\" "));
    set(parameters, "curve", std::vector<std::string>{"radial.csv"});
    EXPECT_THAT(refusal(parameters), testing::HasSubstr("no such file"));
    std::vector<RadialBin> bins;
    for (int k = 1; k <= 32; ++k)
        bins.push_back({.frequency = static_cast<double>(k), .power = k < 8 ? 0.05 : 1.0, .samples = 8});
    std::ofstream(folder.path() / "radial.csv") << radial_csv(bins);
    EXPECT_EQ(refusal(parameters), "accepted");
    set(parameters, "iterations", std::int64_t{40});
    const auto sampler = spec.create(parameters, {256, 2, 1}, Engine::reference, {});
    const std::vector<double> radial = test::radial_power(sampler->sample(0), 64);
    for (std::size_t k = 2; k <= 6; ++k) EXPECT_NEAR(radial[k - 1], 0.05, 0.1) << k;

    const auto drawn = [&](const char* rows) {
        std::ofstream(folder.path() / "radial.csv") << "frequency,power\n" << rows;
        return refusal(parameters);
    };
    EXPECT_EQ(drawn("0,0.05\n7,0.05\n8,1\n"), "accepted");
    EXPECT_EQ(radial, test::radial_power(spec.create(parameters, {256, 2, 1}, Engine::reference, {})->sample(0),
                                         64)); // the same curve
    EXPECT_THAT(drawn("1,0\n1,1\n"), testing::HasSubstr("radial.csv:3: frequencies must ascend"));
    EXPECT_THAT(drawn("-1,0\n"), testing::HasSubstr("radial.csv:2: frequencies must ascend"));
    EXPECT_THAT(drawn("nan,0\n"), testing::HasSubstr("radial.csv:2: "));
    EXPECT_THAT(drawn("1,0\n2,-1\n"), testing::HasSubstr("radial.csv:3: power must be a number"));
    EXPECT_THAT(drawn("1,inf\n"), testing::HasSubstr("radial.csv:2: "));

    Parameters step(spec.parameters);
    set(step, "peak", 2.0);
    EXPECT_THAT(refusal(step), testing::HasSubstr("peak = 2: needs target = \"single-peak\""));
}

}
}
