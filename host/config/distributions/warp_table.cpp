#include "host/config/distributions/warp_table.hpp"

#include "host/config/config_values.hpp"
#include "host/config/distributions/distribution_keys.hpp"

#include <fmt/format.h>

namespace poissonlab {

void read_warp(const ConfigTable& table, DistributionConfig& config)
{
    check_keys(table,
               {"kind", "label", "density", "density_from", "environment", "seen_from", "points", "tiles", "method"});
    WarpSettings settings;
    settings.density = read_density_choice(table, config.where);
    settings.is_environment = read_flag(table, "environment", false);
    if (const ConfigNode* node = find(table, "seen_from")) {
        settings.seen_from = static_cast<SeenFrom>(read_word(table, "seen_from", seen_from_names));
        if (!settings.is_environment) throw invalid_node("seen_from", *node, "goes with environment = true");
    }
    settings.points = read_distributed_points(table, config.where);
    settings.method = read_even_method_choice(table);
    if (settings.is_environment && settings.density.from != "light")
        throw invalid_node("environment", *find(table, "environment"), "takes the light; leave density_from out");
    add_input(config, settings.density.text);
    add_input(config, settings.method.tiles.string());
    if (config.label.empty())
        config.label = fmt::format("{} points by {}", settings.is_environment ? "Lights" : "Warped",
                                   shortened(printable(settings.density.text)));
    config.settings = std::move(settings);
}

}
