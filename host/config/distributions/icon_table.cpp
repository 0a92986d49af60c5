#include "host/config/distributions/icon_table.hpp"

#include "base/densities/density_text.hpp"
#include "base/densities/density_values.hpp"
#include "host/config/config_values.hpp"
#include "host/config/distributions/distribution_keys.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

std::string read_component(const ConfigTable& table, const std::string& key, const SourceLocation& where)
{
    const ConfigNode* node = find(table, key);
    if (!node) throw missing_key(where, "field, or u and v");
    const std::string formula = read_text(table, key, "");
    try {
        formula_values(formula, 1, 1);
    } catch (const InputError& error) {
        throw InputError::at(node->location, fmt::format("{}: {}", key, error.what()));
    }
    return formula;
}

}

void read_icons(const ConfigTable& table, DistributionConfig& config)
{
    check_keys(table, {"kind", "label", "field", "u", "v", "points", "tiles", "method", "length"});
    IconSettings settings;
    if (const ConfigNode* field = find(table, "field")) {
        for (const char* key : {"u", "v"})
            if (const ConfigNode* node = find(table, key)) throw invalid_node(key, *node, "does not go with field");
        settings.field = read_text(table, "field", "");
        if (!is_file_name(settings.field)) throw invalid_node("field", *field, "must be a picture's file");
        add_input(config, settings.field);
    } else {
        settings.u = read_component(table, "u", config.where);
        settings.v = read_component(table, "v", config.where);
    }
    settings.points = read_distributed_points(table, config.where);
    settings.method = read_even_method_choice(table);
    settings.have_one_length = read_word(table, "length", {"magnitude", "one"}) == 1;
    add_input(config, settings.method.tiles.string());
    if (config.label.empty())
        config.label = settings.field.empty()
                           ? fmt::format("Icons of ({}, {})", shortened(settings.u), shortened(settings.v))
                           : fmt::format("Icons of {}", shortened(printable(settings.field)));
    config.settings = std::move(settings);
}

}
