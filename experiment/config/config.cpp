#include "experiment/config/config.hpp"

#include "base/files/whole_file.hpp"
#include "base/programs/loaded_module.hpp"
#include "experiment/config/overrides.hpp"
#include "host/settings/toml_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// The keys at the top of a config that are not tables.
void top_keys(Keys& keys, Config& config)
{
    keys.text("title", config.title, "of the report");
    keys.integer("seed", config.seed, 0, any_integer, "which of all results");
    keys.word("engine", config.engine, engines, "what makes point sets");
    keys.text("device", config.device, "the OpenCL device: part of its name, or its number");
}

/// The keys of [analysis].
void series_keys(Keys& keys, Config& config, bool is_any_in_region)
{
    keys.integer("points", config.points, 1, max_points, "points in each set");
    keys.integer("realizations", config.realizations, 1, max_realizations, "sets of each series");
    keys.integer("dimension", config.dimension, 2, 3, "of the sets");
    keys.integer("timing_runs", config.timing_runs, 1, max_timing_runs, "how often each series is timed, at least");
    config.analysis = analysis_keys(keys, config.dimension, is_any_in_region);
}

void read_analysis(const ConfigTable& top, Config& config)
{
    const ConfigNode* node = find(top, "analysis");
    if (!node) return;
    const auto* table = node->get_if<ConfigTable>();
    if (!table) throw invalid_node("analysis", *node, "must be a table, written [analysis]");
    const auto visit = [&](Keys& keys) { series_keys(keys, config, some_method_has_region(top)); };
    check_described_keys(*table, visit);
    Keys keys(*table, {config.file}, "");
    visit(keys);
}

/// Throws InputError where a method names a sampler that fills the unit square alone, though it has a region.
void check_takes_regions(const ConfigTable& method, const SamplerRegistry& in_regions)
{
    const ConfigNode* node = find(method, "sampler");
    const auto* name = node ? node->get_if<std::string>() : nullptr;
    if (!name || find_sampler(*name, in_regions) || !find_sampler(*name)) return;
    std::vector<std::string> names;
    for (const SamplerSpec& spec : in_regions) names.push_back(spec.name);
    throw invalid_node(
        "sampler", *node,
        fmt::format("has no sets in regions; in one it must be one of \"{}\"", fmt::join(names, "\", \"")));
}

MethodConfig read_method(const ConfigNode& node, const SamplerRegistry& torus, const Config& config)
{
    const auto* table = node.get_if<ConfigTable>();
    const SamplerRegistry& registry = registry_of(*table, config.analysis.region.has_value(), torus);
    if (&registry != &torus) check_takes_regions(*table, registry);
    MethodConfig method;
    method.where = node.location;
    method.sampler = &read_sampler(*table, node.location, "[[method]]", registry);
    method.settings = read_settings(*table, *method.sampler, method_keys(), registry, 0);
    Keys keys(*table, node.location, "");
    method.region = method_region_keys(keys, config.dimension, config.analysis.region_measures);
    method.has_own_region = method.region.has_value();
    if (!method.region) method.region = config.analysis.region;
    if (const ConfigNode* order = find(*table, "order"))
        method.settings.push_back({&order_parameter(), parameter_choices(order_parameter(), *order)});
    if (const ConfigNode* points = find(*table, "points"))
        method.settings.insert(method.settings.begin(),
                               {&points_parameter(), parameter_choices(points_parameter(), *points)});
    keys.text("label", method.label, "what the report calls the series");
    return method;
}

void read_methods(const ConfigTable& top, const SamplerRegistry& registry, Config& config)
{
    const ConfigNode* node = find(top, "method");
    if (!node && config.tables.empty())
        throw InputError::at({config.file}, "no [[method]] table: a config needs at least one");
    const auto* list = node ? node->get_if<ConfigList>() : nullptr;
    if (list && list->empty()) throw invalid_node("method", *node, "must have at least one [[method]] table");
    for (const ConfigNode* method : read_tables(top, "method"))
        config.methods.push_back(read_method(*method, registry, config));
}

}

const std::vector<std::string>& kind_tables()
{
    static const std::vector<std::string> names{"tile_set", "tiling",  "construction", "distribution",
                                                "scheme",   "texture", "packing"};
    return names;
}

ParsedConfig parse_file(const std::filesystem::path& file)
{
    std::error_code error;
    const auto installed = installed_data_folder() / file;
    if (!std::filesystem::exists(file, error) && file.is_relative() && std::filesystem::exists(installed, error))
        throw InputError::at({file.string()},
                             "is not in this folder; the installed config of this name is " + installed.string());
    if (std::filesystem::is_directory(file))
        throw InputError::at({file.string()}, "is a folder; a config file (.toml) is needed");
    std::string text = read_whole_file(file);
    ConfigTable top = read_toml(text, file.string());
    return {file.string(), std::move(text), std::move(top)};
}

Config checked_config(ParsedConfig parsed, const std::vector<std::string>& overrides, const SamplerRegistry& registry)
{
    ConfigTable& top = parsed.top;
    apply_overrides(top, overrides, registry);
    Config config;
    std::vector<std::string> tables{"analysis", "method"};
    tables.insert(tables.end(), kind_tables().begin(), kind_tables().end());
    tables.emplace_back("include");
    check_described_keys(
        top, [&](Keys& keys) { top_keys(keys, config); }, {}, tables);
    if (const ConfigNode* include = find(top, "include"))
        throw invalid_node("include", *include, "makes a config a collection, which has no experiment of its own");

    config.file = parsed.file;
    config.text = std::move(parsed.text);
    config.overrides = overrides;
    config.title = std::filesystem::path(parsed.file).stem().string();
    Keys keys(top, {config.file}, "");
    top_keys(keys, config);
    read_analysis(top, config);
    for (const std::string& name : kind_tables())
        for (const ConfigNode* table : read_tables(top, name)) config.tables.push_back({name, *table});
    read_methods(top, registry, config);
    return config;
}

Config parse_config(const std::string& text, const std::string& file, const std::vector<std::string>& overrides,
                    const SamplerRegistry& registry)
{
    return checked_config({file, text, read_toml(text, file)}, overrides, registry);
}

Config read_config(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    return checked_config(parse_file(file), overrides);
}

const std::vector<std::string>& method_keys()
{
    static const std::vector<std::string> keys{"sampler", "label", "points",  "order", "region",
                                               "planar",  "crs",   "overlap", "buffer"};
    return keys;
}

bool analysis_has_region(const ConfigTable& config)
{
    const ConfigNode* node = find(config, "analysis");
    const auto* analysis = node ? node->get_if<ConfigTable>() : nullptr;
    return analysis && find(*analysis, "region");
}

bool some_method_has_region(const ConfigTable& config)
{
    const ConfigNode* node = find(config, "method");
    const auto* methods = node ? node->get_if<ConfigList>() : nullptr;
    return methods && std::ranges::any_of(*methods, [](const ConfigNode& method) {
               const auto* table = method.get_if<ConfigTable>();
               return table && find(*table, "region");
           });
}

const SamplerRegistry& registry_of(const ConfigTable& method, bool analysis_has_region, const SamplerRegistry& torus)
{
    return analysis_has_region || find(method, "region") ? region_sampler_registry() : torus;
}

}
