#include "experiment/config/plan.hpp"

#include "host/sampling/optimized/ordered_sampler.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace poissonlab {
namespace {

DeviceMemory memory_of(const SeriesPlan& series, std::size_t points, const DeviceInfo& device)
{
    SampleRequest request = series.request;
    request.points = points;
    return series.sampler->device_memory(series.parameters, request, device);
}

/// The largest number of points that fits, 0 for none. More points never need less memory.
std::size_t most_points_that_fit(const SeriesPlan& series, const DeviceInfo& device)
{
    std::size_t fitting = 0;
    for (std::size_t beyond = series.request.points; beyond - fitting > 1;) {
        const std::size_t middle = fitting + (beyond - fitting) / 2;
        (fits(memory_of(series, middle, device), device) ? fitting : beyond) = middle;
    }
    return fitting;
}

constexpr std::size_t longest_name = 100;

/// The label of a series, such as "Dart throwing, rho = 0.70": the user's label and the parameters that vary, or the
/// sampler's title, its own region and all parameters, or the label that the sampler itself makes of these.
std::string series_label(const MethodConfig& method, const Combination& chosen)
{
    const std::string values = values_text(method.settings, chosen, !method.label.empty());
    if (method.label.empty() && method.sampler->label)
        return method.sampler->label(chosen_parameters(*method.sampler, method.settings, chosen));
    std::string label = method.label.empty() ? method.sampler->title : method.label;
    if (method.label.empty() && method.has_own_region) label += " in " + method.region->region->name();
    return values.empty() ? label : fmt::format("{}, {}", label, values);
}

/// Calls visit(choice, place) for every sampler among the parameters.
template <typename Visit>
void for_each_start(const Parameters& parameters, const Visit& visit)
{
    for (const auto& [key, entry] : parameters.given())
        if (const SamplerChoice* start = as_sampler(entry.value)) visit(*start, entry.location);
}

/// The checks of a sampler, after those of the samplers among its parameters.
void check_sampler(const SamplerSpec& sampler, const Parameters& parameters, const SampleRequest& request,
                   const SourceLocation& where)
{
    if (std::ranges::find(sampler.dimensions, request.dimension) == sampler.dimensions.end())
        throw InputError::at(where, fmt::format("sampler = \"{}\": this method has no {}D sets; dimension must be {}",
                                                sampler.name, request.dimension, sampler.dimensions.front()));
    for_each_start(parameters, [&](const SamplerChoice& start, const SourceLocation& place) {
        check_sampler(*start.spec, start.parameters, request, place);
    });
    if (sampler.check) sampler.check(parameters, request, where);
}

/// True when all realizations are one set.
bool is_deterministic(const SamplerSpec& sampler, const Parameters& parameters)
{
    if (sampler.is_deterministic) return sampler.is_deterministic(parameters);
    if (sampler.deterministic || !sampler.follows_start) return sampler.deterministic;
    bool any = false;
    bool all = true;
    for_each_start(parameters, [&](const SamplerChoice& start, const SourceLocation&) {
        any = true;
        all = all && is_deterministic(*start.spec, start.parameters);
    });
    return any && all;
}

/// The number of realizations if files decide it, the series' own or those that it starts from.
std::optional<std::size_t> available_realizations(const SamplerSpec& sampler, const Parameters& parameters)
{
    if (sampler.available_realizations) return sampler.available_realizations(parameters);
    std::optional<std::size_t> fewest;
    for_each_start(parameters, [&](const SamplerChoice& start, const SourceLocation&) {
        const auto count = available_realizations(*start.spec, start.parameters);
        if (count) fewest = std::min(*count, fewest.value_or(*count));
    });
    return fewest;
}

/// Throws InputError when a number of points is asked of sets that are there already.
void check_points_can_be_asked(const SamplerSpec& sampler, const Parameters& parameters, const ParameterChoice& points)
{
    if (sampler.has_own_points)
        throw invalid_value(points.location, "points", points.shown,
                            fmt::format("cannot be combined with the sampler \"{}\", whose sets have their own "
                                        "number of points; leave it out",
                                        sampler.name));
    for_each_start(parameters, [&](const SamplerChoice& start, const SourceLocation&) {
        check_points_can_be_asked(*start.spec, start.parameters, points);
    });
}

/// The number of points that a method asks for itself, or that of the experiment.
std::size_t points_of(const Config& config, const MethodConfig& method, const Combination& chosen,
                      const Parameters& parameters)
{
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (method.settings[i].parameter != &points_parameter()) continue;
        check_points_can_be_asked(*method.sampler, parameters, *chosen[i]);
        return static_cast<std::size_t>(std::get<std::int64_t>(chosen[i]->value));
    }
    return config.points;
}

std::uint64_t region_hash(const SeriesPlan& series) { return series.region ? series.region->hash : 0; }

bool same_series(const SeriesPlan& a, const SeriesPlan& b)
{
    return a.sampler->name == b.sampler->name && a.request.points == b.request.points &&
           region_hash(a) == region_hash(b) && same_parameters(a.parameters, b.parameters);
}

/// Which choice of each setting with several choices is taken.
std::vector<std::size_t> indices_of(const MethodConfig& method, const Combination& chosen)
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (const auto& choices = method.settings[i].choices; choices.size() > 1)
            indices.push_back(static_cast<std::size_t>(chosen[i] - choices.data()));
    return indices;
}

/// Throws InputError where the config's sets lie in a periodic box, and the method makes those of the unit square.
void check_box(const Config& config, const MethodConfig& method)
{
    const std::string& name = method.sampler->name;
    if (config.analysis.box_sides.empty() || name == "file" || name == "command") return;
    throw InputError::at(method.where,
                         fmt::format("sampler = \"{}\": makes sets of the unit {}; with box in [analysis] "
                                     "it must be \"file\" or \"command\"",
                                     name, config.dimension == 2 ? "square" : "cube"));
}

/// The name of a series' folder. Commands have the label that a user gives them: their programs are often the same.
std::string series_name(const MethodConfig& method, const Combination& chosen)
{
    if (method.sampler->name == "command" && !method.label.empty())
        return series_folder_name(series_label(method, chosen));
    return safe_name(name_of(*method.sampler, method.settings, chosen)).substr(0, longest_name);
}

SeriesPlan make_series(const Config& config, std::size_t method_index, const Combination& chosen)
{
    const MethodConfig& method = config.methods[method_index];
    const SamplerSpec& sampler = *method.sampler;
    check_box(config, method);
    SeriesPlan series;
    series.place = GridPlace{method_index, indices_of(method, chosen)};
    series.name = series_name(method, chosen);
    series.where = method.where;
    series.sampler = &sampler;
    series.parameters = chosen_parameters(sampler, method.settings, chosen);
    series.request = {points_of(config, method, chosen, series.parameters), config.dimension, config.seed};
    series.region = method.region;
    if (series.region) series.request.region = series.region->region;
    check_sampler(sampler, series.parameters, series.request, method.where);
    series.label = series_label(method, chosen); // samplers make theirs of parameters that passed
    if (is_ordered(series.parameters)) {
        if (series.region)
            throw series.parameters.error("order",
                                          "cannot be combined with a region: the order is for points on the torus");
        if (!config.analysis.box_sides.empty())
            throw series.parameters.error("order",
                                          "cannot be combined with box: the order is for points on the unit torus");
        series.ordered = std::make_shared<const SamplerSpec>(in_progressive_order(sampler));
        series.sampler = series.ordered.get();
    }

    series.deterministic = is_deterministic(sampler, series.parameters);
    const auto asked = static_cast<std::size_t>(series.deterministic ? 1 : config.realizations);
    series.realizations =
        static_cast<std::uint32_t>(available_realizations(sampler, series.parameters).value_or(asked));
    return series;
}

}

void check_device_memory(const std::vector<SeriesPlan>& plan, const DeviceInfo& device)
{
    for (const SeriesPlan& series : plan) {
        if (!series.sampler->device_memory) continue;
        const DeviceMemory memory = memory_of(series, series.request.points, device);
        if (fits(memory, device)) continue;
        const std::size_t most = most_points_that_fit(series, device);
        throw InputError::at(series.where, fmt::format("{}: {}{}", series.label, comparison(memory, device),
                                                       most > 0 ? fmt::format("; up to {} points would fit", most)
                                                                : "; fewer points would not fit either"));
    }
}

std::vector<SeriesPlan> make_plan(const Config& config)
{
    std::vector<SeriesPlan> plan;
    std::set<std::string> names;
    for (std::size_t i = 0; i < config.methods.size(); ++i) {
        const MethodConfig& method = config.methods[i];
        for (const Combination& chosen : combinations(method.settings, method.where, "[[method]]")) {
            SeriesPlan series = make_series(config, i, chosen);
            for (const SeriesPlan& other : plan)
                if (same_series(other, series))
                    throw InputError::at(method.where,
                                         fmt::format("[[method]]: the series \"{}\" is there twice", other.label));
            if (plan.size() == max_series)
                throw InputError::at({config.file}, fmt::format("the config makes more than {} series", max_series));
            // Different series whose names were cut or cleaned to the same get a number, and so do labels that a
            // sampler makes.
            const std::string base = series.name;
            const std::string label = series.label;
            for (int number = 2; !names.insert(series.name).second; ++number) {
                series.name = fmt::format("{}-{}", base, number);
                if (method.label.empty() && method.sampler->label) series.label = fmt::format("{} ({})", label, number);
            }
            plan.push_back(std::move(series));
        }
    }
    return plan;
}

std::vector<MethodGrid> method_grids(const Config& config)
{
    std::vector<MethodGrid> grids;
    for (const MethodConfig& method : config.methods) {
        MethodGrid grid{method.sampler->name, method.label, {}};
        for (const ParameterSetting& setting : method.settings) {
            if (setting.choices.size() < 2) continue;
            MethodAxis axis{setting.parameter->key, symbol_of(*setting.parameter), {}};
            for (const ParameterChoice& choice : setting.choices) axis.values.push_back(choice.shown);
            grid.axes.push_back(std::move(axis));
        }
        grids.push_back(std::move(grid));
    }
    return grids;
}

std::string series_folder_name(const std::string& label)
{
    const std::string name = safe_name(label).substr(0, longest_name);
    const bool is_taken =
        name == "site" || name == file_names::results || name == file_names::collection || name.ends_with(".html");
    return is_taken ? "points-" + name : name;
}

std::string safe_name(const std::string& text)
{
    std::string name;
    for (const char c : text) {
        const bool safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                          c == '_' || c == '-';
        if (safe)
            name += c;
        else if (name.empty() || name.back() != '-')
            name += '-';
    }
    const std::size_t first = name.find_first_not_of("-.");
    if (first == std::string::npos) return "series";
    return name.substr(first, name.find_last_not_of('-') - first + 1);
}

}
