#include "host/settings/sampler_table.hpp"

#include "host/settings/nearest_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace poissonlab {
namespace {

using Kind = ParameterSpec::Kind;

/// The sampler that a text names; `key` is whose value it is.
const SamplerSpec& sampler_named(const std::string& key, const ConfigNode& node, const SamplerRegistry& registry)
{
    std::vector<std::string> names;
    for (const SamplerSpec& spec : registry) names.push_back(spec.name);
    const std::string allowed = fmt::format("must be one of \"{}\"", fmt::join(names, "\", \""));
    const auto* name = node.get_if<std::string>();
    if (!name) throw invalid_node(key, node, allowed);
    const SamplerSpec* spec = find_sampler(*name, registry);
    if (!spec) throw invalid_node(key, node, allowed + did_you_mean(*name, names));
    return *spec;
}

ParameterChoice sampler_choice(const SamplerSpec& sampler, const std::vector<ParameterSetting>& settings,
                               const Combination& chosen, const SourceLocation& where)
{
    auto value = std::make_shared<SamplerChoice>();
    value->spec = &sampler;
    value->parameters = chosen_parameters(sampler, settings, chosen);
    const std::string values = values_text(settings, chosen);
    return {std::shared_ptr<const SamplerChoice>(std::move(value)),
            values.empty() ? sampler.title : fmt::format("{} ({})", sampler.title, values), where,
            name_of(sampler, settings, chosen)};
}

}

const ParameterSpec& points_parameter()
{
    static const ParameterSpec points{.key = "points",
                                      .kind = Kind::integer,
                                      .help = "points in each set of this method",
                                      .minimum = 1,
                                      .maximum = static_cast<double>(max_points),
                                      .symbol = "N",
                                      .unless_given = "by default analysis.points"};
    return points;
}

const ParameterSpec& order_parameter()
{
    static const ParameterSpec order{
        .key = "order",
        .kind = ParameterSpec::Kind::choice,
        .help = "the order of a set's points: that in which they are made, or one whose first parts, whatever their "
                "size, are well spread (Yuksel 2015)",
        .choices = {"own", "sample-elimination"},
        .otherwise = std::string("own")};
    return order;
}

bool is_ordered(const Parameters& parameters)
{
    return parameters.is_given("order") && parameters.text("order") != "own";
}

std::vector<Combination> combinations(const std::vector<ParameterSetting>& settings, const SourceLocation& where,
                                      const std::string& what)
{
    std::vector<Combination> result = {{}};
    for (const ParameterSetting& setting : settings) {
        if (result.size() * setting.choices.size() > max_series)
            throw InputError::at(where, fmt::format("{}: its lists make more than {} series", what, max_series));
        std::vector<Combination> longer;
        for (const Combination& start : result)
            for (const ParameterChoice& choice : setting.choices) {
                longer.push_back(start);
                longer.back().push_back(&choice);
            }
        result = std::move(longer);
    }
    return result;
}

const SamplerSpec& read_sampler(const ConfigTable& table, const SourceLocation& where, const std::string& what,
                                const SamplerRegistry& registry)
{
    const ConfigNode* node = find(table, "sampler");
    if (node) return sampler_named("sampler", *node, registry);
    std::vector<std::string> names;
    for (const SamplerSpec& spec : registry) names.push_back(spec.name);
    throw InputError::at(
        where, fmt::format("{}: sampler is missing; it must be one of \"{}\"", what, fmt::join(names, "\", \"")));
}

std::vector<ParameterSetting> read_settings(const ConfigTable& table, const SamplerSpec& sampler,
                                            const std::vector<std::string>& others, const SamplerRegistry& registry,
                                            int depth)
{
    std::vector<std::string> known = others;
    for (const ParameterSpec& spec : sampler.parameters) known.push_back(spec.key);
    check_keys(table, known);
    std::vector<ParameterSetting> settings;
    for (const ParameterSpec& spec : sampler.parameters)
        if (const ConfigNode* value = find(table, spec.key))
            settings.push_back({&spec, parameter_choices(spec, *value, registry, depth)});
    return settings;
}

std::vector<ParameterChoice> sampler_choices(const ParameterSpec& spec, const ConfigNode& node,
                                             const SamplerRegistry& registry, int depth)
{
    if (depth + 1 >= max_sampler_depth)
        throw invalid_node(spec.key, node, fmt::format("samplers lie in one another up to {} deep", max_sampler_depth));
    if (node.get_if<std::string>())
        return {sampler_choice(sampler_named(spec.key, node, registry), {}, {}, node.location)};
    const auto* table = node.get_if<ConfigTable>();
    if (!table) throw invalid_node(spec.key, node, "must be " + allowed_values(spec));
    const SamplerSpec& sampler = read_sampler(*table, node.location, spec.key, registry);
    const auto settings = read_settings(*table, sampler, {"sampler"}, registry, depth + 1);
    std::vector<ParameterChoice> choices;
    for (const Combination& chosen : combinations(settings, node.location, spec.key))
        choices.push_back(sampler_choice(sampler, settings, chosen, node.location));
    return choices;
}

Parameters chosen_parameters(const SamplerSpec& sampler, const std::vector<ParameterSetting>& settings,
                             const Combination& chosen)
{
    Parameters parameters(sampler.parameters);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (settings[i].parameter != &points_parameter())
            parameters.set(settings[i].parameter->key, chosen[i]->value, chosen[i]->location);
    return parameters;
}

std::string symbol_of(const ParameterSpec& spec) { return spec.symbol.empty() ? spec.key : spec.symbol; }

std::string name_of(const SamplerSpec& sampler, const std::vector<ParameterSetting>& settings,
                    const Combination& chosen)
{
    std::string name = sampler.name;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const ParameterSpec& spec = *settings[i].parameter;
        const std::string& value = chosen[i]->in_name.empty() ? chosen[i]->shown : chosen[i]->in_name;
        if (spec.kind == Kind::sampler)
            name += fmt::format("-{}", value); // its name says enough
        else if (spec.kind == Kind::command)
            name += fmt::format("-{}", value);
        else if (spec.kind != Kind::boolean)
            name += fmt::format("-{}-{}", symbol_of(spec), value);
        else if (std::get<bool>(chosen[i]->value))
            name += fmt::format("-{}", symbol_of(spec));
    }
    return name;
}

std::string values_text(const std::vector<ParameterSetting>& settings, const Combination& chosen, bool only_varying)
{
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const ParameterSpec& spec = *settings[i].parameter;
        if (only_varying && settings[i].choices.size() == 1) continue;
        if (spec.kind != Kind::boolean)
            parts.push_back(fmt::format("{} = {}", symbol_of(spec), chosen[i]->shown));
        else if (std::get<bool>(chosen[i]->value))
            parts.push_back(symbol_of(spec));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

}
