#include "host/config/distributions/rank_table.hpp"

#include "host/config/config_values.hpp"
#include "host/config/distributions/distribution_keys.hpp"

#include <fmt/format.h>

#include <bit>

namespace poissonlab {
namespace {

constexpr std::int64_t most_tile_points = 24;

/// `tile_points` and `starts`, by default those of D table 4.1.
SelfSimilarChoice read_tile_choice(const ConfigTable& table)
{
    SelfSimilarChoice tile;
    tile.points = static_cast<std::uint32_t>(read_integer(table, "tile_points", 8, most_tile_points, tile.points));
    if (tile.points % 4 != 0) throw invalid_node("tile_points", *find(table, "tile_points"), "must be a multiple of 4");
    const auto starts = read_integers(table, "starts", 2, 2, 0, "[x, y]");
    if (starts.empty()) {
        if (tile.points != 16)
            throw invalid_node("tile_points", *find(table, "tile_points"), "needs starts, unless it is 16");
        return tile;
    }
    const auto is_balanced = [&](std::int64_t start) {
        return start < std::int64_t{1} << tile.points &&
               2 * std::popcount(static_cast<std::uint64_t>(start)) == static_cast<int>(tile.points);
    };
    if (!is_balanced(starts[0]) || !is_balanced(starts[1]))
        throw invalid_node("starts", *find(table, "starts"),
                           fmt::format("must be words of {} bits, half of them ones", tile.points));
    tile.x = static_cast<std::uint32_t>(starts[0]);
    tile.y = static_cast<std::uint32_t>(starts[1]);
    return tile;
}

}

void read_self_similar_tile(const ConfigTable& table, DistributionConfig& config)
{
    check_keys(table, {"kind", "label", "show", "tile_points", "starts", "least_radius", "repeats"});
    static const std::vector<std::string> shows{"tile", "ranks", "progression", "function", "search"};
    SelfSimilarSettings settings;
    settings.show = shows[read_word(table, "show", shows)];
    const bool searches = settings.show == "search";
    if (searches) {
        if (const ConfigNode* starts = find(table, "starts"))
            throw invalid_node("starts", *starts, "does not go with show = \"search\", which finds them");
        settings.tile.points = static_cast<std::uint32_t>(read_integer(table, "tile_points", 8, most_tile_points, 16));
        if (settings.tile.points % 4 != 0)
            throw invalid_node("tile_points", *find(table, "tile_points"), "must be a multiple of 4");
    } else {
        settings.tile = read_tile_choice(table);
    }
    settings.least_radius = read_number(table, "least_radius", 0.3, 1, 0.64);
    settings.repeats = static_cast<std::uint32_t>(read_integer(table, "repeats", 1, 6, 1));
    if (config.label.empty())
        config.label = searches ? fmt::format("Self-similar tiles of {} points", settings.tile.points)
                                : fmt::format("The self-similar tile: {}", settings.show);
    config.settings = settings;
}

void read_ranks(const ConfigTable& table, DistributionConfig& config)
{
    check_keys(table, {"kind", "label", "density", "density_from", "points", "tile_points", "starts", "zoom"});
    RankSettings settings;
    settings.density = read_density_choice(table, config.where);
    settings.points = read_distributed_points(table, config.where);
    settings.tile = read_tile_choice(table);
    settings.zoom = read_number(table, "zoom", 1, 1000, 1);
    add_input(config, settings.density.text);
    if (config.label.empty()) config.label = "Ranked points by " + shortened(printable(settings.density.text));
    config.settings = std::move(settings);
}

}
