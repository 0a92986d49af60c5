#include "experiment/run/run_work.hpp"

#include "analysis/regions/framed_region.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "base/regions/region_source.hpp"
#include "results/file_names.hpp"
#include "results/periodograms.hpp"
#include "version.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

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
    series.sampler = task.sampler->name;
    series.parameters_json = text_of(parameters_json(task.parameters));
    if (const Json defaults = defaults_json(task.parameters); !defaults.empty())
        series.defaults_json = text_of(defaults);
    series.place = task.place;
    series.deterministic = task.deterministic;
    series.device_bytes = task.device_bytes;
    if (series.spectrum_size > 0) {
        const int periodograms = periodograms_of(series);
        series.is_estimate = periodograms > 1 && !task.deterministic;
        series.spectrum_file = folder + file_names::spectrum;
        if (options.volume) series.volume_file = folder + file_names::spectrum_volume;
        series.radial_file = folder + file_names::radial;
        series.background_anisotropy_db = background_anisotropy_db(periodograms) + 0.0; // no -0
    }
    const auto in_folder = [&](std::string& file) {
        if (!file.empty()) file = folder + file;
    };
    in_folder(series.pair_correlation_file);
    in_folder(series.number_variance_file);
    if (series.folded_density) in_folder(series.folded_density->file);
    if (series.region) {
        series.region->notes = notes_of(options.region->region->own_polygons());
        series.region->name = options.region->region->name(); // equal regions of other names have one analysis
        in_folder(series.region->file);
        in_folder(series.region->picture_file);
    }
    if (series.iterations) in_folder(series.iterations->file);
    if (series.zone_plate) in_folder(series.zone_plate->file);
    if (series.zone_plate) in_folder(series.zone_plate->error_file);
    for (std::string& file : series.point_files) in_folder(file);
    return series;
}

/// True where the spectrum is that of a density as well.
bool follows_density(const Parameters& parameters)
{
    return std::ranges::any_of(parameters.given(), [](const auto& given) {
        return is_followed_density(given.first, to_string(given.second.value));
    });
}

/// Adds a result to the list of its kind, with its name and its files' folder.
class AddExhibit
{
public:
    AddExhibit(const Exhibit& made, Run& into) : exhibit_(made), run_(into) {}

    void operator()(TilingResult result) const
    {
        place(result);
        in_folder(result.file);
        if (result.statistics)
            for (ColorStatistics& colors : result.statistics->colors) in_folder(colors.autocorrelation_file);
        run_.tilings.push_back(std::move(result));
    }
    void operator()(ConstructionResult result) const
    {
        place(result);
        in_folder(result.file);
        run_.constructions.push_back(std::move(result));
    }
    void operator()(DistributionResult result) const
    {
        place(result);
        result.kind = exhibit_.kind->name();
        for (DistributionPicture& picture : result.pictures) in_folder(picture.file);
        for (std::string& file : result.files) in_folder(file);
        (exhibit_.kind->table == "scheme" ? run_.schemes : run_.distributions).push_back(std::move(result));
    }

private:
    const Exhibit& exhibit_;
    Run& run_;

    void place(auto& result) const
    {
        result.name = exhibit_.name;
        result.label = exhibit_.label;
    }
    void in_folder(std::string& file) const { file = exhibit_.name + "/" + file; }
};

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
    run.missing = experiment.left_out;
    run.missing.insert(run.missing.end(), results.failures.begin(), results.failures.end());
    for (std::size_t i = 0; i < results.series.size(); ++i) {
        if (!results.series[i]) continue;
        const SeriesTask& task = experiment.series[i];
        Series& series = run.series.emplace_back(series_of(task, experiment.analysis_of(task), *results.series[i]));
        if (!follows_density(task.parameters)) series.blue_noise = blue_noise_verdict(series, run.dimension);
    }
    for (std::size_t i = 0; i < results.exhibits.size(); ++i)
        if (results.exhibits[i]) std::visit(AddExhibit(experiment.exhibits[i], run), *results.exhibits[i]);
    return run;
}

}
