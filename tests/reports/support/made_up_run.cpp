#include "tests/reports/support/made_up_run.hpp"

#include "analysis/statistics/welch.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace poissonlab::test {

namespace {

using Json = nlohmann::json;

/// K values about a mean.
class Scatter
{
public:
    Scatter(std::uint64_t seed, const MadeUpSeries& series)
        : random_(seed * 1000003 + std::hash<std::string>{}(series.name)), series_(series)
    {}

    std::vector<double> around(double mean, double relative)
    {
        std::vector<double> values(static_cast<std::size_t>(series_.realizations));
        for (double& v : values) v = series_.deterministic ? mean : mean * (1 + relative * normal_(random_));
        return values;
    }

private:
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
    const MadeUpSeries& series_;
};

Json statistic_of(const std::vector<double>& each)
{
    const auto [low, high] = std::ranges::minmax(each);
    return {{"min", low}, {"mean", sample_mean(each).value}, {"max", high}, {"each", each}};
}

/// 100 frequencies that rise to 1, and as many distances.
void write_curves(const std::filesystem::path& folder, const MadeUpSeries& series, Scatter& scatter)
{
    std::string radial = "frequency,power,anisotropy_db,samples,power_error\n";
    std::string pairs = "distance,pair_correlation,standard_error,pairs\n";
    for (int k = 1; k <= 100; ++k) {
        const auto power = sample_mean(scatter.around(series.power * std::min(1.0, 0.02 * k), 0.1));
        radial += fmt::format("{},{},-10,{},{}\n", k, power.value, 6 * k, power.standard_error);
        const auto g = sample_mean(scatter.around(k < 20 ? 0 : 1, 0.1));
        pairs += fmt::format("{},{},{},1000\n", 0.001 * k, g.value, g.standard_error);
    }
    write_whole_file(folder / "radial.csv", radial);
    write_whole_file(folder / "pair-correlation.csv", pairs);
}

Json write_series(const std::filesystem::path& folder, const MadeUpSeries& series, std::uint64_t seed)
{
    std::filesystem::create_directories(folder / series.name);
    write_whole_file(folder / series.name / "realization-000.dat", "0.5 0.5\n");
    Scatter scatter(seed, series);
    const auto radius = scatter.around(series.relative_radius, 0.01);
    const auto nyquist = scatter.around(series.effective_nyquist, 0.01 / series.effective_nyquist);
    write_curves(folder / series.name, series, scatter);
    Json measures = {{"effective_nyquist", nyquist.front()},
                     {"largest_empty", {{"relative_radius", 0.8 + 0.01 * nyquist.back()}}}};
    if (series.realizations > 1 && !series.deterministic) measures["effective_nyquist_standard_error"] = 0.01;
    return {{"name", series.name},
            {"label", series.name},
            {"sampler", series.sampler},
            {"parameters", Json::object()},
            {"deterministic", series.deterministic},
            {"points", 16384},
            {"realizations", series.realizations},
            {"relative_radius", statistic_of(radius)},
            {"measures", measures},
            {"radial", {{"file", series.name + "/radial.csv"}, {"background_anisotropy_db", -10}}},
            {"pair_correlation", {{"file", series.name + "/pair-correlation.csv"}}},
            {"point_files", {series.name + "/realization-000.dat"}},
            {"timing", {{"sample_seconds", series.seconds}, {"build_seconds", 0.1}}}};
}

}

Json write_made_up_run(const std::filesystem::path& folder, const MadeUpRun& run)
{
    Json series = Json::array();
    for (const auto& entry : run.series) series.push_back(write_series(folder, entry, run.seed));
    Json results = {{"format", "poissonlab-results"},
                    {"format_version", 1},
                    {"version", run.version},
                    {"title", "Made up"},
                    {"command", "poissonlab run made-up.toml"},
                    {"config", "title = \"Made up\"\n"},
                    {"overrides", Json::array()},
                    {"seed", run.seed},
                    {"engine", "opencl"},
                    {"dimension", 2},
                    {"realizations", 10},
                    {"machine", {{"device", run.device}, {"threads", run.threads}}},
                    {"series", series}};
    write_whole_file(folder / "results.json", results.dump(1));
    return results;
}

void write_made_up_collection(const std::filesystem::path& folder, const std::vector<std::string>& runs)
{
    const Json json = {{"format", "poissonlab-collection"},
                       {"format_version", 1},
                       {"title", "Made up"},
                       {"command", "poissonlab run all.toml"},
                       {"runs", runs}};
    write_whole_file(folder / "collection.json", json.dump(1));
}

}
