#include "experiment/run/run_work.hpp"

#include "results/statistic.hpp"

#include "host/settings/sampler_registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace poissonlab {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;

constexpr double infinite = std::numeric_limits<double>::infinity();

Experiment one_series()
{
    Experiment experiment;
    experiment.title = "T";
    experiment.command = "poissonlab run c.toml";
    experiment.config = "title = \"T\"\n";
    experiment.overrides = {"seed=2"};
    experiment.seed = 2;
    experiment.engine = "opencl";
    experiment.realizations = 2;
    SeriesTask task;
    task.name = "n";
    task.label = "L";
    task.sampler = find_sampler("dart-throwing");
    task.parameters.set("relative_radius", 0.7);
    task.parameters.set("stop", std::string("points"));
    experiment.series.push_back(task);
    return experiment;
}

Series two_realizations()
{
    Series result;
    result.set_sizes({64, 64});
    result.min_distance = statistic_of({0.1, 0.3});
    result.relative_radius = statistic_of({0.6, 0.7});
    result.covered_fraction = statistic_of({0.4, 0.5});
    result.spectrum_size = 64;
    result.point_files = {"realization-000.dat", "realization-001.dat"};
    result.sample_seconds = {1.0, 2.0};
    result.build_seconds = 0.5;
    result.analysis_seconds = 3.0;
    return result;
}

json written(const Experiment& experiment, const Series& result, const Machine& machine = {})
{
    return json::parse(run_json(make_run(experiment, {{result}, {}, {}, machine})));
}

TEST(ResultsJson, HasEveryMember)
{
    const json root = written(one_series(), two_realizations(), {"name", "", "", "", 2, 0});
    EXPECT_EQ(root["format"], "poissonlab-results");
    EXPECT_EQ(root["format_version"], 1);
    EXPECT_TRUE(root["version"].is_string());
    EXPECT_EQ(root["title"], "T");
    EXPECT_EQ(root["command"], "poissonlab run c.toml");
    EXPECT_EQ(root["config"], "title = \"T\"\n");
    EXPECT_EQ(root["overrides"], json({"seed=2"}));
    EXPECT_EQ(root["seed"], 2);
    EXPECT_EQ(root["engine"], "opencl");
    EXPECT_EQ(root["dimension"], 2);
    EXPECT_EQ(root["realizations"], 2);
    EXPECT_EQ(root["machine"], json({{"device", "name"}, {"compute_units", 2}})) << "members not used are absent";

    const json& series = root["series"][0];
    EXPECT_EQ(series["name"], "n");
    EXPECT_EQ(series["label"], "L");
    EXPECT_EQ(series["sampler"], "dart-throwing");
    EXPECT_EQ(series["parameters"], json({{"relative_radius", 0.7}, {"stop", "points"}}));
    EXPECT_EQ(series["deterministic"], false);
    EXPECT_EQ(series["points"], 64);
    EXPECT_FALSE(series.contains("points_each"));
    EXPECT_EQ(series["realizations"], 2);
    EXPECT_EQ(series["min_distance"], json({{"min", 0.1}, {"mean", 0.2}, {"max", 0.3}, {"each", {0.1, 0.3}}}));
    EXPECT_EQ(series["relative_radius"]["each"], json({0.6, 0.7}));
    EXPECT_EQ(series["covered_fraction"]["max"], 0.5);
    EXPECT_EQ(series["spectrum"],
              json({{"kind", "power spectrum estimate"}, {"size", 64}, {"file", "n/spectrum.exr"}}));
    EXPECT_EQ(series["radial"]["file"], "n/radial.csv");
    EXPECT_NEAR(series["radial"]["background_anisotropy_db"].get<double>(), -3.0103, 1e-4);
    EXPECT_EQ(series["point_files"].size(), 2U);
    EXPECT_EQ(series["timing"], json({{"sample_seconds", {1.0, 2.0}},
                                      {"build_seconds", 0.5},
                                      {"preparation_seconds", 0.0},
                                      {"analysis_seconds", 3.0}}));
}

TEST(ResultsJson, DeterministicOrSingleSetsHaveAPeriodogram)
{
    Experiment experiment = one_series();
    experiment.series[0].deterministic = true;
    EXPECT_EQ(written(experiment, two_realizations())["series"][0]["spectrum"]["kind"], "periodogram");

    Series one = two_realizations();
    one.set_sizes({64});
    EXPECT_EQ(written(one_series(), one)["series"][0]["spectrum"]["kind"], "periodogram");
}

TEST(ResultsJson, SamplersAmongTheParametersAreObjects)
{
    Experiment experiment = one_series();
    SamplerChoice random{find_sampler("random"), {}};
    SamplerChoice throwing{find_sampler("dart-throwing"), {}};
    throwing.parameters.set("relative_radius", 0.7);
    throwing.parameters.set("start", std::make_shared<const SamplerChoice>(random));
    Parameters& parameters = experiment.series[0].parameters = {};
    parameters.set("repulsion", true);
    parameters.set("start", std::make_shared<const SamplerChoice>(throwing));
    EXPECT_EQ(written(experiment, two_realizations())["series"][0]["parameters"],
              json::parse(R"({"repulsion": true, "start": {"sampler": "dart-throwing", "relative_radius": 0.7,
                                                           "start": {"sampler": "random"}}})"));
}

/// results.json has all values that hold beside the parameters that were given.
TEST(ResultsJson, DefaultsAreStoredBesideWhatWasGiven)
{
    Experiment experiment = one_series();
    SamplerChoice throwing{find_sampler("dart-throwing"), Parameters(find_sampler("dart-throwing")->parameters)};
    throwing.parameters.set("relative_radius", 0.7);
    Parameters& parameters = experiment.series[0].parameters = Parameters(find_sampler("lloyd")->parameters);
    parameters.set("iterations", std::int64_t{3});
    const json by_chance = written(experiment, two_realizations())["series"][0];
    EXPECT_EQ(by_chance["parameters"], json::parse(R"({"iterations": 3})"));
    EXPECT_EQ(by_chance["defaults"],
              json::parse(R"({"keep": "last", "repulsion": false, "start": {"sampler": "random"}})"));

    parameters.set("keep", "best");
    parameters.set("start", std::make_shared<const SamplerChoice>(throwing));
    EXPECT_EQ(written(experiment, two_realizations())["series"][0]["defaults"],
              json::parse(R"({"repulsion": false, "start": {"stop": "points"}})"));
}

TEST(ResultsJson, HasTheGridsOfMethods)
{
    Experiment experiment = one_series();
    const json without = written(experiment, two_realizations());
    EXPECT_FALSE(without.contains("methods"));
    EXPECT_FALSE(without["series"][0].contains("method"));
    experiment.methods = {{"random", "R", {}},
                          {"corner-tiles", "", {{"colors", "C", {"2", "3"}}, {"points_per_tile", "N", {"32", "64"}}}}};
    experiment.series[0].place = GridPlace{1, {1, 0}};
    const json root = written(experiment, two_realizations());
    EXPECT_EQ(root["methods"], json::parse(R"([{"sampler": "random", "label": "R", "axes": []},
        {"sampler": "corner-tiles", "label": "", "axes": [{"key": "colors", "symbol": "C", "values": ["2", "3"]},
                                                          {"key": "points_per_tile", "symbol": "N", "values": ["32", "64"]}]}])"));
    EXPECT_EQ(root["series"][0]["method"], 1);
    EXPECT_EQ(root["series"][0]["place"], json({1, 0}));
}

TEST(ResultsJson, HasTheTileSetOfMethodsThatTile)
{
    Series result = two_realizations();
    EXPECT_FALSE(written(one_series(), result)["series"][0].contains("tile_set"));
    result.tile_set = TileSetRecord{256, 64, true, TileSetBuild{0.25, "d", 2}, {}};
    json expected = json::parse(R"({"tiles": 256, "points_per_tile": 64, "cached": true, "build_seconds": 0.25,
                                    "device": "d", "threads": 2})");
    EXPECT_EQ(written(one_series(), result)["series"][0]["tile_set"], expected);
    result.tile_set->build->device.clear();
    expected.erase("device");
    EXPECT_EQ(written(one_series(), result)["series"][0]["tile_set"], expected) << "the reference engine has none";
    result.tile_set->build.reset();
    EXPECT_EQ(written(one_series(), result)["series"][0]["tile_set"],
              json({{"tiles", 256}, {"points_per_tile", 64}, {"cached", true}}));

    result.tile_set->regions = {{"corners", 3, 3.25}, {"edges", 6, 5.5}, {"interior", 55, 55.25}};
    const json in_plane = written(one_series(), result)["series"][0]["tile_set"]["regions"];
    EXPECT_EQ(in_plane, json::parse(R"({"corners": {"points": 3.0, "expected": 3.25},
                                        "edges": {"points": 6.0, "expected": 5.5},
                                        "interior": {"points": 55.0, "expected": 55.25}})"));
    result.tile_set->regions.push_back({"faces", 1, 1});
    EXPECT_TRUE(written(one_series(), result)["series"][0]["tile_set"]["regions"].contains("faces"));
}

TEST(ResultsJson, HasNoSpectrumWhereThereIsNone)
{
    Series result = two_realizations();
    result.spectrum_size = 0;
    const json series = written(one_series(), result)["series"][0];
    EXPECT_FALSE(series.contains("spectrum"));
    EXPECT_FALSE(series.contains("radial"));
}

TEST(ResultsJson, HasTheSamplingTestWhereThereWasOne)
{
    Series result = two_realizations();
    EXPECT_FALSE(written(one_series(), result)["series"][0].contains("zone_plate"));
    result.zone_plate = ZonePlateResult{8, "zone-plate.exr", "zone-plate.csv", *statistic_of({0.25, 0.75}),
                                        statistic_of({0.125, std::numeric_limits<double>::quiet_NaN()})};
    EXPECT_EQ(written(one_series(), result)["series"][0]["zone_plate"],
              json({{"size", 8},
                    {"file", "n/zone-plate.exr"},
                    {"error_file", "n/zone-plate.csv"},
                    {"rms_error", {{"min", 0.25}, {"mean", 0.5}, {"max", 0.75}, {"each", {0.25, 0.75}}}},
                    {"resolved_rms_error", nullptr}}));
}

TEST(ResultsJson, HasTheMeasuresThatThereAre)
{
    Series result = two_realizations();
    EXPECT_TRUE(written(one_series(), result)["series"][0]["measures"].empty());
    EXPECT_FALSE(written(one_series(), result)["series"][0].contains("pair_correlation"));
    result.pair_correlation_file = "pair-correlation.csv";
    result.measures.lattice_peaks = {8, 12.5, 3.5, {8, -16, 0}, 99};
    result.measures.integration = {{"disk", 0.25, 0.01, 0.001, 0.5}, {"step", 0.5, 0.02, 0.002, 0.75}};
    const json series = written(one_series(), result)["series"][0];
    EXPECT_EQ(series["pair_correlation"], json({{"file", "n/pair-correlation.csv"}}));
    EXPECT_EQ(series["measures"]["lattice_peaks"], json::parse(R"({"tiles": 8, "max_ratio": 12.5, "mean_ratio": 3.5,
                                                                    "frequency": [8, -16, 0], "peaks": 99})"));
    EXPECT_EQ(series["measures"]["integration"].size(), 2);
    EXPECT_EQ(series["measures"]["integration"][1], json({{"integrand", "step"},
                                                          {"integral", 0.5},
                                                          {"rms_error", 0.02},
                                                          {"standard_error", 0.002},
                                                          {"relative_variance", 0.75}}));
}

TEST(ResultsJson, HasStandardErrorsWhereTheyAreKnown)
{
    Series result = two_realizations();
    Measures& m = result.measures;
    m.numbers["effective_nyquist"].value = 0.5;
    m.oscillation = Oscillation{3, 20, 40};
    m.lattice_peaks = LatticePeaks{8, 12.5, 3.5, {8, -16, 0}, 99};
    m.peak_anisotropy = PeakAnisotropy{-6, 33, 200, 0.25};
    const auto measures = [&] { return written(one_series(), result)["series"][0]["measures"]; };
    EXPECT_FALSE(measures().contains("effective_nyquist_standard_error"));
    EXPECT_FALSE(measures()["oscillation"].contains("standard_error"));
    EXPECT_FALSE(measures()["lattice_peaks"].contains("mean_ratio_standard_error"));
    m.numbers["effective_nyquist"].standard_error = 0.01;
    m.oscillation->standard_error = 0.125;
    m.lattice_peaks->mean_ratio_standard_error = 0.5;
    EXPECT_EQ(measures()["effective_nyquist_standard_error"], 0.01);
    EXPECT_EQ(measures()["oscillation"]["standard_error"], 0.125);
    EXPECT_EQ(measures()["lattice_peaks"]["mean_ratio_standard_error"], 0.5);
    EXPECT_EQ(measures()["peak_anisotropy"],
              json({{"db", -6.0}, {"frequency", 33.0}, {"samples", 200}, {"standard_error_db", 0.25}}));
    m.peak_anisotropy->standard_error_db.reset();
    EXPECT_FALSE(measures()["peak_anisotropy"].contains("standard_error_db"));
}

TEST(ResultsJson, SizesThatDifferAreAllThere)
{
    Series result = two_realizations();
    result.set_sizes({63, 66});
    const json series = written(one_series(), result)["series"][0];
    EXPECT_EQ(series["points"], 65) << "the mean, rounded";
    EXPECT_EQ(series["points_each"], json({63, 66}));
}

TEST(ResultsJson, APointHasNoDistance)
{
    Series result = two_realizations();
    result.min_distance = result.relative_radius = result.covered_fraction = statistic_of({infinite, infinite});
    const json series = written(one_series(), result)["series"][0];
    EXPECT_TRUE(series["min_distance"].is_null());
    EXPECT_TRUE(series["relative_radius"].is_null());
    EXPECT_TRUE(series["covered_fraction"].is_null());
}

TEST(ResultsJson, IterationsOfAPointHaveNoMeans)
{
    Series result = two_realizations();
    result.iterations = iterations_of({{{infinite, 0.2}}, {{infinite, 0.2}}});
    EXPECT_TRUE(written(one_series(), result)["series"][0]["iterations"].is_null());
}

TEST(ResultsJson, ImportedSetsHaveNoSeedAndNoEngine)
{
    Experiment experiment = one_series();
    experiment.seed.reset();
    experiment.engine.clear();
    const json root = written(experiment, two_realizations());
    EXPECT_FALSE(root.contains("seed"));
    EXPECT_FALSE(root.contains("engine"));
}

TEST(ResultsJson, TakesAnyBytes)
{
    Experiment experiment = one_series();
    experiment.command = "poissonlab run \xe9.toml";
    EXPECT_EQ(written(experiment, two_realizations())["command"], "poissonlab run \uFFFD.toml");
}

}
}
