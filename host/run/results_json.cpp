#include "host/run/results_json.hpp"

#include "analysis/spectra/radial_statistics.hpp"
#include "results/iteration_records.hpp"
#include "version.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace poissonlab {
namespace {

using Json = nlohmann::ordered_json;

/// min, mean, max and each; null when a realization has no such value (a single point has no distance).
Json spread(const std::vector<double>& each)
{
    if (each.empty() || !std::ranges::all_of(each, [](double v) { return std::isfinite(v); })) return nullptr;
    const double mean = std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size());
    return {{"min", *std::ranges::min_element(each)},
            {"mean", mean},
            {"max", *std::ranges::max_element(each)},
            {"each", each}};
}

/// Where the iterations are stored and what they come to; null where a value is not finite (a single point
/// has no relative radius).
Json iterations_json(const SeriesTask& task, const IterationRecords& records)
{
    const auto values = [&](double IterationRecord::*member) {
        const IterationSpread spread = spread_over_realizations(records, member);
        return Json{{"min", spread.min}, {"mean", spread.mean}, {"max", spread.max}};
    };
    for (const auto& realization : records)
        for (const IterationRecord& record : realization)
            if (!std::isfinite(record.relative_radius) || !std::isfinite(record.energy)) return nullptr;
    return {{"file", task.name + "/iterations.csv"},
            {"realizations", realizations_that_got_there(records)},
            {"relative_radius", values(&IterationRecord::relative_radius)},
            {"energy", values(&IterationRecord::energy)}};
}

/// The sampling test: where picture and curve are stored, and the errors.
Json zone_plate_json(const SeriesTask& task, const ZonePlateResult& result)
{
    return {{"size", result.size},
            {"file", task.name + "/zone-plate.exr"},
            {"error_file", task.name + "/zone-plate.csv"},
            {"rms_error", spread(result.rms_error)},
            {"resolved_rms_error", spread(result.resolved_rms_error)}};
}

Json parameters_json(const Parameters& parameters);

/// Values as they are; a sampler as the object of its name and parameters.
struct ValueToJson
{
    template <typename Value>
    Json operator()(const Value& value) const
    {
        return value;
    }
    Json operator()(const std::shared_ptr<const SamplerChoice>& choice) const
    {
        Json json = {{"sampler", choice->spec->name}};
        json.update(parameters_json(choice->parameters));
        return json;
    }
};

Json parameters_json(const Parameters& parameters)
{
    Json json = Json::object();
    for (const auto& [key, entry] : parameters.given()) json[key] = std::visit(ValueToJson{}, entry.value);
    return json;
}

/// The values of parameters that were not given, in samplers among the parameters as well.
Json defaults_json(const Parameters& parameters)
{
    Json json = Json::object();
    const auto add_those_of = [&](const std::string& key, const ParameterValue& value) {
        if (const SamplerChoice* sampler = as_sampler(value))
            if (const Json inner = defaults_json(sampler->parameters); !inner.empty()) json[key].update(inner);
    };
    for (const auto& [key, value] : parameters.defaults()) {
        json[key] = std::visit(ValueToJson{}, value);
        add_those_of(key, value);
    }
    for (const auto& [key, entry] : parameters.given()) add_those_of(key, entry.value);
    return json;
}

Json machine_json(const Machine& machine)
{
    Json json = Json::object();
    const auto add = [&](const char* key, const auto& value) {
        if (value != std::remove_cvref_t<decltype(value)>{}) json[key] = value;
    };
    add("device", machine.device);
    add("platform", machine.platform);
    add("driver", machine.driver);
    add("device_version", machine.device_version);
    add("compute_units", machine.compute_units);
    add("threads", machine.threads);
    add("processes", machine.processes);
    return json;
}

Json measures_json(const SeriesMeasures& measures, int realizations)
{
    Json json = Json::object();
    if (measures.effective_nyquist) json["effective_nyquist"] = *measures.effective_nyquist;
    if (measures.effective_nyquist_error) json["effective_nyquist_standard_error"] = *measures.effective_nyquist_error;
    if (const auto& o = measures.oscillation)
        json["oscillation"] = {
            {"value", o->value}, {"noise_floor", o->noise_floor}, {"begin", o->begin}, {"end", o->end}};
    if (measures.oscillation_error) json["oscillation"]["standard_error"] = *measures.oscillation_error;
    if (const auto& peak = measures.peak_anisotropy) {
        json["peak_anisotropy"] = {{"db", peak->db}, {"frequency", peak->frequency}, {"samples", peak->samples}};
        if (realizations > 1) json["peak_anisotropy"]["standard_error_db"] = peak->standard_error_db;
    }
    if (const auto& low = measures.low_frequency_power)
        json["low_frequency_power"] = {
            {"exponent", low->exponent},   {"exponent_standard_error", low->exponent_standard_error},
            {"intercept", low->intercept}, {"intercept_standard_error", low->intercept_standard_error},
            {"begin", low->begin},         {"end", low->end}};
    if (const auto& peaks = measures.lattice_peaks)
        json["lattice_peaks"] = {{"tiles", peaks->tiles},
                                 {"max_ratio", peaks->max_ratio},
                                 {"mean_ratio", peaks->mean_ratio},
                                 {"frequency", peaks->frequency},
                                 {"peaks", peaks->peaks}};
    if (measures.lattice_peaks_error)
        json["lattice_peaks"]["mean_ratio_standard_error"] = *measures.lattice_peaks_error;
    for (const IntegrationError& error : measures.integration)
        json["integration"].push_back({{"integrand", error.integrand},
                                       {"integral", error.integral},
                                       {"rms_error", error.rms_error},
                                       {"standard_error", error.standard_error},
                                       {"relative_variance", error.relative_variance}});
    if (measures.packing_fraction) json["packing_fraction"] = *measures.packing_fraction;
    if (const auto& gap = measures.largest_empty)
        json["largest_empty"] = {{"radius", gap->radius}, {"relative_radius", gap->relative_radius}};
    if (const auto& cells = measures.voronoi)
        json["voronoi"] = {{"relative_area_variance", cells->relative_area_variance},
                           {"neighbour_share", cells->neighbour_share}};
    return json;
}

/// The tile set of a series, and what it took to build it where that is known.
Json tile_set_json(const TileSetRecord& record)
{
    Json json = {{"tiles", record.tiles}, {"points_per_tile", record.points_per_tile}, {"cached", record.cached}};
    constexpr std::array in_plane{"corners", "edges", "interior"};
    constexpr std::array in_space{"corners", "edges", "faces", "interior"};
    for (std::size_t i = 0; i < record.regions.size(); ++i) {
        const char* name = record.regions.size() == in_plane.size() ? in_plane[i] : in_space[i];
        json["regions"][name] = {{"points", record.regions[i].mean}, {"expected", record.regions[i].expected}};
    }
    if (!record.build) return json;
    json["build_seconds"] = record.build->seconds;
    if (!record.build->device.empty()) json["device"] = record.build->device;
    json["threads"] = record.build->threads;
    return json;
}

/// A method as a grid of series.
Json method_json(const MethodGrid& grid)
{
    Json axes = Json::array();
    for (const MethodAxis& axis : grid.axes)
        axes.push_back({{"key", axis.key}, {"symbol", axis.symbol}, {"values", axis.values}});
    return {{"sampler", grid.sampler}, {"label", grid.label}, {"axes", axes}};
}

Json series_json(const SeriesTask& task, const SeriesResult& result, bool has_volume)
{
    const auto count = static_cast<int>(result.points.size());
    const auto total = std::accumulate(result.points.begin(), result.points.end(), std::size_t{0});
    const bool estimate = count > 1 && !task.deterministic;
    Json json;
    json["name"] = task.name;
    json["label"] = task.label;
    json["sampler"] = task.sampler;
    json["parameters"] = parameters_json(task.parameters);
    if (Json defaults = defaults_json(task.parameters); !defaults.empty()) json["defaults"] = std::move(defaults);
    if (task.place) {
        json["method"] = task.place->method;
        json["place"] = task.place->indices;
    }
    json["deterministic"] = task.deterministic;
    // Sets of a method that does not hit the number of points exactly differ: their mean, and each.
    json["points"] = count > 0 ? (total + count / 2) / count : 0;
    if (std::ranges::adjacent_find(result.points, std::ranges::not_equal_to{}) != result.points.end())
        json["points_each"] = result.points;
    json["realizations"] = count;
    json["min_distance"] = spread(result.min_distance);
    json["relative_radius"] = spread(result.relative_radius);
    json["covered_fraction"] = spread(result.covered_fraction);
    json["measures"] = measures_json(result.measures, count);
    if (result.spectrum_size > 0) {
        json["spectrum"] = {{"kind", estimate ? "power spectrum estimate" : "periodogram"},
                            {"size", result.spectrum_size},
                            {"file", task.name + "/spectrum.exr"}};
        if (has_volume) json["spectrum"]["volume_file"] = task.name + "/spectrum-volume.exr";
        json["radial"] = {{"file", task.name + "/radial.csv"},
                          {"background_anisotropy_db", background_anisotropy_db(count) + 0.0}} /* no -0 */;
    }
    if (result.has_pair_correlation) json["pair_correlation"] = {{"file", task.name + "/pair-correlation.csv"}};
    if (!result.iterations.empty()) json["iterations"] = iterations_json(task, result.iterations);
    if (result.zone_plate) json["zone_plate"] = zone_plate_json(task, *result.zone_plate);
    json["point_files"] = result.point_files;
    if (result.tile_set) json["tile_set"] = tile_set_json(*result.tile_set);
    json["timing"] = {{"sample_seconds", result.sample_seconds},
                      {"build_seconds", result.build_seconds},
                      {"preparation_seconds", result.preparation_seconds},
                      {"analysis_seconds", result.analysis_seconds}};
    return json;
}

Json frequency_json(const FrequencyTest& test) { return {{"chi_square", test.chi_square}, {"p_value", test.p_value}}; }

Json statistics_json(const TilingTask& task, const TilingStatistics& statistics)
{
    Json json = {{"size", statistics_size}, {"samples", statistics.samples}};
    if (statistics.tiles) json["tile_frequencies"] = frequency_json(*statistics.tiles);
    for (const ColorStatistics& colors : statistics.colors) {
        const ColorAutocorrelation& autocorrelation = colors.autocorrelation;
        json["colors"].push_back({{"name", colors.name},
                                  {"counts", colors.counts},
                                  {"frequencies", frequency_json(colors.frequencies)},
                                  {"autocorrelation",
                                   {{"file", task.name + "/" + autocorrelation_file(colors)},
                                    {"lags", autocorrelation.lags},
                                    {"largest", autocorrelation.largest},
                                    {"largest_at", autocorrelation.largest_at},
                                    {"bound", autocorrelation.bound}}}});
    }
    return json;
}

/// After how many tiles the hash function of a direct tiling repeats along x and y; 0: not at all.
Json hash_period_json(const TilingRequest& request)
{
    const HashPeriod period =
        period_of(request.kind == TileKind::cube ? make_color_hash(request.hash, request.colors, request.seed)
                                                 : make_direct_tiling(request).hash());
    return {period.x, period.y};
}

Json tiling_json(const TilingTask& task, const std::optional<TilingStatistics>& statistics)
{
    const TilingConfig& config = task.config;
    const TilingRequest& request = config.request;
    const TileSet set =
        config.is_set() ? make_tile_set(request.kind, request.colors, config.set) : tile_set_of(request);
    const CubeWindow& w = config.window;
    const bool cube = request.kind == TileKind::cube;
    Json json = {{"name", task.name},
                 {"label", config.label},
                 {"kind", tile_kinds[request.kind]},
                 {"colors", set.colors().horizontal},
                 {"tiles", set.size()},
                 {"file", task.name + "/tiles.txt"}};
    if (config.regions > 0) json["regions"] = config.regions;
    if (config.is_set()) {
        json["set"] = config.set;
        return json;
    }
    json["algorithm"] = request.algorithm;
    json["window"] = cube ? Json{w.x, w.y, w.z, w.width, w.height, w.depth} : Json{w.x, w.y, w.width, w.height};
    if (!request.is_scanline()) {
        json["hash"] = hash_names().at(static_cast<std::size_t>(request.hash));
        json["hash_period"] = hash_period_json(request);
        json["period"] = {request.period.x, request.period.y, request.period.z};
    }
    if (statistics) json["statistics"] = statistics_json(task, *statistics);
    return json;
}

Json construction_json(const ConstructionTask& task, const SceneSummary& scene)
{
    const ConstructionConfig& config = task.config;
    const PoissonTileParameters& p = config.parameters;
    Json points = Json::object();
    for (std::size_t i = 0; i < scene.points.size(); ++i)
        if (scene.points[i] > 0) points[point_class_names[i]] = scene.points[i];
    return {{"name", task.name},
            {"label", config.label},
            {"kind", kind_name(p)},
            {"show", config.show},
            {"colors", p.colors},
            {"tiles", p.tiles},
            {"points_per_tile", p.points_per_tile},
            {"relative_radius", p.relative_radius},
            {"filling", p.filling == TileFilling::dart_throwing ? "dart-throwing" : "relaxation-dart-throwing"},
            {"lloyd_iterations", p.lloyd_iterations},
            {"repulsion", p.repulsion},
            {"seed", p.seed},
            {"file", task.name + "/construction.json"},
            {"panels", scene.panels},
            {"points", points}};
}

}

std::string results_json(const Experiment& experiment, const std::vector<SeriesResult>& results, const Machine& machine,
                         const std::vector<std::optional<TilingStatistics>>& statistics,
                         const std::vector<SceneSummary>& scenes)
{
    Json json;
    json["format"] = "poissonlab-results";
    json["format_version"] = 1;
    json["version"] = POISSONLAB_VERSION_STRING;
    json["title"] = experiment.title;
    json["command"] = experiment.command;
    json["config"] = experiment.config;
    json["overrides"] = experiment.overrides;
    // Members without a value are left out, as in "machine".
    if (experiment.seed) json["seed"] = *experiment.seed;
    if (!experiment.engine.empty()) json["engine"] = experiment.engine;
    json["dimension"] = experiment.dimension;
    json["realizations"] = experiment.realizations;
    json["machine"] = machine_json(machine);
    for (const MethodGrid& grid : experiment.methods) json["methods"].push_back(method_json(grid));
    json["series"] = Json::array();
    for (std::size_t i = 0; i < results.size(); ++i)
        json["series"].push_back(series_json(experiment.series[i], results[i], experiment.analysis.volume));
    for (std::size_t i = 0; i < experiment.tilings.size(); ++i)
        json["tilings"].push_back(tiling_json(experiment.tilings[i], statistics.at(i)));
    for (std::size_t i = 0; i < experiment.constructions.size(); ++i)
        json["constructions"].push_back(construction_json(experiment.constructions[i], scenes.at(i)));
    // Arguments can hold any bytes; JSON is UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}
