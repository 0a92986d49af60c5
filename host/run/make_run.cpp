#include "host/run/make_run.hpp"

#include "analysis/spectra/radial_statistics.hpp"
#include "results/file_names.hpp"
#include "version.hpp"

#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using Json = nlohmann::ordered_json;

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

/// Texts can hold any bytes; JSON is UTF-8.
std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Series series_of(const SeriesTask& task, const AnalysisOptions& options, Series series)
{
    const std::string folder = task.name + "/";
    series.name = task.name;
    series.label = task.label;
    series.sampler = task.sampler;
    series.parameters_json = text_of(parameters_json(task.parameters));
    if (const Json defaults = defaults_json(task.parameters); !defaults.empty())
        series.defaults_json = text_of(defaults);
    series.place = task.place;
    series.deterministic = task.deterministic;
    series.device_bytes = task.device_bytes;
    if (series.spectrum_size > 0) {
        series.is_estimate = series.realizations > 1 && !task.deterministic;
        series.spectrum_file = folder + file_names::spectrum;
        if (options.volume) series.volume_file = folder + file_names::spectrum_volume;
        series.radial_file = folder + file_names::radial;
        series.background_anisotropy_db = background_anisotropy_db(series.realizations) + 0.0; // no -0
    }
    const auto in_folder = [&](std::string& file) {
        if (!file.empty()) file = folder + file;
    };
    in_folder(series.pair_correlation_file);
    in_folder(series.number_variance_file);
    if (series.folded_density) in_folder(series.folded_density->file);
    if (series.iterations) in_folder(series.iterations->file);
    if (series.zone_plate) in_folder(series.zone_plate->file);
    if (series.zone_plate) in_folder(series.zone_plate->error_file);
    for (std::string& file : series.point_files) in_folder(file);
    return series;
}

TilingResult tiling_of(const TilingTask& task, const std::optional<TilingStatistics>& statistics)
{
    const TilingConfig& config = task.config;
    const TilingRequest& request = config.request;
    const TileSet set = tile_set_of(config);
    TilingResult result;
    result.name = task.name;
    result.label = config.label;
    result.kind = request.kind;
    result.colors = set.colors().horizontal;
    if (set.colors().vertical != result.colors) result.vertical_colors = set.colors().vertical;
    result.tiles = set.size();
    result.file = task.name + "/" + file_names::tiles;
    result.regions = config.regions;
    result.set = config.set;
    if (config.is_set()) return result;
    const CubeWindow& w = config.window;
    result.algorithm = request.algorithm;
    result.origin = {w.x, w.y, w.z};
    result.size = {w.width, w.height, w.depth};
    if (request.is_direct()) {
        const HashPeriod period = hash_period_of(request);
        result.hash = hash_names().at(static_cast<std::size_t>(request.hash));
        result.hash_period = {period.x, period.y};
        for (const std::int64_t along : {request.period.x, request.period.y, request.period.z})
            result.period.push_back(static_cast<std::size_t>(along));
    }
    result.statistics = statistics;
    if (statistics)
        for (ColorStatistics& colors : result.statistics->colors)
            colors.autocorrelation_file = task.name + "/" + autocorrelation_file(colors);
    return result;
}

ConstructionResult construction_of(const ConstructionTask& task, const SceneSummary& scene)
{
    const PoissonTileParameters& p = task.config.parameters;
    ConstructionResult result;
    result.name = task.name;
    result.label = task.config.label;
    result.kind = task.config.kind();
    result.show = task.config.show;
    result.colors = p.colors;
    result.tiles = p.tiles;
    result.points_per_tile = p.points_per_tile;
    result.relative_radius = p.relative_radius;
    result.filling = p.filling == TileFilling::dart_throwing ? "dart-throwing" : "relaxation-dart-throwing";
    result.lloyd_iterations = static_cast<int>(p.lloyd_iterations);
    result.repulsion = p.repulsion;
    result.seed = std::to_string(p.seed);
    result.file = task.name + "/" + file_names::construction;
    result.scene = scene;
    return result;
}

DistributionResult distribution_of(const DistributionTask& task, DistributionResult result)
{
    const std::string folder = task.name + "/";
    result.name = task.name;
    result.label = task.config.label;
    result.kind = task.config.kind;
    for (DistributionPicture& picture : result.pictures) picture.file = folder + picture.file;
    for (std::string& file : result.files) file = folder + file;
    return result;
}

}

Run make_run(const Experiment& experiment, const ExperimentResults& results)
{
    Run run;
    run.title = experiment.title;
    run.version = POISSONLAB_VERSION_STRING;
    run.command = experiment.command;
    run.config = experiment.config;
    run.overrides = experiment.overrides;
    if (experiment.seed) run.seed = std::to_string(*experiment.seed);
    run.engine = experiment.engine;
    run.dimension = experiment.dimension;
    run.realizations = static_cast<int>(experiment.realizations);
    run.machine = results.machine;
    run.methods = experiment.methods;
    for (std::size_t i = 0; i < results.series.size(); ++i)
        run.series.push_back(series_of(experiment.series[i], experiment.analysis, results.series[i]));
    for (std::size_t i = 0; i < experiment.tilings.size(); ++i)
        run.tilings.push_back(tiling_of(experiment.tilings[i], results.statistics.at(i)));
    for (std::size_t i = 0; i < experiment.constructions.size(); ++i)
        run.constructions.push_back(construction_of(experiment.constructions[i], results.scenes.at(i)));
    for (std::size_t i = 0; i < experiment.distributions.size(); ++i)
        (experiment.distributions[i].config.is_scheme() ? run.schemes : run.distributions)
            .push_back(distribution_of(experiment.distributions[i], results.distributions.at(i)));
    return run;
}

}
