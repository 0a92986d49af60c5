#include "host/config/tiling_table.hpp"

#include "host/config/config_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>

namespace poissonlab {
namespace {

constexpr double largest_regions_2d = 0.2071; // octagons of neighbouring corners meet at (1 + sqrt 2) r = 1/2
constexpr double largest_regions_3d = 0.1306; // and at (1 + 2 sqrt 2) r = 1/2
constexpr std::int64_t max_paired_colors = 16;

constexpr const char* window_words(std::size_t axes)
{
    return axes == 1 ? "[X, width]" : axes == 2 ? "[X, Y, width, height]" : "[X, Y, Z, width, height, depth]";
}

CubeWindow read_window(const ConfigTable& table, TileKind kind)
{
    const std::size_t axes = axes_of(kind);
    const auto w = read_integers(table, "window", 2 * axes, 2 * axes, -any_integer - 1, window_words(axes));
    if (w.empty()) return axes == 3 ? CubeWindow{0, 0, 0, 4, 4, 4} : CubeWindow{0, 0, 0, 16, axes == 2 ? 16U : 1U, 1};
    std::uint64_t tiles = 1;
    for (std::size_t i = axes; i < w.size(); ++i) {
        const bool fits = w[i] >= 1 && static_cast<std::uint64_t>(w[i]) <= max_shown_tiles / tiles;
        if (!fits)
            throw invalid_node(
                "window", *find(table, "window"),
                fmt::format("must have at least 1 tile along each axis, and at most {} in all", max_shown_tiles));
        tiles *= static_cast<std::uint64_t>(w[i]);
    }
    const auto first = [&](std::size_t axis) { return axis < axes ? w[axis] : 0; };
    const auto size = [&](std::size_t axis) { return axis < axes ? static_cast<std::uint64_t>(w[axes + axis]) : 1; };
    return {first(0), first(1), first(2), size(0), size(1), size(2)};
}

Period read_period(const ConfigTable& table, TileKind kind)
{
    const auto p =
        read_integers(table, "period", 1, axes_of(kind), 0, "a list of tiles along x, y (cubes: z), 0 for none");
    Period period;
    for (std::size_t i = 0; i < p.size(); ++i) (i == 0 ? period.x : i == 1 ? period.y : period.z) = p[i];
    return period;
}

std::string default_label(const TilingConfig& config)
{
    const char* kind = tile_kind_words(config.request.kind);
    const TilingRequest& request = config.request;
    const std::string colors = request.vertical_colors > 0
                                   ? fmt::format("{} x {}", request.colors, request.vertical_colors)
                                   : fmt::format("{}", request.colors);
    if (config.set == "corner") return fmt::format("Wang tiles equivalent to corner tiles, {} colours", colors);
    if (request.is_given()) return fmt::format("Given tiling of {}, {} colours", kind, colors);
    std::string label = config.is_set()
                            ? fmt::format("{} set of {}, {} colours",
                                          config.set == given_tiles_word ? "given" : config.set, kind, colors)
                            : fmt::format("{} tiling of {}, {} colours", request.algorithm, kind, colors);
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

/// Vertical edges of Wang tiles can have another number of colours; 0 where they have not.
Color read_vertical_colors(const ConfigTable& table, const TilingRequest& request)
{
    const ConfigNode* const node = find(table, "vertical_colors");
    if (!node) return 0;
    if (request.kind != TileKind::wang) throw invalid_node("vertical_colors", *node, "is for Wang tiles only");
    const auto colors = static_cast<Color>(read_integer(table, "vertical_colors", 2, max_colors, 2));
    return colors == request.colors ? 0 : colors;
}

/// Tilings with aperiodic sets have no hash function and never close; given tiles have nothing but themselves.
void check_own(const ConfigTable& table, const TilingRequest& request)
{
    if (request.is_given()) {
        for (const char* key : {"algorithm", "hash", "period", "window"})
            if (const ConfigNode* const node = find(table, key))
                throw invalid_node(key, *node, "has no place beside indices");
    }
    if (!request.is_aperiodic()) return;
    for (const char* key : {"hash", "period"})
        if (const ConfigNode* const node = find(table, key))
            throw invalid_node(key, *node, fmt::format("has no place beside algorithm = \"{}\"", request.algorithm));
}

/// Rows of tile indices, north first, all of the same length.
void read_given_tiles(const ConfigNode& node, TilingRequest& request)
{
    const auto wrong = [&] {
        return invalid_node("indices", node, "must be rows [[..], [..]] of as many indices each");
    };
    if (request.kind != TileKind::wang && request.kind != TileKind::corner)
        throw invalid_node("indices", node, "is for Wang and corner tiles");
    const auto* rows = node.get_if<ConfigList>();
    if (!rows || rows->empty()) throw wrong();
    for (const ConfigNode& row : *rows) {
        const auto* tiles = row.get_if<ConfigList>();
        if (!tiles || tiles->empty() || (request.given_width > 0 && tiles->size() != request.given_width))
            throw wrong();
        request.given_width = tiles->size();
        for (const ConfigNode& tile : *tiles) {
            const auto* index = tile.get_if<std::int64_t>();
            if (!index || *index < 0 || *index > std::numeric_limits<TileIndex>::max()) throw wrong();
            request.given.push_back(static_cast<TileIndex>(*index));
        }
    }
    if (request.given.size() > max_shown_tiles)
        throw invalid_node("indices", node, fmt::format("must be at most {} tiles", max_shown_tiles));
    request.algorithm = given_tiles_word;
}

/// The indices of a set, which are different ones.
void read_given_set(const ConfigTable& table, const ConfigNode& node, TilingConfig& config)
{
    if (find(table, "tiles")) throw invalid_node("tiles", *find(table, "tiles"), "has no place beside indices");
    for (const std::int64_t index : read_integers(table, "indices", 1, max_shown_tiles, 0, "a list of tile indices")) {
        if (index > std::numeric_limits<TileIndex>::max() ||
            std::ranges::find(config.request.given, index) != config.request.given.end())
            throw invalid_node("indices", node, "must be different indices of tiles");
        config.request.given.push_back(static_cast<TileIndex>(index));
    }
    config.set = given_tiles_word;
}

TilingConfig read_table(const ConfigTable& table, bool is_set, std::uint64_t seed)
{
    TilingConfig config;
    TilingRequest& request = config.request;
    request.kind = read_word(table, "kind", tile_kinds, request.kind);
    const bool cube = request.kind == TileKind::cube;
    const Color most_colors = most_colors_of(request.kind);
    request.seed = seed;
    config.regions = read_number(table, "regions", 0, cube ? largest_regions_3d : largest_regions_2d, 0);
    if (config.regions > 0 && (request.kind == TileKind::wang_cube || request.kind == TileKind::domino))
        throw invalid_node("regions", *find(table, "regions"), "is for Wang tiles, corner tiles and corner cubes");
    if (is_set) {
        check_keys(table, {"kind", "colors", "vertical_colors", "tiles", "indices", "regions", "label"});
        const auto& names = tile_set_names(request.kind);
        config.set = names[read_word(table, "tiles", names)];
        if (const ConfigNode* const node = find(table, "indices")) read_given_set(table, *node, config);
        request.colors = read_colors(table, request.kind, config.set, most_colors);
        // Pairs of their colours are the colours of the edges.
        if (config.set == "corner") read_integer(table, "colors", 2, max_paired_colors, 2);
    } else {
        check_keys(table, {"kind", "colors", "vertical_colors", "algorithm", "indices", "hash", "period", "window",
                           "regions", "label"});
        const auto& names = tiling_algorithms(request.kind);
        request.algorithm = names[read_word(table, "algorithm", names)];
        if (const ConfigNode* const node = find(table, "indices")) read_given_tiles(*node, request);
        request.colors = read_colors(table, request.kind, request.algorithm, most_colors);
        check_own(table, request);
        // The first word is the default; that of hash functions is another.
        if (find(table, "hash")) request.hash = static_cast<HashKind>(read_word(table, "hash", hash_names()));
        request.period = read_period(table, request.kind);
        config.window = request.is_given()
                            ? CubeWindow{0, 0, 0, request.given_width, request.given.size() / request.given_width, 1}
                            : read_window(table, request.kind);
    }
    request.vertical_colors = read_vertical_colors(table, request);
    config.label = read_text(table, "label", default_label(config));
    return config;
}

/// Makes the tile set as the tiles library does; errors give the table's place.
void check_tiles(const TilingConfig& config)
{
    try {
        if (config.is_set()) {
            if (tile_set_of(config).size() > max_shown_tiles)
                throw InputError(fmt::format("more than {} tiles cannot be drawn", max_shown_tiles));
        } else {
            if (config.request.is_given()) check_given_tiles(config.request);
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

TileSet tile_set_of(const TilingConfig& config)
{
    const TilingRequest& request = config.request;
    if (!config.is_set()) return tile_set_of(request);
    if (config.set != given_tiles_word) return make_tile_set(request.kind, request.all_colors(), config.set);
    const TileSet complete = TileSet::complete(request.kind, request.all_colors());
    for (const TileIndex index : request.given)
        if (index >= complete.size())
            throw InputError(fmt::format("indices: {}: must be less than {}", index, complete.size()));
    return {request.kind, request.all_colors(), request.given};
}

std::vector<TilingConfig> read_tilings(const ConfigTable& config, std::uint64_t seed)
{
    std::vector<TilingConfig> tilings;
    read_list(config, "tile_set", seed, tilings);
    read_list(config, "tiling", seed, tilings);
    return tilings;
}

}
