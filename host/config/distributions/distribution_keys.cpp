#include "host/config/distributions/distribution_keys.hpp"

#include "base/densities/density_text.hpp"
#include "host/config/config_values.hpp"
#include "host/config/sampler_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

constexpr auto spread_words = ", { uniform = [a, b] } or { normal = [mean, deviation] }";

}

InputError missing_key(const SourceLocation& where, const std::string& key)
{
    return InputError::at(where, fmt::format("[[distribution]]: needs {}", key));
}

DensityChoice read_density_choice(const ConfigTable& table, const SourceLocation& where)
{
    const ConfigNode* node = find(table, "density");
    if (!node) throw missing_key(where, "density");
    DensityChoice choice{read_text(table, "density", ""), read_text(table, "density_from", "light")};
    try {
        density_of_text(choice.text, choice.from, 1, 1);
    } catch (const InputError& error) {
        throw InputError::at(node->location, fmt::format("density: {}", error.what()));
    }
    return choice;
}

std::size_t read_distributed_points(const ConfigTable& table, const SourceLocation& where)
{
    if (!find(table, "points")) throw missing_key(where, "points");
    return static_cast<std::size_t>(read_integer(table, "points", 1, max_points, 1));
}

EvenMethodChoice read_even_method_choice(const ConfigTable& table)
{
    EvenMethodChoice choice;
    const ConfigNode* method = find(table, "method");
    const ConfigNode* tiles = find(table, "tiles");
    if (method && tiles) throw invalid_node("tiles", *tiles, "does not go with method");
    if (tiles) {
        choice.tiles = read_text(table, "tiles", "");
        if (!is_file_name(choice.tiles.string())) throw invalid_node("tiles", *tiles, "must be a tile set's file");
    }
    if (!method) return choice;
    static const ParameterSpec spec{.key = "method", .kind = ParameterSpec::Kind::sampler};
    const auto choices = sampler_choices(spec, *method, sampler_registry(), 0);
    if (choices.size() != 1) throw invalid_node("method", *method, "must be one method, without lists");
    choice.sampler = *as_sampler(choices.front().value);
    return choice;
}

double read_listed_number(const std::string& key, const ConfigNode& node, double low, double high,
                          const std::string& others)
{
    const auto* whole = node.get_if<std::int64_t>();
    const auto* real = node.get_if<double>();
    const double value = whole ? static_cast<double>(*whole) : real ? *real : NAN;
    if (!(value >= low && value <= high))
        throw invalid_node(key, node, fmt::format("must be a number from {} to {}{}", low, high, others));
    return value;
}

SpreadChoice read_spread(const ConfigTable& table, const std::string& key, double low, double high,
                         const SpreadChoice& otherwise)
{
    const ConfigNode* node = find(table, key);
    if (!node) return otherwise;
    const auto* words = node->get_if<ConfigTable>();
    if (!words) return {SpreadChoice::Kind::constant, read_listed_number(key, *node, low, high, spread_words), 0};
    check_keys(*words, {"uniform", "normal"});
    const auto* numbers = words->size() == 1 ? words->front().node.get_if<ConfigList>() : nullptr;
    if (!numbers || numbers->size() != 2)
        throw invalid_node(key, *node, std::string("must be a number") + spread_words);
    const bool is_normal = words->front().key == "normal";
    const double a = read_listed_number(key, (*numbers)[0], low, high, spread_words);
    const double b = read_listed_number(key, (*numbers)[1], is_normal ? 0 : a, high, spread_words);
    return {is_normal ? SpreadChoice::Kind::normal : SpreadChoice::Kind::uniform, a, b};
}

void add_input(DistributionConfig& config, const std::string& text)
{
    if (is_file_name(text)) config.inputs.emplace_back(text);
}

}
