#include "host/config/distributions/instance_table.hpp"

#include "base/densities/density_values.hpp"
#include "host/config/config_values.hpp"
#include "host/config/distributions/distribution_keys.hpp"

#include <fmt/format.h>

#include <numbers>

namespace poissonlab {
namespace {

constexpr double farthest_place = 1e6;
constexpr double most_instances = 1e6; ///< in a window
constexpr double most_tilt = 1.5;

/// A list of `count` numbers, of which those from `positive` on are above 0.
template <std::size_t count>
std::array<double, count> read_places(const ConfigTable& table, const std::string& key, const char* words,
                                      std::size_t positive, const std::array<double, count>& otherwise)
{
    const ConfigNode* node = find(table, key);
    if (!node) return otherwise;
    const auto* numbers = node->get_if<ConfigList>();
    if (!numbers || numbers->size() != count) throw invalid_node(key, *node, std::string("must be ") + words);
    std::array<double, count> places{};
    for (std::size_t i = 0; i < count; ++i)
        places[i] = read_listed_number(key, (*numbers)[i], i < positive ? -farthest_place : 1e-3, farthest_place);
    return places;
}

void read_terrain(const ConfigTable& table, InstanceSettings& settings)
{
    const ConfigNode* terrain = find(table, "terrain");
    for (const char* key : {"terrain_area", "height"})
        if (const ConfigNode* node = find(table, key); node && !terrain)
            throw invalid_node(key, *node, "goes with terrain");
    if (!terrain) return;
    settings.terrain = read_text(table, "terrain", "");
    if (!find(table, "terrain_area"))
        throw InputError::at(terrain->location,
                             "terrain: needs terrain_area = [x, y, width, height], the rectangle that it covers");
    settings.terrain_area = read_places(table, "terrain_area", "[x, y, width, height]", 2, settings.terrain_area);
    settings.height = read_number(table, "height", -farthest_place, farthest_place, settings.height);
    try {
        values_of_text(settings.terrain, "light", settings.terrain_area[2], settings.terrain_area[3]);
    } catch (const InputError& error) {
        throw InputError::at(terrain->location, fmt::format("terrain: {}", error.what()));
    }
}

}

const std::vector<std::string>& instance_scenes()
{
    static const std::vector<std::string> scenes{"forest", "sunflowers", "asteroids"};
    return scenes;
}

InstanceSettings scene_settings(const std::string& scene)
{
    using Kind = SpreadChoice::Kind;
    InstanceSettings settings;
    settings.scene = scene;
    if (scene == "forest") {
        settings.density = 2000;
        settings.models = 5;
        settings.scale = {Kind::uniform, 0.7, 1};
        settings.tilt = 0.06;
    } else if (scene == "sunflowers") {
        settings.density = 500;
        settings.models = 11;
        settings.scale = {Kind::uniform, 0.8, 1};
        settings.tilt = 0.25;
    } else {
        settings.density = 40'000;
        settings.models = 8;
        settings.scale = {Kind::uniform, 0.3, 1};
        settings.tilt = most_tilt;
        settings.window = {-1, -1, 2, 2};
        settings.ring = {0.55, 0.95, 0.08};
    }
    return settings;
}

void check_instances(const InstanceSettings& settings)
{
    const auto& [inner, outer, thickness] = settings.ring;
    const bool is_belt = settings.scene == "asteroids";
    if (is_belt && !(inner >= 0 && outer > inner && thickness > 0))
        throw InputError(fmt::format("a ring from {} to {} that is {} thick: must be [inner, outer, thickness] with "
                                     "0 <= inner < outer and thickness > 0",
                                     inner, outer, thickness));
    const double box = settings.window[2] * settings.window[3];
    const double ring = std::numbers::pi * outer * outer;
    const double size = is_belt ? std::min(box, ring) * thickness : box;
    if (settings.density * size > most_instances)
        throw InputError(fmt::format("{:.0f} instances in the window: must be at most {:.0f}", settings.density * size,
                                     most_instances));
}

void read_instances(const ConfigTable& table, DistributionConfig& config)
{
    check_keys(table, {"kind", "label", "scene", "tiles", "density", "window", "models", "scale", "tilt", "ring",
                       "terrain", "terrain_area", "height", "pixels"});
    InstanceSettings settings = scene_settings(instance_scenes()[read_word(table, "scene", instance_scenes())]);
    settings.tiles = read_even_method_choice(table).tiles;
    settings.density = read_number(table, "density", 1e-6, farthest_place, settings.density);
    settings.window = read_places(table, "window", "[x, y, width, height]", 2, settings.window);
    settings.models = static_cast<std::uint32_t>(read_integer(table, "models", 1, most_models, settings.models));
    settings.scale = read_spread(table, "scale", 0.001, 1, settings.scale);
    settings.tilt = read_number(table, "tilt", 0, most_tilt, settings.tilt);
    if (const ConfigNode* ring = find(table, "ring"); ring && settings.scene != "asteroids")
        throw invalid_node("ring", *ring, "is for scene = \"asteroids\"");
    settings.ring = read_places(table, "ring", "[inner, outer, thickness]", 1, settings.ring);
    if (const ConfigNode* terrain = find(table, "terrain"); terrain && settings.scene == "asteroids")
        throw invalid_node("terrain", *terrain, "does not go with asteroids");
    read_terrain(table, settings);
    settings.pixels = static_cast<std::uint32_t>(read_integer(table, "pixels", 16, 4096, settings.pixels));
    try {
        check_instances(settings);
    } catch (const InputError& error) {
        throw InputError::at(config.where, fmt::format("[[distribution]]: {}", error.what()));
    }
    add_input(config, settings.terrain);
    add_input(config, settings.tiles.string());
    if (config.label.empty()) config.label = fmt::format("Instances: {}", settings.scene);
    config.settings = std::move(settings);
}

}
