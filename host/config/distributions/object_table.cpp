#include "host/config/distributions/object_table.hpp"

#include "host/config/config_values.hpp"
#include "host/config/distributions/distribution_keys.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr double most_objects = 1e6;
constexpr double largest_window = 1e3;
constexpr double farthest_origin = 1e6;
constexpr double most_turns = 1e4;

const std::vector<std::string>& looks_of(int dimension)
{
    static const std::vector<std::string> plane{"dots",    "stars",     "flowers",  "hearts",  "daisies", "mondriaan",
                                                "squares", "triangles", "starfish", "granite", "frames",  "cells"};
    static const std::vector<std::string> space{"dots", "mondriaan", "granite", "frames", "cells"};
    return dimension == 3 ? space : plane;
}

void read_place(const ConfigTable& table, ObjectSettings& settings)
{
    settings.objects = read_number(table, "objects", 1e-6, most_objects, settings.objects);
    settings.window = read_number(table, "window", 1e-6, largest_window, settings.window);
    if (const ConfigNode* origin = find(table, "origin")) {
        const auto* numbers = origin->get_if<ConfigList>();
        if (!numbers || numbers->size() != 2) throw invalid_node("origin", *origin, "must be [x, y]");
        for (std::size_t i = 0; i < 2; ++i)
            settings.origin[i] = read_listed_number("origin", (*numbers)[i], -farthest_origin, farthest_origin);
    }
    static const std::vector<std::string> views{"plane", "sphere", "torus"};
    settings.view = views[read_word(table, "view", views)];
    if (settings.view != "plane" && settings.dimension == 2)
        throw invalid_node("view", *find(table, "view"), "is for dimension = 3, whose objects fill space");
}

}

void read_objects(const ConfigTable& table, DistributionConfig& config)
{
    check_keys(table, {"kind", "label", "dimension", "tiles", "object", "objects", "window", "origin", "view", "pixels",
                       "samples", "period", "size", "orientation", "aspect", "timing"});
    ObjectSettings settings;
    settings.dimension = static_cast<int>(read_integer(table, "dimension", 2, 3, 2));
    const auto& looks = looks_of(settings.dimension);
    settings.object = looks[read_word(table, "object", looks)];
    settings.tiles = read_even_method_choice(table).tiles;
    read_place(table, settings);
    settings.pixels = static_cast<std::uint32_t>(read_integer(table, "pixels", 16, 8192, settings.pixels));
    settings.samples = static_cast<std::uint32_t>(read_integer(table, "samples", 1, 15, settings.samples));
    settings.period = static_cast<std::int32_t>(read_integer(table, "period", 0, 1 << 20, 0));
    settings.has_timing = read_flag(table, "timing", false);
    settings.size = read_spread(table, "size", 0, 1, settings.size);
    settings.orientation = read_spread(table, "orientation", -most_turns, most_turns, settings.orientation);
    settings.aspect = read_spread(table, "aspect", 0.01, 100, settings.aspect);
    add_input(config, settings.tiles.string());
    if (config.label.empty())
        config.label = fmt::format("Objects: {}{}", settings.object, settings.dimension == 3 ? " in space" : "");
    config.settings = std::move(settings);
}

}
