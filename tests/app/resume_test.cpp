// Runs that go on where others stopped, inside the process, with samplers that count.
#include "base/files/whole_file.hpp"
#include "base/programs/interrupt.hpp"
#include "experiment/measuring/series_analysis.hpp"
#include "experiment/run/runner.hpp"
#include "tests/app/lasting_results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <set>
#include <sstream>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using Counts = std::map<std::uint32_t, int>;

using BeforeSampling = std::function<void(std::uint32_t realization)>;

/// Points in rows, a little different in each realization; counts what it is asked for.
class CountingSampler : public Sampler
{
public:
    CountingSampler(std::size_t points, Counts& counts, BeforeSampling before)
        : points_(points), counts_(counts), before_(std::move(before))
    {}
    PointSet sample(std::uint32_t realization) override
    {
        if (before_) before_(realization);
        ++counts_[realization];
        PointSet set;
        for (std::size_t i = 0; i < points_; ++i) {
            set.coordinates.push_back((static_cast<double>(i) + 0.3) / static_cast<double>(points_ + realization));
            set.coordinates.push_back(std::fmod(0.618 * static_cast<double>(i) + 0.01 * realization, 1));
        }
        return set;
    }

private:
    std::size_t points_;
    Counts& counts_;
    BeforeSampling before_;
};

/// An experiment of one series, as often as it is wanted.
class Resuming : public testing::Test
{
protected:
    Experiment experiment(std::uint32_t realizations, std::uint32_t fails_at)
    {
        return experiment(realizations, [fails_at](std::uint32_t realization) {
            if (realization == fails_at) throw Interrupted();
        });
    }

    Experiment experiment(std::uint32_t realizations, const BeforeSampling& before = {})
    {
        SeriesTask task;
        static const SamplerSpec spec = [] {
            SamplerSpec named;
            named.name = "s";
            return named;
        }();
        task.name = task.label = "s";
        task.sampler = &spec;
        task.realizations = realizations;
        task.request.points = 48;
        task.identity = [this] { return UnitKey("sets").add("seed", seed_).add("radius", std::to_string(radius_)); };
        task.create = [this, before] { return std::make_unique<CountingSampler>(48, counts_, before); };
        Experiment experiment;
        experiment.title = "T";
        experiment.engine = "reference";
        experiment.realizations = realizations;
        experiment.analysis = analysis_;
        experiment.series = {task};
        experiment.workplace->machine_conditions = [this] { return machine_; };
        return experiment;
    }

    void run(const Experiment& experiment, const std::string& out = "out", std::optional<Shard> shard = {})
    {
        RunSettings settings;
        settings.units = folder_.path() / out / ".units";
        settings.shard = shard;
        settings.versions = versions_;
        Progress progress(Progress::Style::quiet);
        const auto crew = make_crew_of_one();
        const std::vector<PlannedRun> runs = {{experiment, folder_.path() / out}};
        const RunsOutcome outcome = run_experiments(runs, settings, *crew, progress);
        is_complete_ = outcome.is_complete;
        outcome.raise_failures();
    }

    /// The number of realizations that were made since the last call.
    std::size_t made()
    {
        std::size_t count = 0;
        for (const auto& [realization, times] : counts_) count += static_cast<std::size_t>(times);
        counts_.clear();
        return count;
    }

    /// All that an undisturbed run leaves, in a folder of its own.
    std::map<std::string, std::string> undisturbed(std::uint32_t realizations)
    {
        const std::string name = "undisturbed-" + std::to_string(++fresh_);
        run(experiment(realizations), name);
        counts_.clear();
        return lasting_results(folder_.path() / name);
    }

    std::map<std::string, std::string> results() const
    {
        if (!fs::exists(folder_.path() / "out")) return {};
        return lasting_results(folder_.path() / "out");
    }

    /// The files of units that were written since the last call.
    std::size_t new_units()
    {
        std::size_t count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "out/.units"))
            if (entry.path().extension() == ".unit") count += units_.insert(entry.path().string()).second;
        return count;
    }

    TemporaryFolder folder_;
    Counts counts_;
    int seed_ = 1;
    double radius_ = 0.5;
    AnalysisOptions analysis_;
    CodeVersions versions_{"1", "1", "1", "1"};
    std::string machine_ = "here";
    bool is_complete_ = false;

private:
    int fresh_ = 0;
    std::set<std::string> units_;
};

TEST_F(Resuming, MakesNothingTwiceAndEndsWithTheSameBytes)
{
    for (const std::uint32_t stop : {0U, 1U, 20U, 31U, 32U, 33U, 64U, 69U}) {
        EXPECT_THROW(run(experiment(70, stop)), Interrupted);
        EXPECT_TRUE(results().empty()) << "all at once, at the end";
        run(experiment(70));
        EXPECT_EQ(counts_.size(), 70U);
        for (const auto& [realization, times] : counts_) EXPECT_EQ(times, 1) << realization << " after " << stop;
        counts_.clear();
        EXPECT_EQ(results(), undisturbed(70)) << stop;
        run(experiment(70));
        EXPECT_EQ(made(), 0U);
        fs::remove_all(folder_.path() / "out");
    }
}

TEST_F(Resuming, PartsPutTogetherAreTheWhole)
{
    // Parts are compared with one analysis of all realizations in their order. Sums in another order differ by rounding
    // only: of K values, by some K times 1e-16 each, and errors divide by their spread.
    run(experiment(70));
    SeriesAnalysis whole("s", false, {});
    CountingSampler sampler(48, counts_, {});
    for (std::uint32_t k = 0; k < 70; ++k) whole.add(sampler.sample(k));
    const auto json = nlohmann::json::parse(content_of(folder_.path() / "out/results.json"))["series"][0];
    EXPECT_EQ(json["relative_radius"]["each"].get<std::vector<double>>(), whole.result().relative_radius->each);
    EXPECT_EQ(json["points"], 48);
    const Spectrum mean = whole.mean_spectrum();
    whole.measure_spectrum(mean);
    whole.measure_first();
    const Measures expected = whole.result().measures;
    const auto& measures = json["measures"];
    EXPECT_NEAR(measures["oscillation"]["value"], expected.oscillation->value, 1e-12);
    EXPECT_NEAR(measures["oscillation"]["standard_error"], *expected.oscillation->standard_error, 1e-10);
    EXPECT_EQ(measures["largest_empty"]["radius"], expected.largest_empty->radius);
    for (std::size_t i = 0; i < expected.integration.size(); ++i) {
        EXPECT_NEAR(measures["integration"][i]["rms_error"], expected.integration[i].rms_error, 1e-15);
        EXPECT_NEAR(measures["integration"][i]["standard_error"], expected.integration[i].standard_error, 1e-15);
    }
    const auto stored = content_of(folder_.path() / "out/s/radial.csv");
    std::istringstream lines(stored);
    std::string line;
    std::getline(lines, line);
    for (const RadialBin& bin : whole.radial_curve(mean)) {
        ASSERT_TRUE(std::getline(lines, line));
        double frequency = 0, power = 0, anisotropy = 0, samples = 0, error = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &frequency, &power, &anisotropy, &samples, &error),
                  5);
        EXPECT_NEAR(power, bin.power, 1e-12 * std::max(1.0, bin.power));
        EXPECT_NEAR(error, bin.power_error, 1e-10 * std::max(1.0, bin.power));
    }
}

TEST_F(Resuming, MoreRealizationsAreThoseThatAreMissing)
{
    run(experiment(40));
    EXPECT_EQ(made(), 40U);
    run(experiment(70));
    EXPECT_EQ(made(), 30U);
    EXPECT_EQ(results(), undisturbed(70));
    run(experiment(10));
    EXPECT_EQ(made(), 0U);
    EXPECT_EQ(results(), undisturbed(10));
}

TEST_F(Resuming, AnotherSeedOrParameterOrSamplerVersionMakesAllAgain)
{
    run(experiment(5));
    EXPECT_EQ(made(), 5U);
    const std::vector<std::function<void()>> changes = {[&] { seed_ = 2; }, [&] { radius_ = 0.6; },
                                                        [&] { versions_.sampling = "2"; }};
    for (const auto& change : changes) {
        change();
        run(experiment(5));
        EXPECT_EQ(made(), 5U);
    }
    seed_ = 1;
    radius_ = 0.5;
    versions_.sampling = "1";
    run(experiment(5));
    EXPECT_EQ(made(), 0U) << "what was there first is there still";
}

TEST_F(Resuming, AnotherAnalysisMakesNoPointsAgain)
{
    run(experiment(5));
    EXPECT_EQ(made(), 5U);
    EXPECT_EQ(new_units(), 6U) << "five realizations and an analysis";
    analysis_.bin_width = 2;
    run(experiment(5));
    EXPECT_EQ(new_units(), 1U);
    EXPECT_EQ(results(), undisturbed(5));
    versions_.analysis = "2";
    run(experiment(5));
    EXPECT_EQ(made(), 0U);
    EXPECT_EQ(new_units(), 1U);
    versions_.pictures = "2";
    run(experiment(5));
    EXPECT_EQ(new_units(), 0U) << "there are none";
}

TEST_F(Resuming, TimesAreThoseOfTheMachineAtHand)
{
    const auto times = [&] {
        return nlohmann::json::parse(
                   content_of(folder_.path() / "out/results.json"))["series"][0]["timing"]["sample_seconds"]
            .size();
    };
    Experiment first = experiment(3);
    first.timing_runs = 5;
    run(first);
    EXPECT_EQ(made(), 5U);
    EXPECT_EQ(times(), 5U);
    machine_ = "elsewhere";
    run(first);
    EXPECT_EQ(counts_, (Counts{{0, 5}}));
    EXPECT_EQ(times(), 5U);
    machine_ = "here";
    counts_.clear();
    run(first);
    EXPECT_EQ(made(), 0U);
    EXPECT_EQ(times(), 5U);
}

TEST_F(Resuming, WhatIsDamagedIsMadeAgainAndNothingElse)
{
    run(experiment(40));
    const auto before = results();
    made();
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "out/.units"))
        if (entry.is_regular_file() && entry.file_size() > 0) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ASSERT_GT(files.size(), 80U);
    for (std::size_t i = 0; i < files.size(); i += 7) {
        std::string content = read_whole_file(files[i]);
        content[content.size() / 2] = static_cast<char>(content[content.size() / 2] ^ 1);
        write_whole_file(files[i], content);
        run(experiment(40));
        EXPECT_LE(made(), 1U) << files[i];
        EXPECT_EQ(results(), before) << files[i];
    }
}

TEST_F(Resuming, WhoLacksMemoryIsNamed)
{
    const auto greedy = experiment(3, [](std::uint32_t realization) {
        if (realization == 1) throw std::bad_alloc();
    });
    try {
        run(greedy);
        ADD_FAILURE() << "bad_alloc is lost";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "s: there is not enough memory for this");
    }
}

/// At any moment of a run another one, of the same folder, may do all the rest, and remove what it no longer needs.
TEST_F(Resuming, AnotherRunMayBeFaster)
{
    const auto wanted = undisturbed(70);
    for (const std::uint32_t moment : {0U, 1U, 31U, 32U, 40U, 69U}) {
        bool is_over = false;
        const std::string out = "raced-" + std::to_string(moment);
        run(experiment(70,
                       [&](std::uint32_t realization) {
                           if (realization != moment || is_over) return;
                           is_over = true;
                           run(experiment(70), out);
                       }),
            out);
        EXPECT_EQ(lasting_results(folder_.path() / out), wanted) << moment;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / out / ".units"))
            EXPECT_NE(entry.path().extension(), ".part") << "nobody needs " << entry.path();
    }
}

TEST_F(Resuming, OnlyFirstPointsAreKeptWhereOnlyTheseAreAskedFor)
{
    analysis_.first_points_only = true;
    EXPECT_THROW(run(experiment(70, 40)), Interrupted);
    run(experiment(70));
    EXPECT_EQ(results(), undisturbed(70));
    made();
    run(experiment(70));
    EXPECT_EQ(made(), 0U);
    analysis_.bin_width = 2;
    run(experiment(70));
    EXPECT_EQ(made(), 69U) << "there are no points to analyse but those of the first";
    EXPECT_EQ(results(), undisturbed(70));
}

TEST_F(Resuming, ShardsMakeEachRealizationOnceAndTheLastOneFinishes)
{
    for (const std::uint32_t realizations : {7U, 70U, 300U}) {
        for (std::uint32_t shard = 1; shard <= 3; ++shard) {
            run(experiment(realizations), "out", Shard{shard, 3});
            EXPECT_EQ(is_complete_, shard == 3);
        }
        EXPECT_EQ(counts_.size(), realizations);
        for (const auto& [realization, times] : counts_)
            EXPECT_LE(times, realization == 0 ? 3 : 1) << realization; // all parts need the size of the first
        counts_.clear();
        EXPECT_EQ(results(), undisturbed(realizations)) << realizations;
        fs::remove_all(folder_.path() / "out");
    }
}

TEST_F(Resuming, SeriesOfTheSamePointSetsShareThem)
{
    RunSettings settings;
    settings.units = folder_.path() / "out/.units";
    Progress progress(Progress::Style::quiet);
    const auto crew = make_crew_of_one();
    Experiment zone = experiment(5);
    zone.analysis.zone_plate = true;
    const std::vector<PlannedRun> runs = {{experiment(5), folder_.path() / "out/a"},
                                          {zone, folder_.path() / "out/b"},
                                          {experiment(8), folder_.path() / "out/c"}};
    run_experiments(runs, settings, *crew, progress).raise_failures();
    EXPECT_EQ(made(), 8U);
    const auto a = folder_.path() / "out/a/s/realization-000.dat";
    EXPECT_TRUE(fs::equivalent(a, folder_.path() / "out/b/s/realization-000.dat"));
    EXPECT_TRUE(fs::exists(folder_.path() / "out/b/s/zone-plate.exr"));
}

}
}
