#include "host/config/distributions/stipple_table.hpp"

#include "base/densities/density_values.hpp"
#include "host/config/config_values.hpp"
#include "host/config/distributions/distribution_keys.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr double most_radians = 7;
constexpr double most_slender = 100;
constexpr double widest_mark = 10'000;
constexpr double least_ink = 0.001;
constexpr double most_zoom = 1000;
constexpr std::int64_t most_iterations = 1'000'000;

void read_image(const ConfigTable& table, DistributionConfig& config, StippleSettings& settings)
{
    const ConfigNode* node = find(table, "image");
    if (!node) throw missing_key(config.where, "image");
    settings.image = read_text(table, "image", "");
    settings.from = read_text(table, "image_from", settings.from);
    try {
        values_of_text(settings.image, settings.from, 1, 1);
    } catch (const InputError& error) {
        throw InputError::at(node->location, fmt::format("image: {}", error.what()));
    }
    settings.ink = read_number(table, "ink", least_ink, 1, settings.ink);
    add_input(config, settings.image);
}

/// `points`, or the key of the marks' width.
void read_count(const ConfigTable& table, const char* width_key, DistributionConfig& config, StippleSettings& settings)
{
    const ConfigNode* width = find(table, width_key);
    if (width && find(table, "points"))
        throw invalid_node(width_key, *width, "does not go with points: ink over area is their number");
    if (width)
        settings.mark_width = read_number(table, width_key, 0.01, widest_mark, 1);
    else if (find(table, "points"))
        settings.points = read_distributed_points(table, config.where);
    else
        throw missing_key(config.where, fmt::format("points or {}", width_key));
}

void read_placing(const ConfigTable& table, StippleSettings& settings)
{
    settings.by = usual_mark_places;
    if (find(table, "by")) settings.by = static_cast<MarkPlaces>(read_word(table, "by", mark_places));
    settings.iterations = static_cast<std::size_t>(
        read_integer(table, "iterations", 1, most_iterations, static_cast<std::int64_t>(settings.iterations)));
    if (const ConfigNode* node = find(table, "iterations"); node && settings.by != MarkPlaces::gaussian)
        throw invalid_node("iterations", *node, "is for by = \"gaussian\"");
    settings.zoom = read_number(table, "zoom", 1, most_zoom, settings.zoom);
    settings.method = read_even_method_choice(table);
    if (const ConfigNode* method = find(table, "method"); method && settings.by == MarkPlaces::ranks)
        throw invalid_node("method", *method, "does not go with by = \"ranks\"");
}

void finish(DistributionConfig& config, const char* word, StippleSettings settings)
{
    add_input(config, settings.method.tiles.string());
    if (config.label.empty()) config.label = fmt::format("{} of {}", word, shortened(printable(settings.image)));
    config.settings = std::move(settings);
}

}

void read_stippling(const ConfigTable& table, DistributionConfig& config)
{
    check_keys(table, {"kind", "label", "image", "image_from", "ink", "points", "dot", "by", "iterations", "zoom",
                       "tiles", "method"});
    StippleSettings settings;
    read_image(table, config, settings);
    read_count(table, "dot", config, settings);
    read_placing(table, settings);
    finish(config, "Stippling", std::move(settings));
}

void read_hatching(const ConfigTable& table, DistributionConfig& config)
{
    check_keys(table, {"kind", "label", "image", "image_from", "ink", "points", "stroke", "by", "iterations", "zoom",
                       "tiles", "method", "angle", "slenderness"});
    StippleSettings settings;
    settings.has_strokes = true;
    read_image(table, config, settings);
    read_count(table, "stroke", config, settings);
    read_placing(table, settings);
    if (find(table, "angle")) settings.angle = read_number(table, "angle", -most_radians, most_radians, 0);
    settings.slenderness = read_number(table, "slenderness", 1, most_slender, settings.slenderness);
    finish(config, "Hatching", std::move(settings));
}

}
