#include "app/commands/manual/described_values.hpp"

namespace poissonlab {
namespace {

/// Numbers and booleans as such, others as they would be typed.
nlohmann::ordered_json json_of_value(const ParameterValue& value)
{
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
    if (const auto* boolean = std::get_if<bool>(&value)) return *boolean;
    return to_string(value);
}

}

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

}
