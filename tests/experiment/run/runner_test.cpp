// Whole runs inside the process, with samplers made for the test.
#include "experiment/run/runner.hpp"

#include "analysis/spectra/spectrum_file.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "results/curve_tables.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

/// Calls a function for each set.
class FunctionSampler : public Sampler
{
public:
    using Make = std::function<PointSet(std::uint32_t)>;
    FunctionSampler(Make make, bool sizes_vary) : make_(std::move(make)), sizes_vary_(sizes_vary) {}
    PointSet sample(std::uint32_t realization) override { return make_(realization); }
    SetTraits traits() const override { return {.sizes_vary = sizes_vary_}; }

private:
    Make make_;
    bool sizes_vary_;
};

SamplerSpec test_sampler()
{
    SamplerSpec spec;
    spec.name = "test";
    return spec;
}

SeriesTask task(const std::string& name, std::uint32_t realizations, FunctionSampler::Make make,
                bool sizes_vary = false)
{
    SeriesTask result;
    result.name = name;
    result.label = name;
    static const SamplerSpec sampler = test_sampler();
    result.sampler = &sampler;
    result.realizations = realizations;
    result.create = [make, sizes_vary] { return std::make_unique<FunctionSampler>(make, sizes_vary); };
    return result;
}

/// `count` points on a diagonal, moved a little by the realization.
PointSet diagonal(std::size_t count, std::uint32_t realization)
{
    PointSet points;
    for (std::size_t i = 0; i < count; ++i)
        for (int d = 0; d < 2; ++d)
            points.coordinates.push_back((static_cast<double>(i) + 0.25) / static_cast<double>(count + realization));
    return points;
}

Experiment experiment_of(std::vector<SeriesTask> tasks)
{
    Experiment experiment;
    experiment.title = std::string("T");
    experiment.seed = 1;
    experiment.engine = "reference";
    experiment.realizations = 2;
    experiment.series = std::move(tasks);
    return experiment;
}

void run(const Experiment& experiment, const std::filesystem::path& out)
{
    Progress progress(Progress::Style::quiet);
    run_experiment(experiment, out, progress);
}

TEST(Runner, AveragesPeriodogramsInOrder)
{
    const TemporaryFolder folder;
    run(experiment_of({task("s", 3, [](std::uint32_t k) { return diagonal(16, k); })}), folder.path());
    SpectrumEstimate estimate(2, spectrum_size(16, 2));
    for (std::uint32_t k = 0; k < 3; ++k) estimate.add(diagonal(16, k));
    const Spectrum expected = estimate.mean();
    const Spectrum stored = read_spectrum_planes(folder.path() / "s/spectrum.exr").at(0);
    ASSERT_EQ(stored.size, expected.size);
    EXPECT_EQ(stored.realizations, 3);
    EXPECT_EQ(stored.points, 16U);
    for (std::size_t i = 0; i < expected.power.size(); ++i)
        EXPECT_FLOAT_EQ(static_cast<float>(stored.power[i]), static_cast<float>(expected.power[i]));
}

/// Points of a square lattice, 1/side apart.
PointSet lattice(std::size_t side)
{
    PointSet points;
    for (std::size_t i = 0; i < side * side; ++i)
        for (const std::size_t k : {i % side, i / side})
            points.coordinates.push_back((static_cast<double>(k) + 0.25) / static_cast<double>(side));
    return points;
}

/// The size of the spectrum follows from the number of points: beyond 169,000 it is 4,096.
TEST(Runner, StoresLargeSpectraAsMeansOverBlocksUnlessAllIsAskedFor)
{
    const TemporaryFolder folder;
    Experiment experiment = experiment_of({task("s", 1, [](std::uint32_t) { return lattice(420); })});
    experiment.analysis.distances_only = true;
    const auto stored = [&](const char* name) {
        run(experiment, folder.path() / name);
        return read_spectrum_planes(folder.path() / name / "s/spectrum.exr").at(0);
    };
    const Spectrum means = stored("means");
    experiment.analysis.keep_spectrum = true;
    const Spectrum all = stored("all");
    ASSERT_EQ(all.size, 2 * largest_stored_spectrum);
    ASSERT_EQ(means.size, largest_stored_spectrum);
    const int half = largest_stored_spectrum / 2;
    for (int y = -half; y < half; y += 7)
        for (int x = -half; x < half; x += 7) {
            if (x == 0 && y == 0) continue; // its block has frequency (0, 0), which is left out
            const double sum = all.at(2 * x, 2 * y) + all.at(2 * x + 1, 2 * y) + all.at(2 * x, 2 * y + 1) +
                               all.at(2 * x + 1, 2 * y + 1);
            ASSERT_NEAR(means.at(x, y), sum / 4, 1e-6 * sum) << x << ", " << y; // float32
        }
}

TEST(Runner, StoresASpectrumOfAGivenSizeWhole)
{
    const TemporaryFolder folder;
    Experiment experiment = experiment_of({task("s", 1, [](std::uint32_t) { return diagonal(16, 0); })});
    experiment.analysis.spectrum_size = largest_stored_spectrum + 2;
    run(experiment, folder.path());
    EXPECT_EQ(read_spectrum_planes(folder.path() / "s/spectrum.exr").at(0).size, largest_stored_spectrum + 2);
}

TEST(Runner, StoresPairCorrelationsOfAllSets)
{
    const TemporaryFolder folder;
    run(experiment_of({task("s", 2, [](std::uint32_t k) { return diagonal(100, k); })}), folder.path());
    const std::string table = content_of(folder.path() / "s/pair-correlation.csv");
    PairCorrelationEstimate expected(2, 4 * max_min_distance(100, 2), 200);
    for (std::uint32_t k = 0; k < 2; ++k) expected.add(diagonal(100, k));
    EXPECT_EQ(table, pair_correlation_csv(expected.mean()));
}

/// Five sets in seventy realizations, of which the second part has two new ones and the third none.
TEST(Runner, SetsThatComeAgainCountOnce)
{
    const TemporaryFolder folder;
    const auto set_of = [](std::uint32_t k) { return diagonal(16, k < 40 ? k % 3 : k % 5); };
    run(experiment_of({task("s", 70, set_of)}), folder.path());
    const auto series = nlohmann::json::parse(content_of(folder.path() / "results.json"))["series"][0];
    EXPECT_EQ(series["realizations"], 5);
    EXPECT_EQ(series["repeated_realizations"].size(), 65U);
    EXPECT_EQ(series["relative_radius"]["each"].size(), 5U);
    EXPECT_EQ(series["point_files"],
              nlohmann::json({"s/realization-000.dat", "s/realization-001.dat", "s/realization-002.dat",
                              "s/realization-043.dat", "s/realization-044.dat"}));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "s/realization-003.dat"));
    SpectrumEstimate estimate(2, spectrum_size(16, 2));
    for (std::uint32_t k = 0; k < 5; ++k) estimate.add(diagonal(16, k));
    const Spectrum expected = estimate.mean();
    const Spectrum stored = read_spectrum_planes(folder.path() / "s/spectrum.exr").at(0);
    EXPECT_EQ(stored.realizations, 5);
    for (std::size_t i = 0; i < expected.power.size(); ++i)
        EXPECT_FLOAT_EQ(static_cast<float>(stored.power[i]), static_cast<float>(expected.power[i]));
}

TEST(Runner, SizesMayVaryWhereTheSamplerSaysSo)
{
    const TemporaryFolder folder;
    run(experiment_of({task(
            "s", 2, [](std::uint32_t k) { return diagonal(16 + k, k); }, true)}),
        folder.path());
    const auto json = nlohmann::json::parse(content_of(folder.path() / "results.json"));
    EXPECT_EQ(json["series"][0]["points_each"], nlohmann::json({16, 17}));

    const auto mistake = experiment_of({task("s", 2, [](std::uint32_t k) { return diagonal(16 + k, k); })});
    EXPECT_EQ(message_of([&] { run(mistake, folder.path() / "mistake"); }),
              "s: realization 1 has 17 points where the first has 16");
}

TEST(Runner, AnnuliMustFitIntoTheSpectrum)
{
    const TemporaryFolder folder;
    Experiment experiment = experiment_of({task("s", 1, [](std::uint32_t) { return diagonal(16, 0); })});
    experiment.analysis.spectrum_size = 8;
    experiment.analysis.bin_width = 3;
    run(experiment, folder.path());
    experiment.analysis.bin_width = 3.5;
    EXPECT_EQ(message_of([&] { run(experiment, folder.path()); }),
              "s: bin_width = 3.5: must be at most 3, so that one annulus fits into the spectrum of size 8");
}

TEST(Runner, SetsThatCannotBeAnalysed)
{
    const TemporaryFolder folder;
    const auto empty = experiment_of({task("s", 1, [](std::uint32_t) { return PointSet{}; })});
    EXPECT_EQ(message_of([&] { run(empty, folder.path()); }), "s: realization 0 has no points");
    const auto mixed = experiment_of({task("s", 2, [](std::uint32_t k) {
        return k == 0 ? diagonal(1, 0) : PointSet{3, {0.1, 0.2, 0.3}};
    })});
    EXPECT_EQ(message_of([&] { run(mixed, folder.path()); }), "s: realization 1 has dimension 3 where the first has 2");
}

TEST(Runner, LeavesOutWhatIsNotAskedFor)
{
    const TemporaryFolder folder;
    Experiment experiment = experiment_of({task("s", 3, [](std::uint32_t k) { return diagonal(100, k); })});
    run(experiment, folder.path() / "all");
    experiment.analysis.spectrum.reset();
    experiment.analysis.distances_only = true;
    experiment.analysis.first_points_only = true;
    experiment.analysis.zone_plate = true;
    run(experiment, folder.path() / "few");
    const auto files = files_below(folder.path() / "few/s");
    std::vector<std::string> names;
    for (const auto& [name, content] : files) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"number-variance.csv", "realization-000.dat", "zone-plate.csv",
                                               "zone-plate.exr"}));

    const auto series_of = [&](const char* name) {
        return nlohmann::json::parse(content_of(folder.path() / name / "results.json"))["series"][0];
    };
    const auto all = series_of("all"), few = series_of("few");
    EXPECT_EQ(few["point_files"], nlohmann::json({"s/realization-000.dat"}));
    EXPECT_EQ(few["realizations"], 3);
    EXPECT_EQ(few["measures"].size(), 2) << few["measures"];
    for (const char* key : {"mean_nearest_distance", "mean_nearest_distance_standard_error"})
        EXPECT_EQ(few["measures"][key], all["measures"][key]) << key;
    for (const char* member : {"spectrum", "radial", "pair_correlation"}) {
        EXPECT_TRUE(all.contains(member)) << member;
        EXPECT_FALSE(few.contains(member)) << member;
    }
    for (const char* member : {"points", "min_distance", "relative_radius", "covered_fraction"})
        EXPECT_EQ(few[member], all[member]) << member;
}

TEST(Runner, TimesTheFirstRealizationAgainWhereThereAreFew)
{
    const TemporaryFolder folder;
    std::vector<std::uint32_t> asked;
    const auto remember = [&](std::uint32_t k) {
        asked.push_back(k);
        return diagonal(16, k);
    };
    Experiment experiment = experiment_of({task("s", 2, remember)});
    experiment.timing_runs = 5;
    run(experiment, folder.path());
    EXPECT_EQ(asked, (std::vector<std::uint32_t>{0, 1, 0, 0, 0}));
    const auto series = [&] { return nlohmann::json::parse(content_of(folder.path() / "results.json"))["series"][0]; };
    EXPECT_EQ(series()["timing"]["sample_seconds"].size(), 5U);
    EXPECT_EQ(series()["realizations"], 2);
    EXPECT_EQ(series()["relative_radius"]["each"].size(), 2U);

    asked.clear();
    run(experiment, folder.path());
    EXPECT_TRUE(asked.empty()) << "times are kept like all else";
    experiment.timing_runs = 7;
    run(experiment, folder.path());
    EXPECT_EQ(asked, (std::vector<std::uint32_t>{0, 0}));
    asked.clear();
    experiment.timing_runs = 1;
    run(experiment, folder.path() / "once");
    EXPECT_EQ(asked.size(), 2U);
    experiment.timing_runs = 5;
    SamplerSpec of_files = test_sampler();
    of_files.has_own_points = true;
    experiment.series[0].sampler = &of_files;
    run(experiment, folder.path() / "not timed");
    EXPECT_EQ(asked.size(), 4U);
    const auto series_not_timed =
        nlohmann::json::parse(content_of(folder.path() / "not timed/results.json"))["series"][0];
    EXPECT_TRUE(series_not_timed["timing"]["sample_seconds"].empty());
}

TEST(Runner, SetsAreCheckedWithoutSpectraToo)
{
    const TemporaryFolder folder;
    auto mistake = experiment_of({task("s", 2, [](std::uint32_t k) { return diagonal(16 + k, k); })});
    mistake.analysis.spectrum.reset();
    EXPECT_EQ(message_of([&] { run(mistake, folder.path()); }),
              "s: realization 1 has 17 points where the first has 16");
}

TEST(Runner, OnePointIsEnough)
{
    const TemporaryFolder folder;
    run(experiment_of({task("s", 1, [](std::uint32_t) { return diagonal(1, 0); })}), folder.path());
    const auto json = nlohmann::json::parse(content_of(folder.path() / "results.json"));
    EXPECT_TRUE(json["series"][0]["min_distance"].is_null());
    EXPECT_FALSE(json["series"][0].contains("pair_correlation"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "s/pair-correlation.csv"));
}

/// Sets that take as many iterations as their number says, and one more.
class IterativeSampler : public FunctionSampler
{
public:
    IterativeSampler() : FunctionSampler([](std::uint32_t k) { return diagonal(16, k); }, false) {}
    PointSet sample(std::uint32_t realization) override
    {
        records_.clear();
        for (std::uint32_t i = 0; i <= realization + 1; ++i)
            records_.push_back({0.1 * (realization + 1) + 0.01 * i, 0.3 - 0.1 * realization - 0.01 * i});
        return FunctionSampler::sample(realization);
    }
    SetTraits traits() const override { return {.iterations = records_}; }

private:
    std::vector<IterationRecord> records_;
};

TEST(Runner, StoresIterations)
{
    const TemporaryFolder folder;
    SeriesTask iterative = task("s", 2, {});
    iterative.create = [] { return std::make_unique<IterativeSampler>(); };
    const auto plain = task("plain", 1, [](std::uint32_t k) { return diagonal(16, k); });
    run(experiment_of({iterative, plain}), folder.path());

    // 17 significant digits: 0.1 + 0.01 is not 0.11.
    EXPECT_EQ(content_of(folder.path() / "s/iterations.csv"), "realization,iteration,relative_radius,energy\n"
                                                              "0,0,0.10000000000000001,0.29999999999999999\n"
                                                              "0,1,0.11,0.28999999999999998\n"
                                                              "1,0,0.20000000000000001,0.19999999999999998\n"
                                                              "1,1,0.21000000000000002,0.18999999999999997\n"
                                                              "1,2,0.22,0.17999999999999999\n");
    const auto json = nlohmann::json::parse(content_of(folder.path() / "results.json"));
    const auto& iterations = json["series"][0]["iterations"];
    EXPECT_EQ(iterations["file"], "s/iterations.csv");
    EXPECT_EQ(iterations["realizations"], nlohmann::json({2, 2, 1}));
    const auto near = [](const nlohmann::json& values, const std::vector<double>& expected) {
        ASSERT_EQ(values.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(values[i].get<double>(), expected[i], 1e-15);
    };
    near(iterations["relative_radius"]["mean"], {0.15, 0.16, 0.22});
    near(iterations["relative_radius"]["min"], {0.10, 0.11, 0.22});
    near(iterations["energy"]["mean"], {0.25, 0.24, 0.18});
    near(iterations["energy"]["max"], {0.30, 0.29, 0.18});

    EXPECT_FALSE(json["series"][1].contains("iterations"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "plain/iterations.csv"));
}

/// A series whose second set cannot be made.
SeriesTask failing_task(const std::string& name, std::uint32_t realizations = 2)
{
    return task(name, realizations, [](std::uint32_t k) {
        if (k == 1) throw DeviceError("the device is gone");
        return diagonal(16, k);
    });
}

TEST(Runner, ASeriesThatFailsLeavesTheOthers)
{
    const TemporaryFolder folder;
    const auto first = task("first", 2, [](std::uint32_t k) { return diagonal(16, k); });
    const auto last = task("last", 2, [](std::uint32_t k) { return diagonal(16, k + 1); });
    run(experiment_of({first, last}), folder.path() / "without");
    EXPECT_EQ(message_of<DeviceError>([&] {
                  run(experiment_of({first, failing_task("bad"), last, failing_task("long", 100)}), folder.path());
              }),
              "the device is gone; 2 of 4 could not be made: bad, long");
    const auto json = nlohmann::json::parse(content_of(folder.path() / "results.json"));
    EXPECT_EQ(json["missing"], nlohmann::json({"bad: failed: the device is gone", "long: failed: the device is gone"}));
    ASSERT_EQ(json["series"].size(), 2U);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "bad"));
    for (const char* name : {"first", "last"})
        EXPECT_EQ(files_below(folder.path() / name), files_below(folder.path() / "without" / name)) << name;
}

TEST(Runner, WhereNothingCanBeMadeThePreviousResultStays)
{
    const TemporaryFolder folder;
    run(experiment_of({task("good", 2, [](std::uint32_t k) { return diagonal(16, k); })}), folder.path());
    const auto before = files_below(folder.path());
    EXPECT_EQ(message_of<DeviceError>([&] { run(experiment_of({failing_task("bad")}), folder.path()); }),
              "the device is gone");
    EXPECT_EQ(files_below(folder.path()), before);
    EXPECT_THROW(run(experiment_of({failing_task("bad"), failing_task("worse")}), folder.path() / "new"), DeviceError);
    EXPECT_TRUE(files_below(folder.path() / "new").empty());
}

/// A full disk is no matter of one series.
TEST(Runner, WhatCannotBeStoredEndsTheRun)
{
    const TemporaryFolder folder;
    const auto good = task("good", 2, [](std::uint32_t k) { return diagonal(16, k); });
    const auto full = task("full", 1, [](std::uint32_t) -> PointSet { throw StorageError("no space is left"); });
    EXPECT_THROW(run(experiment_of({full, good}), folder.path()), StorageError);
    EXPECT_TRUE(files_below(folder.path()).empty());
}

TEST(Runner, ManyRealizationsKeepTheirOrderInNames)
{
    const TemporaryFolder folder;
    run(experiment_of({task("s", 12, [](std::uint32_t k) { return diagonal(2, k); })}), folder.path());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "s/realization-011.dat"));
}

}
}
