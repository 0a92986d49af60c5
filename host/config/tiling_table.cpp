#include "host/config/tiling_table.hpp"

#include "host/config/config_values.hpp"

#include <fmt/format.h>

#include <cctype>
#include <limits>

namespace poissonlab {
namespace {

constexpr double largest_regions_2d = 0.2071; // octagons of neighbouring corners meet at (1 + sqrt 2) r = 1/2
constexpr double largest_regions_3d = 0.1306; // and at (1 + 2 sqrt 2) r = 1/2
constexpr std::int64_t max_paired_colors = 16;

CubeWindow read_window(const ConfigTable& table, TileKind kind)
{
    const bool cube = kind == TileKind::cube;
    const auto w = read_integers(table, "window", cube ? 6 : 4, cube ? 6 : 4, -any_integer - 1,
                                 cube ? "[X, Y, Z, width, height, depth]" : "[X, Y, width, height]");
    if (w.empty()) return cube ? CubeWindow{0, 0, 0, 4, 4, 4} : CubeWindow{0, 0, 0, 16, 16, 1};
    const std::size_t axes = w.size() / 2;
    std::uint64_t tiles = 1;
    for (std::size_t i = axes; i < w.size(); ++i) {
        const bool fits = w[i] >= 1 && static_cast<std::uint64_t>(w[i]) <= max_shown_tiles / tiles;
        if (!fits)
            throw invalid_node(
                "window", *find(table, "window"),
                fmt::format("must have at least 1 tile along each axis, and at most {} in all", max_shown_tiles));
        tiles *= static_cast<std::uint64_t>(w[i]);
    }
    const auto size = [&](std::size_t axis) { return static_cast<std::uint64_t>(w[axes + axis]); };
    return {w[0], w[1], cube ? w[2] : 0, size(0), size(1), cube ? size(2) : 1};
}

Period read_period(const ConfigTable& table, TileKind kind)
{
    const auto p = read_integers(table, "period", 1, kind == TileKind::cube ? 3 : 2, 0,
                                 "a list of tiles along x, y (cubes: z), 0 for none");
    Period period;
    for (std::size_t i = 0; i < p.size(); ++i) (i == 0 ? period.x : i == 1 ? period.y : period.z) = p[i];
    return period;
}

std::string default_label(const TilingConfig& config)
{
    const char* kind = config.request.kind == TileKind::wang     ? "Wang tiles"
                       : config.request.kind == TileKind::corner ? "corner tiles"
                                                                 : "corner cubes";
    const Color colors = config.request.colors;
    if (config.set == "corner") return fmt::format("Wang tiles equivalent to corner tiles, {} colours", colors);
    std::string label = config.is_set()
                            ? fmt::format("{} set of {}, {} colours", config.set, kind, colors)
                            : fmt::format("{} tiling of {}, {} colours", config.request.algorithm, kind, colors);
    label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
    return label;
}

/// Aperiodic sets have one number of colours, which need not be given.
Color read_colors(const ConfigTable& table, TileKind kind, const std::string& word, Color most)
{
    const Color own = own_colors(kind, word);
    return static_cast<Color>(
        read_integer(table, "colors", own > 0 ? own : 2, own > 0 ? own : most, own > 0 ? own : 2));
}

/// Tilings with aperiodic sets have no hash function and never close.
void check_own(const ConfigTable& table, const TilingRequest& request)
{
    if (!request.is_aperiodic()) return;
    for (const char* key : {"hash", "period"})
        if (const ConfigNode* const node = find(table, key))
            throw invalid_node(key, *node, fmt::format("has no place beside algorithm = \"{}\"", request.algorithm));
}

TilingConfig read_table(const ConfigTable& table, bool is_set, std::uint64_t seed)
{
    TilingConfig config;
    TilingRequest& request = config.request;
    request.kind = read_word(table, "kind", tile_kinds, request.kind);
    const bool cube = request.kind == TileKind::cube;
    const Color most_colors = cube ? max_cube_colors : max_colors;
    request.seed = seed;
    config.regions = read_number(table, "regions", 0, cube ? largest_regions_3d : largest_regions_2d, 0);
    if (is_set) {
        check_keys(table, {"kind", "colors", "tiles", "regions", "label"});
        const auto& names = tile_set_names(request.kind);
        config.set = names[read_word(table, "tiles", names)];
        request.colors = read_colors(table, request.kind, config.set, most_colors);
        // Pairs of their colours are the colours of the edges.
        if (config.set == "corner") read_integer(table, "colors", 2, max_paired_colors, 2);
    } else {
        check_keys(table, {"kind", "colors", "algorithm", "hash", "period", "window", "regions", "label"});
        const auto& names = tiling_algorithms(request.kind);
        request.algorithm = names[read_word(table, "algorithm", names)];
        request.colors = read_colors(table, request.kind, request.algorithm, most_colors);
        check_own(table, request);
        // The first word is the default; that of hash functions is another.
        if (find(table, "hash")) request.hash = static_cast<HashKind>(read_word(table, "hash", hash_names()));
        request.period = read_period(table, request.kind);
        config.window = read_window(table, request.kind);
    }
    config.label = read_text(table, "label", default_label(config));
    return config;
}

/// Makes the tile set as the tiles library does; errors give the table's place.
void check_tiles(const TilingConfig& config)
{
    try {
        if (config.is_set()) {
            if (make_tile_set(config.request.kind, config.request.colors, config.set).size() > max_shown_tiles)
                throw InputError(fmt::format("more than {} tiles cannot be drawn", max_shown_tiles));
        } else {
            CubeWindow one = config.window;
            one.width = one.height = one.depth = 1;
            stream_tiles(config.request, one, [](auto, auto, auto, auto) {});
        }
    } catch (const InputError& error) {
        throw error.moved_to(config.where);
    }
}

void read_list(const ConfigTable& config, const std::string& key, std::uint64_t seed, std::vector<TilingConfig>& into)
{
    for (const ConfigNode* node : read_tables(config, key)) {
        into.push_back(read_table(*node->get_if<ConfigTable>(), key == "tile_set", seed));
        into.back().where = node->location;
        check_tiles(into.back());
    }
}

}

std::vector<TilingConfig> read_tilings(const ConfigTable& config, std::uint64_t seed)
{
    std::vector<TilingConfig> tilings;
    read_list(config, "tile_set", seed, tilings);
    read_list(config, "tiling", seed, tilings);
    return tilings;
}

}
