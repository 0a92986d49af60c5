// The standard errors of measures against the spread of the measures over many series.
#include "experiment/measuring/series_analysis.hpp"

#include "host/settings/sampler_registry.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace poissonlab {
namespace {

constexpr int series_count = 200;
constexpr int realizations = 8;

/// The measures of many series of one method that differ in their seed.
std::vector<Measures> measures_of(const std::string& method, const Parameters& parameters)
{
    AnalysisOptions options;
    options.tiles = 8;
    std::vector<Measures> result;
    for (std::uint64_t seed = 1; seed <= series_count; ++seed) {
        const auto sampler = find_sampler(method)->create(parameters, {256, 2, seed}, Engine::reference, {});
        SeriesAnalysis analysis("s", false, options);
        for (std::uint32_t k = 0; k < realizations; ++k) analysis.add(sampler->sample(k));
        analysis.measure_spectrum(analysis.mean_spectrum());
        result.push_back(analysis.result().measures);
    }
    return result;
}

using Value = std::function<double(const Measures&)>;

/// The mean of the claimed variances over the variance of the values.
double claimed_over_true(const std::vector<Measures>& series, const Value& value, const Value& error)
{
    double claimed = 0, sum = 0, squares = 0;
    for (const Measures& measures : series) {
        claimed += error(measures) * error(measures) / series_count;
        sum += value(measures) / series_count;
        squares += value(measures) * value(measures) / series_count;
    }
    return claimed / ((squares - sum * sum) * series_count / (series_count - 1.0));
}

double nyquist(const Measures& m) { return m.numbers.at("effective_nyquist").value; }
double nyquist_error(const Measures& m) { return *m.numbers.at("effective_nyquist").standard_error; }
double flatness(const Measures& m) { return m.oscillation->value; }
double flatness_error(const Measures& m) { return *m.oscillation->standard_error; }
double ratio(const Measures& m) { return m.lattice_peaks->mean_ratio; }
double ratio_error(const Measures& m) { return *m.lattice_peaks->mean_ratio_standard_error; }

// The variance of 200 values has the relative standard error sqrt(2 / 199), the mean of 200 claims, each of 8
// realizations, sqrt(2 / (7 * 200)): together 0.107. Four of these.
constexpr double tolerance = 4 * 0.107;

TEST(MeasureErrors, AgreeWithTheSpreadOfDartThrowing)
{
    // Dense sets: looser ones have a mean power near 0.1 at all low frequencies, between which the effective Nyquist
    // frequency, the last one with less than 0.1, jumps.
    Parameters parameters(find_sampler("dart-throwing")->parameters);
    parameters.set("relative_radius", 0.74);
    const auto series = measures_of("dart-throwing", parameters);
    EXPECT_NEAR(claimed_over_true(series, nyquist, nyquist_error), 1, tolerance);
    EXPECT_NEAR(claimed_over_true(series, ratio, ratio_error), 1.07, tolerance) << "see lattice_peaks.hpp";
    // Noise counts squared as well: between right and twice too much.
    const double oscillation = claimed_over_true(series, flatness, flatness_error);
    EXPECT_GT(oscillation, 1 - tolerance);
    EXPECT_LT(oscillation, 2 * (1 + tolerance));
}

TEST(MeasureErrors, AgreeWithTheSpreadOfRandomSets)
{
    const auto series = measures_of("random", {});
    EXPECT_NEAR(claimed_over_true(series, ratio, ratio_error), 1.07, tolerance);
    // The spectrum is flat but for noise: twice the variance, as jackknife.hpp says, (K / (K - 1)) a little more.
    EXPECT_NEAR(claimed_over_true(series, flatness, flatness_error), 2 * 8.0 / 7, 2 * 8.0 / 7 * tolerance);
    for (const Measures& measures : series) EXPECT_EQ(nyquist_error(measures), 0) << "0 for each";
}

/// A tiling of 8 x 8 tiles, each of which is one of four at random, of nine random points each.
PointSet random_tiling(const std::vector<double>& tiles, std::mt19937_64& random)
{
    constexpr int side = 8;
    constexpr std::size_t numbers = 18;
    PointSet set{2, {}};
    for (int place = 0; place < side * side; ++place) {
        const std::size_t tile = random() % (tiles.size() / numbers);
        for (std::size_t i = 0; i < numbers; i += 2) {
            set.coordinates.push_back((place % side + tiles[numbers * tile + i]) / side);
            set.coordinates.push_back((place / side + tiles[numbers * tile + i + 1]) / side);
        }
    }
    return set;
}

/// The measures of many series of six tile sets, each with four tilings, analysed as such or as if all were
/// independent.
std::vector<Measures> measures_of_tilings(bool knows_sets)
{
    constexpr std::uint32_t sets = 6, tilings = 4 * sets;
    AnalysisOptions options;
    options.tiles = 8;
    options.spectrum_size = 128;
    options.distances_only = true;
    if (knows_sets) options.tile_sets = sets;
    std::vector<Measures> result;
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int series = 0; series < series_count; ++series) {
        std::vector<std::vector<double>> tiles(sets, std::vector<double>(72));
        for (auto& set : tiles)
            for (double& coordinate : set) coordinate = uniform(random);
        SeriesAnalysis analysis("s", false, options);
        for (std::uint32_t k = 0; k < tilings; ++k) analysis.add(random_tiling(tiles[k % sets], random));
        analysis.measure_spectrum(analysis.mean_spectrum());
        result.push_back(analysis.result().measures);
    }
    return result;
}

/// What sets of tiles have in common is in the values of all their tilings, and in the errors between sets alone.
TEST(MeasureErrors, OfTilingsAreThoseBetweenTileSets)
{
    const auto known = measures_of_tilings(true), unknown = measures_of_tilings(false);
    for (const char* key : {"near_lattice_peaks", "lattice_excess", "hyperuniformity_exponent"}) {
        const auto value = [&](const Measures& m) { return m.numbers.at(key).value; };
        const auto error = [&](const Measures& m) { return m.numbers.at(key).standard_error.value(); };
        EXPECT_NEAR(claimed_over_true(known, value, error), 1, tolerance) << key;
        EXPECT_LT(claimed_over_true(unknown, value, error), 0.5) << key;
    }
}

TEST(MeasureErrors, NeedTwoRealizations)
{
    AnalysisOptions options;
    options.tiles = 4;
    SeriesAnalysis analysis("s", false, options);
    analysis.add(find_sampler("random")->create({}, {64, 2, 1}, Engine::reference, {})->sample(0));
    analysis.measure_spectrum(analysis.mean_spectrum());
    const Measures measures = analysis.result().measures;
    EXPECT_FALSE(measures.numbers.at("effective_nyquist").standard_error);
    EXPECT_FALSE(measures.oscillation->standard_error);
    EXPECT_FALSE(measures.peak_anisotropy && measures.peak_anisotropy->standard_error_db);
    ASSERT_TRUE(measures.lattice_peaks);
    EXPECT_FALSE(measures.lattice_peaks->mean_ratio_standard_error);
}

}
}
