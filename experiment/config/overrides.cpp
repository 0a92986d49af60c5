#include "experiment/config/overrides.hpp"

#include "experiment/config/config.hpp"
#include "host/settings/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace poissonlab {
namespace {

/// One argument, taken apart.
struct Override
{
    SourceLocation origin; ///< as messages name it
    std::vector<std::string> path;
    ConfigNode value;
};

Override parse(const std::string& argument)
{
    Override result;
    result.origin = {"--set " + shortened(argument, 200), 0, true};
    const std::size_t equals = argument.find('=');
    if (equals == std::string::npos) throw InputError::at(result.origin, "must be key=value, for example --set seed=2");
    const auto trimmed = [](std::string text) {
        const std::size_t first = text.find_first_not_of(" \t");
        if (first == std::string::npos) return std::string();
        return text.substr(first, text.find_last_not_of(" \t") - first + 1);
    };
    const std::string key = trimmed(argument.substr(0, equals));
    for (std::size_t begin = 0; begin <= key.size();) {
        const std::size_t end = std::min(key.find('.', begin), key.size());
        if (end == begin)
            throw InputError::at(result.origin,
                                 "the key must be words with dots between them, such as analysis.points");
        result.path.push_back(key.substr(begin, end - begin));
        begin = end + 1;
    }
    const std::string value = trimmed(argument.substr(equals + 1));
    if (value.empty()) throw InputError::at(result.origin, "a value is missing after \"=\"");
    result.value = read_toml_value(value, result.origin);
    return result;
}

/// Sets path[from], path[from + 1] ... below a table, adding tables that are not there.
void set_below(ConfigTable& table, const Override& change, std::size_t from)
{
    const std::string& key = change.path[from];
    ConfigNode* node = find(table, key);
    if (!node) {
        table.push_back({key, {ConfigTable{}, change.origin, {}}});
        node = &table.back().node;
    }
    if (from + 1 == change.path.size()) {
        *node = change.value;
        return;
    }
    auto* inner = node->get_if<ConfigTable>();
    if (!inner)
        throw InputError::at(change.origin, fmt::format("\"{}\" is not a table and has no keys", shortened(key)));
    set_below(*inner, change, from + 1);
}

/// The number that a path element is, if it is one.
std::optional<std::size_t> as_index(const std::string& text)
{
    std::size_t index = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (status != std::errc{} || end != text.data() + text.size()) return {};
    return index;
}

/// The samplers that are known, and whether methods have those of regions.
struct Registries
{
    const SamplerRegistry& torus;
    bool analysis_has_region = false;
};

const SamplerSpec* sampler_of(const ConfigTable& method, const Registries& registries)
{
    const ConfigNode* node = find(method, "sampler");
    const auto* name = node ? node->get_if<std::string>() : nullptr;
    if (!name) return nullptr;
    return find_sampler(*name, registry_of(method, registries.analysis_has_region, registries.torus));
}

/// True if a [[method]] table can have the key: it is one of every method, or a parameter of its sampler.
bool method_takes(const ConfigTable& method, const std::string& key, const Registries& registries)
{
    if (std::ranges::find(method_keys(), key) != method_keys().end()) return true;
    const SamplerSpec* sampler = sampler_of(method, registries);
    // A sampler's name that is wrong is refused later, at its own line.
    if (!sampler) return true;
    return std::ranges::any_of(sampler->parameters, [&](const ParameterSpec& spec) { return spec.key == key; });
}

/// The keys that at least one of the methods takes.
std::vector<std::string> known_keys(const ConfigList& methods, const Registries& registries)
{
    std::vector<std::string> known = method_keys();
    for (const ConfigNode& method : methods) {
        const SamplerSpec* sampler = sampler_of(*method.get_if<ConfigTable>(), registries);
        if (!sampler) continue;
        for (const ParameterSpec& spec : sampler->parameters)
            if (std::ranges::find(known, spec.key) == known.end()) known.push_back(spec.key);
    }
    return known;
}

void set_in_methods(ConfigList& methods, const Override& change, const Registries& registries)
{
    const auto table_of = [&](ConfigNode& method) -> ConfigTable& {
        if (auto* table = method.get_if<ConfigTable>()) return *table;
        throw InputError::at(change.origin, "the config's methods are not [[method]] tables");
    };
    const auto index = as_index(change.path[1]);
    if (index) {
        if (change.path.size() < 3)
            throw InputError::at(change.origin, fmt::format("a parameter is missing: method.{}.KEY=value", *index));
        if (*index >= methods.size())
            throw InputError::at(change.origin, fmt::format("there is no method {}: the config has {}, counted from 0",
                                                            *index, methods.size()));
        set_below(table_of(methods[*index]), change, 2);
        return;
    }
    bool taken = false;
    for (ConfigNode& method : methods) {
        if (!method_takes(table_of(method), change.path[1], registries)) continue;
        set_below(table_of(method), change, 1);
        taken = true;
    }
    if (!taken) throw unknown_key(change.path[1], change.value, known_keys(methods, registries));
}

/// True if [analysis] gets a region, before or after methods get their keys.
bool sets_region(const std::vector<std::string>& overrides)
{
    return std::ranges::any_of(overrides, [](const std::string& argument) {
        return parse(argument).path == std::vector<std::string>{"analysis", "region"};
    });
}

}

void check_collection_overrides(const std::vector<std::string>& overrides)
{
    for (const std::string& argument : overrides) {
        const Override change = parse(argument);
        if (change.path[0] == "method" && change.path.size() > 1 && as_index(change.path[1]))
            throw InputError::at(change.origin, "a collection has no numbered methods; method.KEY=VALUE changes every "
                                                "method that has KEY");
        if (change.path[0] == "title" || change.path[0] == "include")
            throw InputError::at(change.origin, "what a collection includes and how that is called cannot be set");
    }
}

void apply_overrides(ConfigTable& config, const std::vector<std::string>& overrides, const SamplerRegistry& registry)
{
    for (const std::string& argument : overrides) {
        const Override change = parse(argument);
        ConfigNode* methods = change.path.front() == "method" ? find(config, "method") : nullptr;
        auto* list = methods ? methods->get_if<ConfigList>() : nullptr;
        if (list && change.path.size() > 1)
            set_in_methods(*list, change, {registry, analysis_has_region(config) || sets_region(overrides)});
        else if (change.path.front() == "method" && change.path.size() > 1 && !methods)
            throw InputError::at(change.origin, "the config has no [[method]] table");
        else
            set_below(config, change, 0);
    }
}

}
