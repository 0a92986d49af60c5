// Series of one configuration and two seeds: diff calls one of a hundred pairs changed, at most.
#include "reports/diff/run_comparison.hpp"

#include "base/files/whole_file.hpp"
#include "experiment/measuring/series_analysis.hpp"
#include "host/settings/sampler_registry.hpp"
#include "results/curve_tables.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

/// Five and more of 200 pairs, with a level of 1 %, are changed in one of twenty tests at most, of 40 pairs 3 and more
/// in one of a hundred: seeds are fixed.
struct AlarmCase
{
    std::string name, method;
    std::map<std::string, ParameterValue> parameters;
    std::size_t points = 0;
    int pairs = 0, most = 0;

    friend std::ostream& operator<<(std::ostream& out, const AlarmCase& one) { return out << one.name; }
};

/// Ten realizations of a seed, measured, with their curves in a folder.
Run measured_run(const AlarmCase& one, std::uint64_t seed, const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    Parameters parameters(find_sampler(one.method)->parameters);
    for (const auto& [key, value] : one.parameters) parameters.set(key, value);
    const auto sampler = find_sampler(one.method)->create(parameters, {one.points, 2, seed}, Engine::reference, {});
    std::optional<SeriesAnalysis> analysis;
    for (std::uint32_t k = 0; k < 10; ++k) {
        const PointSet set = sampler->sample(k);
        if (!analysis) analysis.emplace("s", sampler->traits().sizes_vary, AnalysisOptions{});
        analysis->add(set);
    }
    const Spectrum mean = analysis->mean_spectrum();
    write_whole_file(folder / "radial.csv", radial_csv(analysis->radial_curve(mean)));
    write_whole_file(folder / "pairs.csv", pair_correlation_csv(analysis->pair_correlation()));
    write_whole_file(folder / "variance.csv", number_variance_csv(analysis->number_variance()));
    analysis->measure_spectrum(mean);
    analysis->measure_first();
    Run run;
    run.folder = folder;
    run.seed = std::to_string(seed);
    run.engine = "reference";
    Series& series = run.series.emplace_back(analysis->result());
    series.sampler = one.method;
    series.radial_file = "radial.csv";
    series.pair_correlation_file = "pairs.csv";
    series.number_variance_file = "variance.csv";
    return run;
}

class FalseAlarms : public testing::TestWithParam<AlarmCase>
{
};

TEST_P(FalseAlarms, AreAsRareAsPromised)
{
    const TemporaryFolder folder;
    int alarms = 0;
    std::string causes;
    for (int pair = 0; pair < GetParam().pairs; ++pair) {
        const auto seed = static_cast<std::uint64_t>(2 * pair + 1);
        const auto before = measured_run(GetParam(), seed, folder.path() / "old");
        const auto after = measured_run(GetParam(), seed + 1, folder.path() / "new");
        SeriesComparison comparison;
        comparison.run_before = &before;
        comparison.run_after = &after;
        comparison.before = &before.series.front();
        comparison.after = &after.series.front();
        comparison.numbers = compare_series(comparison);
        std::vector<NumberComparison*> numbers;
        for (NumberComparison& number : comparison.numbers) numbers.push_back(&number);
        settle_verdicts(numbers);
        alarms += comparison.changed();
        for (const NumberComparison& number : comparison.numbers)
            if (number.verdict == Verdict::changed) causes += number.quantity + "; ";
    }
    EXPECT_LE(alarms, GetParam().most) << causes;
}

AlarmCase alarms_of(AlarmCase one, std::size_t points, int pairs, int most)
{
    one.points = points;
    one.pairs = pairs;
    one.most = most;
    return one;
}

const AlarmCase random_alarms{"random", "random", {}};
const AlarmCase dart_alarms{"darts", "dart-throwing", {{"relative_radius", 0.7}}};
/// Sizes vary from set to set.
const AlarmCase saturated_alarms{
    "saturated", "dart-throwing", {{"relative_radius", 0.7}, {"stop", std::string("saturation")}}};
const AlarmCase relaxed_alarms{"relaxed", "lloyd", {{"iterations", std::int64_t{10}}}};

std::string alarm_name(const testing::TestParamInfo<AlarmCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Quick, FalseAlarms, testing::Values(alarms_of(dart_alarms, 256, 40, 2)), alarm_name);
INSTANTIATE_TEST_SUITE_P(Nightly, FalseAlarms,
                         testing::Values(alarms_of(random_alarms, 1024, 200, 4), alarms_of(dart_alarms, 1024, 200, 4),
                                         alarms_of(saturated_alarms, 1024, 40, 2),
                                         alarms_of(relaxed_alarms, 256, 200, 4)),
                         alarm_name);

}
}
