#include "experiment/runner.hpp"

#include "analysis/radial_statistics.hpp"
#include "analysis/spectrum_file.hpp"
#include "analysis/square_image_file.hpp"
#include "experiment/interrupt.hpp"
#include "experiment/iteration_records.hpp"
#include "experiment/result_folder.hpp"
#include "experiment/result_tables.hpp"
#include "experiment/results_json.hpp"
#include "experiment/series_analysis.hpp"
#include "experiment/tiling_analysis.hpp"
#include "experiment/zone_plate_analysis.hpp"
#include "io/point_file.hpp"
#include "io/whole_file.hpp"
#include "version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

namespace poissonlab {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin)
{
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A point set and how long it took, without the time for building kernels meanwhile.
PointSet timed_sample(Sampler& sampler, std::uint32_t realization, double& seconds)
{
    const double built_before = sampler.build_seconds();
    const auto begin = Clock::now();
    PointSet points = sampler.sample(realization);
    seconds = std::max(0.0, seconds_since(begin) - (sampler.build_seconds() - built_before));
    return points;
}

/// Makes the first realization again until there are `runs` times: few are no median.
void time_more_runs(Sampler& sampler, std::uint32_t runs, std::vector<double>& seconds)
{
    while (seconds.size() < runs) {
        stop_if_interrupted();
        timed_sample(sampler, 0, seconds.emplace_back());
    }
}

/// What identifies the origin of a spectrum or a picture; nothing that differs between two runs of the same
/// config.
std::map<std::string, std::string> image_metadata(const Experiment& experiment, const SeriesTask& task)
{
    std::map<std::string, std::string> metadata = {{"title", experiment.title},
                                                   {"label", task.label},
                                                   {"sampler", task.sampler},
                                                   {"version", POISSONLAB_VERSION_STRING}};
    std::vector<std::string> parameters;
    for (const auto& [key, entry] : task.parameters.entries())
        parameters.push_back(key + " = " + to_string(entry.value));
    const std::map<std::string, std::string> optional = {
        {"parameters", fmt::format("{}", fmt::join(parameters, ", "))},
        {"config", experiment.config},
        {"overrides", fmt::format("{}", fmt::join(experiment.overrides, "\n"))},
        {"seed", experiment.seed ? fmt::format("{}", *experiment.seed) : ""},
        {"engine", experiment.engine}};
    for (const auto& [key, text] : optional)
        if (!text.empty()) metadata[key] = text;
    return metadata;
}

std::string point_file_comment(const Experiment& experiment, const SeriesTask& task,
                               std::uint32_t realization)
{
    const std::string seed = experiment.seed ? fmt::format("seed {}, ", *experiment.seed) : "";
    return fmt::format("{}; {}realization {}", task.label, seed, realization);
}

/// One line for the log: "random: 10 realizations of 16384 points, relative radius 0.012 to 0.034, 0.1 s
/// + 8.0 s ...".
std::string summary(const SeriesTask& task, const SeriesResult& result, double seconds)
{
    const auto [fewest, most] = std::ranges::minmax_element(result.points);
    const auto [smallest, largest] = std::ranges::minmax_element(result.relative_radius);
    const auto count = result.points.size();
    std::string line =
        fmt::format("{}: {} realization{} of {}", task.label, count, count == 1 ? "" : "s", *fewest);
    if (*most != *fewest) line += fmt::format(" to {}", *most);
    line += *most == 1 ? " point" : " points";
    if (std::isfinite(*largest)) {
        line += fmt::format(", relative radius {:.3f}", *smallest);
        if (fmt::format("{:.3f}", *smallest) != fmt::format("{:.3f}", *largest))
            line += fmt::format(" to {:.3f}", *largest);
    }
    return line + ", " + duration_text(seconds);
}

void store_zone_plate(const ZonePlateAnalysis& zone_plate, const std::map<std::string, std::string>& metadata,
                      const std::filesystem::path& folder, SeriesResult& result)
{
    write_square_image(folder / "zone-plate.exr", zone_plate.first_image(), metadata);
    write_whole_file(folder / "zone-plate.csv", zone_plate.csv());
    result.zone_plate = zone_plate.result();
    result.analysis_seconds += zone_plate.seconds();
}

/// Methods that tile know their lattice. A single tile leaves no peaks: every frequency is one of its lattice.
AnalysisOptions analysis_of(const Sampler& sampler, AnalysisOptions options)
{
    if (options.tiles == 0 && sampler.tiles_along_axis() > 1)
        options.tiles = static_cast<int>(sampler.tiles_along_axis());
    return options;
}

/// Stores the mean spectrum, what is measured on it and its curves.
void store_spectrum(SeriesAnalysis& analysis, const AnalysisOptions& options,
                    const std::map<std::string, std::string>& metadata, const std::filesystem::path& folder)
{
    const Spectrum spectrum = analysis.mean_spectrum();
    write_spectrum(folder / "spectrum.exr", spectrum, metadata);
    if (options.volume) write_spectrum_volume(folder / "spectrum-volume.exr", spectrum, metadata);
    write_whole_file(folder / "radial.csv", radial_csv(analysis.radial_curve(spectrum)));
    analysis.measure_spectrum(spectrum);
}

/// Makes, analyses and stores one series in `folder`.
SeriesResult run_series(const Experiment& experiment, const SeriesTask& task,
                        const std::filesystem::path& folder, Progress& progress)
{
    const auto begin = Clock::now();
    const auto sampler = task.create();
    SeriesAnalysis analysis(task.label, sampler->sizes_vary(), analysis_of(*sampler, experiment.analysis));
    ZonePlateAnalysis zone_plate;
    std::vector<std::string> point_files;
    std::vector<double> sample_seconds;
    IterationRecords iterations;
    progress.start_series(task.label, task.realizations);
    for (std::uint32_t k = 0; k < task.realizations; ++k) {
        stop_if_interrupted();
        double seconds = 0;
        const PointSet points = timed_sample(*sampler, k, seconds);
        sample_seconds.push_back(seconds);
        iterations.push_back(sampler->iterations());
        const std::string file = fmt::format("realization-{:03}.dat", k);
        const bool is_stored = k == 0 || !experiment.analysis.first_points_only;
        tbb::parallel_invoke(
            [&] {
                analysis.add(points);
                if (experiment.analysis.zone_plate) zone_plate.add(points);
            },
            [&] {
                if (is_stored) write_points(folder / file, points, point_file_comment(experiment, task, k));
            });
        if (is_stored) point_files.push_back(task.name + "/" + file);
        progress.realization_done(points.size(), seconds);
    }

    if (task.is_timed) time_more_runs(*sampler, experiment.timing_runs, sample_seconds);

    const auto averaging = Clock::now();
    tbb::parallel_invoke(
        [&] {
            if (analysis.has_spectrum())
                store_spectrum(analysis, experiment.analysis, image_metadata(experiment, task), folder);
        },
        [&] { analysis.measure_first(); });
    if (const auto pairs = analysis.pair_correlation(); !pairs.empty())
        write_whole_file(folder / "pair-correlation.csv", pair_correlation_csv(pairs));

    SeriesResult result = analysis.result();
    if (experiment.analysis.zone_plate) store_zone_plate(zone_plate, image_metadata(experiment, task), folder, result);
    if (!realizations_that_got_there(iterations).empty()) {
        write_whole_file(folder / "iterations.csv", iterations_csv(iterations));
        result.iterations = std::move(iterations);
    }
    result.point_files = std::move(point_files);
    if (task.is_timed) result.sample_seconds = std::move(sample_seconds);
    result.tile_set = sampler->tile_set();
    result.build_seconds = sampler->build_seconds();
    result.preparation_seconds = sampler->preparation_seconds();
    result.analysis_seconds += seconds_since(averaging);
    progress.finish_series(summary(task, result, seconds_since(begin)));
    return result;
}

/// Stores the tiles of a set or tiling in `folder` and, where a tiling does not close, what its colours are like.
std::optional<TilingStatistics> run_tiling(const Experiment& experiment, const TilingTask& task,
                                           const std::filesystem::path& folder)
{
    stop_if_interrupted();
    write_whole_file(folder / "tiles.txt", tiles_text(task.config));
    if (task.config.is_set() || task.config.request.period != Period{}) return std::nullopt;
    TilingStatistics statistics = tiling_statistics(task.config);
    const std::map<std::string, std::string> metadata = {{"title", experiment.title},
                                                         {"label", task.config.label},
                                                         {"config", experiment.config},
                                                         {"version", POISSONLAB_VERSION_STRING}};
    for (const ColorStatistics& colors : statistics.colors)
        write_square_image(folder / autocorrelation_file(colors),
                           {2 * statistics_lags + 1, colors.autocorrelation.z}, metadata);
    return statistics;
}

/// Stores what each picture of a construction shows.
std::vector<Scene> run_constructions(const Experiment& experiment, const ResultFolder& folder, Progress& progress)
{
    std::vector<ConstructionConfig> configs;
    for (const ConstructionTask& task : experiment.constructions) configs.push_back(task.config);
    std::vector<Scene> scenes = construct_scenes(configs, experiment.make_filler,
                                                 [&](const std::string& what) { progress.step(what); });
    for (std::size_t i = 0; i < scenes.size(); ++i)
        write_whole_file(folder.series_folder(experiment.constructions[i].name) / "construction.json",
                         scene_json(scenes[i]));
    return scenes;
}

}

std::vector<std::string> folder_names(const Experiment& experiment)
{
    std::vector<std::string> names;
    for (const SeriesTask& task : experiment.series) names.push_back(task.name);
    for (const TilingTask& task : experiment.tilings) names.push_back(task.name);
    for (const ConstructionTask& task : experiment.constructions) names.push_back(task.name);
    return names;
}

void run_experiment(const Experiment& experiment, const std::filesystem::path& out, Progress& progress)
{
    std::uint64_t total = 0;
    for (const SeriesTask& task : experiment.series) total += task.realizations;
    ResultFolder folder(out, folder_names(experiment));
    progress.start(total);
    std::vector<SeriesResult> results;
    for (const SeriesTask& task : experiment.series)
        results.push_back(run_series(experiment, task, folder.series_folder(task.name), progress));
    std::vector<std::optional<TilingStatistics>> tilings;
    for (const TilingTask& task : experiment.tilings)
        tilings.push_back(run_tiling(experiment, task, folder.series_folder(task.name)));
    const std::vector<Scene> scenes = run_constructions(experiment, folder, progress);
    stop_if_interrupted();
    folder.publish(results_json(experiment, results, experiment.machine ? experiment.machine() : Machine{}, tilings,
                                scenes));
}

}
