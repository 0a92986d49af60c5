// The standard errors that are reported against the spread of what they belong to, over many independent series.
//
// The mean of the squared errors of R series over the variance of their R values has, where values are normal and each
// error is that of the mean of K, a logarithm with the variance 2 / (R - 1) + 2 / ((K - 1) R), a quarter of which
// belongs to the ratio of error and spread. Squared errors of K realizations have no bias, so that no factor of
// Student's is needed. With R = 240 and K = 10 the deviation is 0.048, and 0.8 to 1.25 is 4.6 of them away: a right
// error among 20 is called wrong in 8 of 100,000 tests. Errors of integrals go with squares of exponential variables,
// whose squared errors vary with (8 + 2 / 9) / 10 for 2 / 9 at most: 0.059, 3.8 deviations, and 7 of 10,000 for five of
// them. Seeds are fixed.
#include "experiment/measuring/series_analysis.hpp"

#include "host/settings/sampler_registry.hpp"
#include "results/measures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

constexpr std::uint32_t series_count = 240, realizations = 10;
constexpr double least_ratio = 0.8, largest_ratio = 1.25;

/// More than the number of tile sets of a series, which have the seeds that follow it.
constexpr std::uint64_t seeds_apart = 64;

/// The sums of a value and its claimed variances over series.
struct Claims
{
    std::size_t count = 0;
    double sum = 0, squares = 0, claimed = 0;
    bool has_error = false; ///< of any

    void add(double value, std::optional<double> standard_error)
    {
        ++count;
        sum += value;
        squares += value * value;
        claimed += standard_error.value_or(0) * standard_error.value_or(0);
        has_error = has_error || standard_error.value_or(0) > 0;
    }

    double variance() const
    {
        const auto n = static_cast<double>(count);
        return std::max(0.0, (squares - sum * sum / n) / (n - 1));
    }

    /// Claimed over true variances; nothing where there is no spread but rounding, or no error is claimed.
    std::optional<double> ratio() const
    {
        const auto n = static_cast<double>(count);
        if (!has_error) return std::nullopt;
        if (variance() <= 1e-20 * squares / n) return std::nullopt;
        return claimed / n / variance();
    }
};

/// Everything that has an error: measures by their key, curves by their name and their place.
struct Calibration
{
    std::map<std::string, Claims> measures;
    std::map<std::string, std::map<double, Claims>> curves;

    void add(const Series& series, const SeriesAnalysis& analysis, const Spectrum& mean)
    {
        for (const Measure& measure : poissonlab::measures())
            if (const auto value = measure.get(series);
                value && value->standard_error && measure.key != "low_frequency_exponent")
                measures[measure.key].add(value->value, value->standard_error);
        // The catalogue leaves out exponents that mean nothing: those that are left out have right errors as well.
        if (const auto& fit = series.measures.low_frequency_power)
            measures["low_frequency_exponent"].add(fit->exponent, fit->exponent_standard_error);
        for (const RadialBin& bin : analysis.radial_curve(mean))
            curves["power"][bin.frequency].add(bin.power, bin.power_error);
        for (const PairCorrelationBin& bin : analysis.pair_correlation())
            curves["pair correlation"][bin.distance].add(bin.value, bin.standard_error);
        for (const NumberVarianceBin& bin : analysis.number_variance())
            curves["number variance"][bin.radius].add(bin.variance, bin.standard_error);
    }
};

struct Case
{
    std::string name, method;
    std::map<std::string, ParameterValue> parameters;
    std::size_t points = 0;
    std::vector<std::string> options = {};
    std::uint32_t sets = realizations; ///< of a series

    friend std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.name; }
};

void add_series(const Case& one, AnalysisOptions options, std::uint64_t seed, Calibration& calibration)
{
    Parameters parameters(find_sampler(one.method)->parameters);
    for (const auto& [key, value] : one.parameters) parameters.set(key, value);
    const auto sampler = find_sampler(one.method)->create(parameters, {one.points, 2, seed}, Engine::reference, {});
    std::optional<SeriesAnalysis> analysis;
    for (std::uint32_t k = 0; k < one.sets; ++k) {
        const PointSet set = sampler->sample(k);
        if (!analysis) {
            const SetTraits traits = sampler->traits();
            options.tiles = static_cast<int>(traits.tiles_along_axis);
            options.tile_sets = traits.tile_sets;
            analysis.emplace("s", traits.sizes_vary, options);
        }
        analysis->add(set);
    }
    const Spectrum mean = analysis->mean_spectrum();
    analysis->measure_spectrum(mean);
    calibration.add(analysis->result(), *analysis, mean);
}

class MeasureErrors : public testing::TestWithParam<Case>
{
};

/// Curves are judged by the mean of the ratios of all places that have a spread.
TEST_P(MeasureErrors, AreTheSpreadOfIndependentSeries)
{
    Calibration calibration;
    const AnalysisOptions options = overridden_analysis(GetParam().options, 2);
    for (std::uint64_t i = 0; i < series_count; ++i) add_series(GetParam(), options, 1 + i * seeds_apart, calibration);
    std::string table;
    int checked = 0;
    const auto check = [&](const std::string& what, double squared) {
        const double ratio = std::sqrt(squared);
        ++checked;
        table += fmt::format("{} {:.3f}\n", what, ratio);
        EXPECT_GT(ratio, least_ratio) << what;
        EXPECT_LT(ratio, largest_ratio) << what;
    };
    for (const auto& [key, claims] : calibration.measures)
        if (const auto ratio = claims.ratio()) check(key, *ratio);
    for (const auto& [name, places] : calibration.curves) {
        double ratios = 0, count = 0;
        for (const auto& [place, claims] : places)
            if (const auto ratio = claims.ratio()) ratios += *ratio, ++count;
        if (count > 0) check(name, ratios / count);
    }
    EXPECT_GE(checked, GetParam().options.empty() ? 13 : 4);
    RecordProperty("ratios", table);
}

Case of(std::size_t points, Case one)
{
    one.points = points;
    return one;
}

const Case sets_of_chance{"random", "random", {}};
/// Dense sets: looser ones have a mean power near 0.1 at all low frequencies, between which the effective Nyquist
/// frequency, the last one with less than 0.1, jumps.
const Case darts{"darts", "dart-throwing", {{"relative_radius", 0.74}}};
const Case relaxed{"relaxed", "lloyd", {{"iterations", std::int64_t{5}}}};
/// Each realization has a tile set of its own.
const Case tiles{"tiles",
                 "corner-tiles",
                 {{"colors", std::int64_t{2}},
                  {"points_per_tile", std::int64_t{16}},
                  {"relative_radius", 0.6},
                  {"sets", std::int64_t{realizations}}}};
/// Two realizations have one tile set: errors are between five.
const Case shared_tiles{"shared_tiles",
                        "corner-tiles",
                        {{"colors", std::int64_t{1}},
                         {"points_per_tile", std::int64_t{16}},
                         {"relative_radius", 0.6},
                         {"sets", std::int64_t{realizations / 2}}}};
const std::vector<std::string> by_tapers{"analysis.region=\"rectangle 0 0 1 1\"", "analysis.tapers=8",
                                         "analysis.envelope=0"};
const Case tapered_random{"tapered_random", "random", {}, 0, by_tapers, 1};
const Case tapered_darts{"tapered_darts", "dart-throwing", {{"relative_radius", 0.74}}, 0, by_tapers, 1};

std::string name_of(const testing::TestParamInfo<Case>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Quick, MeasureErrors, testing::Values(of(256, sets_of_chance), of(256, darts)), name_of);
INSTANTIATE_TEST_SUITE_P(QuickTapers, MeasureErrors, testing::Values(of(256, tapered_darts)), name_of);
INSTANTIATE_TEST_SUITE_P(Nightly, MeasureErrors,
                         testing::Values(of(1024, sets_of_chance), of(1024, darts), of(256, relaxed), of(256, tiles),
                                         of(256, shared_tiles), of(1024, tapered_random), of(1024, tapered_darts)),
                         name_of);

TEST(MeasureErrorsOfOneSet, AreNotKnown)
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
