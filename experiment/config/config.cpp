#include "experiment/config/config.hpp"

#include "base/files/whole_file.hpp"
#include "experiment/config/overrides.hpp"
#include "host/sampling/optimized/ordered_sampler.hpp"
#include "host/settings/config_values.hpp"
#include "host/settings/toml_reader.hpp"

#include <limits>

namespace poissonlab {
namespace {

void read_analysis(const ConfigTable& top, Config& config)
{
    const ConfigNode* node = find(top, "analysis");
    if (!node) return;
    const auto* table = node->get_if<ConfigTable>();
    if (!table) throw invalid_node("analysis", *node, "must be a table, written [analysis]");
    std::vector<std::string> keys = {"points", "realizations", "dimension", "timing_runs"};
    keys.insert(keys.end(), analysis_option_keys().begin(), analysis_option_keys().end());
    check_keys(*table, keys);
    config.points = static_cast<std::size_t>(
        read_integer(*table, "points", 1, max_points, static_cast<std::int64_t>(config.points)));
    config.realizations =
        static_cast<int>(read_integer(*table, "realizations", 1, max_realizations, config.realizations));
    config.timing_runs = static_cast<int>(read_integer(*table, "timing_runs", 1, max_timing_runs, config.timing_runs));
    config.dimension = static_cast<int>(read_integer(*table, "dimension", 2, 3, config.dimension));
    config.analysis = read_analysis_options(*table, config.dimension);
}

MethodConfig read_method(const ConfigNode& node, const SamplerRegistry& registry)
{
    const auto* table = node.get_if<ConfigTable>();
    MethodConfig method;
    method.where = node.location;
    method.sampler = &read_sampler(*table, node.location, "[[method]]", registry);
    method.settings = read_settings(*table, *method.sampler, {"sampler", "label", "points", "order"}, registry, 0);
    if (const ConfigNode* order = find(*table, "order"))
        method.settings.push_back({&order_parameter(), parameter_choices(order_parameter(), *order)});
    if (const ConfigNode* points = find(*table, "points"))
        method.settings.insert(method.settings.begin(),
                               {&points_parameter(), parameter_choices(points_parameter(), *points)});
    method.label = read_text(*table, "label", "");
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
        config.methods.push_back(read_method(*method, registry));
}

}

const std::vector<std::string>& kind_tables()
{
    static const std::vector<std::string> names{"tile_set", "tiling",  "construction", "distribution",
                                                "scheme",   "texture", "packing"};
    return names;
}

Config parse_config(const std::string& text, const std::string& file, const std::vector<std::string>& overrides,
                    const SamplerRegistry& registry)
{
    ConfigTable top = read_toml(text, file);
    apply_overrides(top, overrides, registry);
    std::vector<std::string> known{"title", "seed", "engine", "device", "analysis", "method"};
    known.insert(known.end(), kind_tables().begin(), kind_tables().end());
    known.emplace_back("include");
    check_keys(top, known);
    if (const ConfigNode* include = find(top, "include"))
        throw invalid_node("include", *include, "makes a config a collection, which has no experiment of its own");

    Config config;
    config.file = file;
    config.text = text;
    config.overrides = overrides;
    config.title = read_text(top, "title", std::filesystem::path(file).stem().string());
    config.seed = static_cast<std::uint64_t>(read_integer(top, "seed", 0, std::numeric_limits<std::int64_t>::max(), 1));
    config.engine = read_word(top, "engine", engines, config.engine);
    config.device = read_text(top, "device", "");
    read_analysis(top, config);
    for (const std::string& name : kind_tables())
        for (const ConfigNode* table : read_tables(top, name)) config.tables.push_back({name, *table});
    read_methods(top, registry, config);
    return config;
}

Config read_config(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    if (std::filesystem::is_directory(file))
        throw InputError::at({file.string()}, "is a folder; a config file (.toml) is needed");
    return parse_config(read_whole_file(file), file.string(), overrides);
}

}
