// A program with all modules prints samplers and kinds from their own descriptions.
#include "app/commands/core/stored_text.hpp"
#include "host/kinds/kind_help.hpp"
#include "host/kinds/kinds.hpp"
#include "host/sampling/guide/sampler_guide.hpp"
#include "host/sampling/parameters.hpp"
#include "host/settings/parameter_values.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/settings/sampler_texts.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace poissonlab {
namespace {

// Parameters of methods and keys of kinds as JSON, for programs that make configs or commands.

/// Numbers and booleans as such, others as they would be typed.
nlohmann::ordered_json json_of_value(const ParameterValue& value)
{
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
    if (const auto* boolean = std::get_if<bool>(&value)) return *boolean;
    return to_string(value);
}

/// Describes a key: its name, its meaning, its default, and what it may be; numbers have their range, words are all
/// listed.
nlohmann::ordered_json described_value(const ParameterSpec& spec, const std::string& allowed)
{
    nlohmann::ordered_json json{{"key", spec.key}, {"help", spec.help}, {"allowed", allowed}};
    if (!spec.unit.empty()) json["unit"] = spec.unit;
    const bool is_number = spec.kind == ParameterSpec::Kind::number || spec.kind == ParameterSpec::Kind::integer;
    if (is_number && spec.minimum < spec.maximum) { // lists of numbers have no range, but words
        json["minimum"] = spec.minimum;
        json["maximum"] = spec.maximum;
    }
    if (!spec.choices.empty()) json["choices"] = spec.choices;
    if (spec.otherwise)
        json["default"] = json_of_value(*spec.otherwise);
    else if (!spec.unless_given.empty())
        json["unless_given"] = spec.unless_given;
    return json;
}

nlohmann::ordered_json described_samplers(const SamplerRegistry& samplers)
{
    auto list = nlohmann::ordered_json::array();
    for (const SamplerSpec& sampler : samplers) {
        auto parameters = nlohmann::ordered_json::array();
        for (const ParameterSpec& spec : sampler.parameters)
            parameters.push_back(described_value(spec, allowed_values(spec)));
        list.push_back({{"name", sampler.name},
                        {"title", sampler.title},
                        {"summary", sampler.summary},
                        {"source", sampler_guide(sampler.name).source},
                        {"dimensions", sampler.dimensions},
                        {"deterministic", sampler.deterministic},
                        {"parameters", parameters}});
    }
    return list;
}

}

std::string all_samplers_json()
{
    const nlohmann::ordered_json json{{"samplers", described_samplers(sampler_registry())},
                                      {"in_regions", described_samplers(region_sampler_registry())}};
    return json.dump(2) + "\n";
}

std::string all_samplers_markdown()
{
    return samplers_markdown(sampler_registry()) + "\n" + samplers_markdown(region_sampler_registry());
}

std::string all_samplers_text() { return samplers_text(sampler_registry(), region_sampler_registry()); }

std::string all_kinds_json()
{
    nlohmann::ordered_json json{{"kinds", nlohmann::ordered_json::array()}};
    for (const Kind& kind : all_kinds()) {
        auto keys = nlohmann::ordered_json::array();
        for (const KeySpec& spec : kind.keys()) {
            nlohmann::ordered_json key = described_value(spec.value, spec.allowed());
            key["required"] = spec.is_required;
            key["option"] = option_name(spec);
            keys.push_back(std::move(key));
        }
        json["kinds"].push_back({{"table", kind.table},
                                 {"kind", kind.word},
                                 {"command", kind.command},
                                 {"title", kind.title},
                                 {"summary", kind.summary},
                                 {"keys", keys}});
    }
    return json.dump(2) + "\n";
}

std::string all_kinds_markdown() { return kinds_markdown(); }

std::string all_kinds_text() { return kinds_text(); }

}
