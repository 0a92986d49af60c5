#include "host/config/construction_table.hpp"

#include "host/config/config_values.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <map>

namespace poissonlab {
namespace {

constexpr std::int64_t max_side = 64;    // of a window, in tiles
constexpr std::int64_t max_listed = 256; // pieces or tiles of a picture
constexpr std::int64_t max_drawn_points = 100'000;

/// The number of axes of what a picture shows; -1: no piece in particular.
int axes_count(const std::string& show, int dimension)
{
    if (show == "corner" || show == "corners") return 0;
    if (show == "edge" || show == "edges") return 1;
    if (show == "face" || show == "faces") return 2;
    if (show == "master" || show == "template" || show == "tile" || show == "tiles") return dimension;
    return -1;
}

/// The names of directions of pieces with so many axes, and their axes.
struct Directions
{
    std::vector<std::string> names;
    std::vector<std::uint8_t> axes;
};

Directions directions(int count, int dimension)
{
    if (count == 1 && dimension == 2) return {{"x", "y"}, {1, 2}};
    if (count == 1 && dimension == 3) return {{"x", "y", "z"}, {1, 2, 4}};
    return {{"xy", "xz", "yz"}, {3, 5, 6}};
}

std::vector<std::string> known_keys(const ConstructionConfig& config)
{
    const int dimension = config.parameters.dimension;
    const int count = axes_count(config.show, dimension);
    std::vector<std::string> keys{"kind",
                                  "show",
                                  "points_per_tile",
                                  "relative_radius",
                                  "seed",
                                  "filling",
                                  "lloyd_iterations",
                                  "repulsion",
                                  "label",
                                  config.parameters.kind == PoissonTileKind::frame ? "tiles" : "colors"};
    if (count > 0 && count < dimension) keys.push_back("along");
    if (config.is_stage() && config.show != "master" && config.show != "template") keys.push_back("variant");
    if (config.is_list()) keys.push_back("count");
    if (config.is_tiling()) keys.push_back("window");
    if (config.show == "regions" && dimension == 3) keys.push_back("modified");
    return keys;
}

PoissonTileParameters read_parameters(const ConfigTable& table, const PoissonTileFamily& family, std::uint64_t seed)
{
    PoissonTileParameters p;
    p.dimension = family.dimension;
    p.kind = family.kind;
    const bool is_template = p.kind == PoissonTileKind::frame;
    const auto most = is_template || p.dimension == 3 ? max_cube_colors : max_colors;
    p.colors = is_template ? 1 : static_cast<std::uint32_t>(read_integer(table, "colors", 2, most, 2));
    p.tiles = is_template ? static_cast<std::uint32_t>(read_integer(table, "tiles", 2, max_colors, 8))
                          : tile_count(p.kind, p.dimension, p.colors);
    p.points_per_tile = static_cast<std::uint32_t>(
        read_integer(table, "points_per_tile", min_points_per_tile, max_points_per_tile, p.dimension == 2 ? 32 : 64));
    p.relative_radius = read_number(table, "relative_radius", 0, 1, p.dimension == 2 ? 0.7 : 0.6);
    p.filling = read_word(table, "filling", tile_fillings, p.filling);
    if (p.filling == TileFilling::dart_throwing) p.factor = 1;
    p.lloyd_iterations = static_cast<std::uint32_t>(read_integer(table, "lloyd_iterations", 0, 1000, 8));
    p.repulsion = read_flag(table, "repulsion", true);
    p.seed = static_cast<std::uint64_t>(read_integer(table, "seed", 0, any_integer, static_cast<std::int64_t>(seed)));
    return p;
}

/// Checks the parameters as the library does; errors give the line of the key that they name.
void check_parameters(const PoissonTileParameters& parameters, const ConfigTable& table, const SourceLocation& where)
{
    try {
        check(parameters);
    } catch (const InputError& error) {
        const ConfigNode* node = find(table, error.key());
        throw error.moved_to(node ? node->location : where);
    }
}

TileWindow read_window(const ConfigTable& table, std::uint32_t points_per_tile)
{
    const auto values = read_integers(table, "window", 4, 4, -any_integer - 1, "[X, Y, width, height]");
    if (values.empty()) return {0, 0, 6, 4};
    const ConfigNode* node = find(table, "window");
    if (values[2] < 1 || values[3] < 1 || values[2] > max_side || values[3] > max_side ||
        values[2] * values[3] * points_per_tile > max_drawn_points)
        throw invalid_node("window", *node,
                           fmt::format("must be from 1 to {} tiles wide and high, with at most {} points in all",
                                       max_side, max_drawn_points));
    for (const int k : {0, 1})
        if (values[k] < -any_integer / 2 || values[k] > any_integer / 2)
            throw invalid_node("window", *node, "must not be so far away");
    return {values[0], values[1], static_cast<std::uint64_t>(values[2]), static_cast<std::uint64_t>(values[3])};
}

void read_piece(const ConfigTable& table, ConstructionConfig& config)
{
    const PoissonTileParameters& p = config.parameters;
    const int count = axes_count(config.show, p.dimension);
    config.axes = count == p.dimension ? all_axes(p.dimension) : 0;
    if (count > 0 && count < p.dimension) {
        const Directions known = directions(count, p.dimension);
        config.axes = known.axes[read_word(table, "along", known.names)];
    }
    const std::int64_t variants = piece_count(p, config.axes);
    // The master tile is the first of a template set.
    const std::int64_t first = p.kind == PoissonTileKind::frame && config.show == "tile" ? 1 : 0;
    config.variant = static_cast<std::uint32_t>(read_integer(table, "variant", first, variants - 1, first));
    const std::int64_t listed = std::min(variants, max_listed);
    config.count =
        static_cast<std::uint32_t>(read_integer(table, "count", 1, listed, std::min<std::int64_t>(listed, 16)));
}

std::string default_label(const ConstructionConfig& config)
{
    static const std::map<std::string, std::string> stages{
        {"regions", "Regions"},    {"kinds", "Kinds of tiles"},     {"corner", "Corner tile"},
        {"edge", "Edge tile"},     {"face", "Face tile"},           {"tile", "Tile"},
        {"master", "Master tile"}, {"template", "Tile template"},   {"corners", "Corner tiles"},
        {"edges", "Edge tiles"},   {"faces", "Face tiles"},         {"tiles", "Tiles"},
        {"tiling", "Tiling"},      {"points", "Points of a tiling"}};
    const bool space = config.parameters.dimension == 3;
    const std::string kind = config.parameters.kind == PoissonTileKind::frame  ? "template"
                             : config.parameters.kind == PoissonTileKind::edge ? "edge-based"
                                                                               : "corner-based";
    return fmt::format("{}, {} Poisson {} tiles", stages.at(config.show), kind, space ? "sphere" : "disk");
}

/// The kind that has no tiles, and the methods that can be shown of it.
constexpr const char* set_kind = "set";

const std::vector<std::string>& set_shows()
{
    static const std::vector<std::string> shows{"dart-throwing", "relaxation-dart-throwing", "lloyd"};
    return shows;
}

ConstructionConfig read_set(const ConfigTable& table, ConstructionConfig config, std::uint64_t seed)
{
    static const std::vector<std::string> titles{"Dart throwing", "Relaxation dart throwing", "Lloyd relaxation"};
    constexpr std::int64_t most_points_of_a_set = 500; // all of them are in every step
    const std::size_t method = read_word(table, "show", set_shows());
    config.show = set_shows()[method];
    check_keys(table, {"kind", "show", "points", "seed", "label",
                       config.show == "dart-throwing" ? "relative_radius"
                       : config.show == "lloyd"       ? "iterations"
                                                      : "factor"});
    PoissonTileParameters& p = config.parameters;
    p.colors = p.tiles = 1; // the torus, as one tile
    p.points_per_tile = static_cast<std::uint32_t>(read_integer(table, "points", 2, most_points_of_a_set, 200));
    p.relative_radius = read_number(table, "relative_radius", 0.01, 1, 0.7);
    p.lloyd_iterations = static_cast<std::uint32_t>(read_integer(table, "iterations", 0, 200, 30));
    p.factor = read_number(table, "factor", 0.1, 0.999, 0.97);
    p.seed = static_cast<std::uint64_t>(read_integer(table, "seed", 0, any_integer, static_cast<std::int64_t>(seed)));
    config.label = read_text(table, "label", titles[method] + ", step by step");
    return config;
}

ConstructionConfig read_table(const ConfigTable& table, const SourceLocation& where, std::uint64_t seed)
{
    ConstructionConfig config;
    config.where = where;
    std::vector<std::string> kinds = poisson_tile_families.all();
    kinds.emplace_back(set_kind);
    if (read_word(table, "kind", kinds) + 1 == kinds.size()) return read_set(table, std::move(config), seed);
    const PoissonTileFamily family = read_word(table, "kind", poisson_tile_families, {});
    const auto& shows = construction_shows(poisson_tile_families[family]);
    config.show = shows[read_word(table, "show", shows)];
    config.parameters = read_parameters(table, family, seed);
    check_keys(table, known_keys(config));
    check_parameters(config.parameters, table, where);
    if (axes_count(config.show, config.parameters.dimension) >= 0) read_piece(table, config);
    config.modified = read_flag(table, "modified", true);
    config.window = read_window(table, config.parameters.points_per_tile);
    config.label = read_text(table, "label", default_label(config));
    return config;
}

}

bool ConstructionConfig::is_stage() const { return axes_count(show, parameters.dimension) >= 0 && !is_list(); }

bool ConstructionConfig::is_list() const
{
    return show == "corners" || show == "edges" || show == "faces" || show == "tiles";
}

bool ConstructionConfig::is_set() const { return std::ranges::find(set_shows(), show) != set_shows().end(); }

std::string ConstructionConfig::kind() const { return is_set() ? set_kind : kind_name(parameters); }

const std::vector<std::string>& construction_shows(const std::string& kind)
{
    static const std::vector<std::string> plane{"regions", "corner", "edge",   "tile",  "corners",
                                                "edges",   "tiles",  "tiling", "points"};
    static const std::vector<std::string> frame{"master", "template", "tile", "tiles", "tiling", "points"};
    static const std::vector<std::string> space{"regions", "kinds",   "corner", "edge", "face",
                                                "tile",    "corners", "edges",  "faces"};
    return kind == "template" ? frame : kind == "sphere" ? space : plane;
}

std::vector<ConstructionConfig> read_constructions(const ConfigTable& config, std::uint64_t seed)
{
    std::vector<ConstructionConfig> constructions;
    for (const ConfigNode* node : read_tables(config, "construction"))
        constructions.push_back(read_table(*node->get_if<ConfigTable>(), node->location, seed));
    return constructions;
}

}
