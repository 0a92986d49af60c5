// The kinds of [[construction]]: pictures of how Poisson tile sets, and point sets, come into being.
#include "base/files/whole_file.hpp"
#include "base/programs/interrupt.hpp"
#include "host/device/device.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/kinds/kinds.hpp"
#include "host/scenes/construction_panels.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "results/file_names.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace poissonlab {
namespace {

/// Thrown by a construction once all that is shown has been made.
struct AllIsMade
{
};

MadeTiles make_tiles(const ShownConstruction& shown, const DistributionPlace& place)
{
    const PoissonTileParameters& parameters = shown.parameters;
    const std::vector<PieceKey> keys = shown.is_set() ? std::vector<PieceKey>{} : wanted_pieces(shown);
    const std::set<PieceKey> wanted(keys.begin(), keys.end());
    MadeTiles made;
    if (wanted.empty() && !shown.is_tiling()) return made;
    ConstructionOptions options;
    options.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
        stop_if_interrupted();
        if (place.on_step)
            place.on_step(fmt::format("{} Poisson tiles: {} {} of {}", kind_name(parameters), stage, done, total));
    };
    // Pieces that are made again replace those before.
    options.record = [&](const ConstructionRecord& record) {
        const PieceKey key{record.axes, record.variant};
        if (!wanted.contains(key)) return;
        made.pieces[key] = {record.base, record.held, *record.problem, *record.filled};
        if (!shown.is_tiling() && made.pieces.size() == wanted.size()) throw AllIsMade{};
    };
    try {
        made.set = build_tile_set(parameters, place.engine, place.device, options).set;
    } catch (const AllIsMade&) {
    }
    return made;
}

/// The construction goes no further than the pieces that are shown. Throws InputError for tile sets that cannot be
/// made.
Scene construct_scene(const ShownConstruction& shown, const DistributionPlace& place)
{
    return make_scene(shown, make_tiles(shown, place));
}

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

/// The samplers' defaults, but for sizes: few points can be told apart, and no config of a picture has to name a size.
/// So few points in space cannot have the samplers' radius: it is at most 0.738 for 64.
TileSetDefaults drawn_sizes(const PoissonTileFamily& family)
{
    TileSetDefaults sizes{
        {"colors", std::int64_t{2}}, {"tiles", std::int64_t{8}}, {"points_per_tile", std::int64_t{32}}};
    if (family.dimension == 2) return sizes;
    sizes["points_per_tile"] = std::int64_t{64};
    sizes["relative_radius"] = 0.6;
    return sizes;
}

void window_keys(Keys& keys, ShownConstruction& s)
{
    std::vector<std::int64_t> w{0, 0, 6, 4};
    keys.whole_numbers("window", w, -any_integer - 1, {"X", "Y", "width", "height"}, "the tiles that are drawn")
        .only_if(s.is_tiling(), "show = tiling, points");
    if (!keys.is_given("window")) return;
    const auto fits = [](std::int64_t size) { return size >= 1 && size <= max_side; };
    if (!fits(w[2]) || !fits(w[3]) || w[2] * w[3] * s.parameters.points_per_tile > max_drawn_points)
        throw keys.invalid("window", fmt::format("must be from 1 to {} tiles wide and high, with at most {} points in "
                                                 "all",
                                                 max_side, max_drawn_points));
    for (const int k : {0, 1})
        if (w[k] < -any_integer / 2 || w[k] > any_integer / 2) throw keys.invalid("window", "must not be so far away");
    s.window = {w[0], w[1], static_cast<std::uint64_t>(w[2]), static_cast<std::uint64_t>(w[3])};
}

void piece_keys(Keys& keys, ShownConstruction& s)
{
    const PoissonTileParameters& p = s.parameters;
    const int count = axes_count(s.show, p.dimension);
    const bool has_direction = count > 0 && count < p.dimension;
    s.axes = count == p.dimension ? all_axes(p.dimension) : 0;
    if (p.kind != PoissonTileKind::frame) {
        const Directions known = directions(has_direction ? count : 1, p.dimension);
        std::string along = known.names.front();
        keys.word("along", along, known.names, "the direction of the piece")
            .only_if(has_direction, p.dimension == 2 ? "show = edge, edges" : "show = edge, edges, face, faces");
        if (has_direction) s.axes = known.axes[std::ranges::find(known.names, along) - known.names.begin()];
    }
    const std::int64_t variants = count < 0 ? 1 : piece_count(p, s.axes);
    const bool has_variants = s.is_stage() && s.show != "master" && s.show != "template";
    // The master tile is the first of a template set.
    const std::int64_t first = p.kind == PoissonTileKind::frame && s.show == "tile" ? 1 : 0;
    s.variant = static_cast<std::uint32_t>(first);
    const std::int64_t most = keys.is_read() && has_variants ? variants - 1 : any_integer;
    keys.integer("variant", s.variant, first, std::max(first, most), "which piece or tile: its colours as digits")
        .only_if(has_variants, "show = corner, edge, face, tile");
    const std::int64_t listed = keys.is_read() && s.is_list() ? std::min(variants, max_listed) : max_listed;
    s.count = static_cast<std::uint32_t>(std::min<std::int64_t>(listed, 16));
    keys.integer("count", s.count, 1, listed, "how many pieces or tiles")
        .only_if(s.is_list(), "show = corners, edges, faces, tiles");
}

void construction_keys(Keys& keys, ShownConstruction& s)
{
    const auto& shows = construction_shows(poisson_tile_families[s.tiles.family]);
    s.show = shows.front();
    keys.word("show", s.show, shows, "what is drawn");
    tile_set_keys(keys, s.tiles, drawn_sizes(s.tiles.family));
    keys.integer("seed", s.seed, 0, any_integer, "of the tile set").otherwise("that of the config");
    s.parameters = s.tiles.parameters(s.seed.value_or(1));
    if (keys.is_given("border") && s.parameters.border == TileBorder::chain && !s.is_tiling())
        throw keys.invalid("border", "must be strip, or show must be tiling or points: chains have no pieces to show");
    piece_keys(keys, s);
    if (s.parameters.dimension == 3)
        keys.flag("modified", s.modified, "whether regions are those that tiles need, or those around corners alone")
            .only_if(s.show == "regions", "show = regions");
    else
        window_keys(keys, s);
}

std::string construction_label(const ShownConstruction& s)
{
    static const std::map<std::string, std::string> stages{
        {"regions", "Regions"},    {"kinds", "Kinds of tiles"},     {"corner", "Corner tile"},
        {"edge", "Edge tile"},     {"face", "Face tile"},           {"tile", "Tile"},
        {"master", "Master tile"}, {"template", "Tile template"},   {"corners", "Corner tiles"},
        {"edges", "Edge tiles"},   {"faces", "Face tiles"},         {"tiles", "Tiles"},
        {"tiling", "Tiling"},      {"points", "Points of a tiling"}};
    const std::string kind = s.parameters.kind == PoissonTileKind::frame  ? "template"
                             : s.parameters.kind == PoissonTileKind::edge ? "edge-based"
                                                                          : "corner-based";
    return fmt::format("{}, {} Poisson {} tiles", stages.at(s.show), kind,
                       s.parameters.dimension == 3 ? "sphere" : "disk");
}

/// The kind that has no tiles, and the methods that can be shown of it.
constexpr const char* set_kind = "set";

const std::vector<std::string>& set_shows()
{
    static const std::vector<std::string> shows{"dart-throwing", "relaxation-dart-throwing", "lloyd"};
    return shows;
}

void set_keys(Keys& keys, ShownConstruction& s)
{
    constexpr std::int64_t most_points_of_a_set = 500; // all of them are in every step
    PoissonTileParameters& p = s.parameters;
    p.colors = p.tiles = 1; // the torus, as one tile
    p.points_per_tile = 200;
    p.relative_radius = 0.7;
    p.lloyd_iterations = 30;
    p.factor = 0.97;
    s.show = set_shows().front();
    keys.word("show", s.show, set_shows(), "the method");
    keys.integer("points", p.points_per_tile, 2, most_points_of_a_set, "the number of points");
    keys.number("relative_radius", p.relative_radius, {0.01, 1}, "the radius of darts")
        .only_if(s.show == "dart-throwing", "show = dart-throwing");
    keys.number("factor", p.factor, {0.1, 0.999}, "what the radius is multiplied by where darts fail")
        .only_if(s.show == "relaxation-dart-throwing", "show = relaxation-dart-throwing");
    keys.integer("iterations", p.lloyd_iterations, 0, 200, "steps of Lloyd's method")
        .only_if(s.show == "lloyd", "show = lloyd");
    keys.integer("seed", s.seed, 0, any_integer, "of the set").otherwise("that of the config");
}

std::string set_label(const ShownConstruction& s)
{
    const std::string title = s.show == "lloyd"           ? "Lloyd relaxation"
                              : s.show == "dart-throwing" ? "Dart throwing"
                                                          : "Relaxation dart throwing";
    return title + ", step by step";
}

ConstructionResult make_shown(const ShownConstruction& shown, std::uint64_t seed, const DistributionPlace& place,
                              DistributionFiles& files)
{
    ShownConstruction own = shown;
    PoissonTileParameters& p = own.parameters;
    p.seed = shown.seed.value_or(seed);
    const Scene scene = construct_scene(own, place);
    write_whole_file(files.add(file_names::construction), scene_json(scene));
    return {.name = {},
            .label = {},
            .kind = own.kind(),
            .show = own.show,
            .colors = p.colors,
            .tiles = p.tiles,
            .points_per_tile = p.points_per_tile,
            .relative_radius = p.relative_radius,
            .filling = tile_fillings[p.filling],
            .lloyd_iterations = static_cast<int>(p.lloyd_iterations),
            .repulsion = p.repulsion,
            .seed = std::to_string(p.seed),
            .file = file_names::construction,
            .scene = summary_of(scene)};
}

std::string construction_folder(const KindSettings& settings)
{
    const auto& shown = settings.as<ShownConstruction>();
    return fmt::format("construction-{}-{}", shown.kind(), shown.show);
}

}

bool ShownConstruction::is_stage() const { return axes_count(show, parameters.dimension) >= 0 && !is_list(); }

bool ShownConstruction::is_list() const
{
    return show == "corners" || show == "edges" || show == "faces" || show == "tiles";
}

bool ShownConstruction::is_set() const { return std::ranges::find(set_shows(), show) != set_shows().end(); }

std::string ShownConstruction::kind() const { return is_set() ? set_kind : kind_name(parameters); }

const std::vector<std::string>& construction_shows(const std::string& kind)
{
    static const std::vector<std::string> plane{"regions", "corner", "edge",   "tile",  "corners",
                                                "edges",   "tiles",  "tiling", "points"};
    static const std::vector<std::string> frame{"master", "template", "tile", "tiles", "tiling", "points"};
    static const std::vector<std::string> space{"regions", "kinds",   "corner", "edge", "face",
                                                "tile",    "corners", "edges",  "faces"};
    return kind == "template" ? frame : kind == "sphere" ? space : plane;
}

std::vector<Kind> construction_kinds()
{
    std::vector<Kind> kinds;
    for (const auto& [family, word] : poisson_tile_families.entries) {
        ShownConstruction defaults;
        defaults.tiles.family = family;
        kinds.push_back(make_kind({"construction", word, "", fmt::format("Construction of {} tiles", word),
                                   fmt::format("Draw how Poisson {} tiles are made", word)},
                                  construction_keys, construction_label, make_shown, defaults));
        kinds.back().device_memory = [](const KindSettings& settings, const DeviceInfo& device) {
            return construction_memory(settings.as<ShownConstruction>().parameters, device);
        };
    }
    kinds.push_back(make_kind<ShownConstruction>({"construction", set_kind, "", "Construction of a point set",
                                                  "Draw how a method makes a set, step by step", false},
                                                 set_keys, set_label, make_shown));
    for (Kind& kind : kinds) kind.folder = construction_folder;
    return kinds;
}

}
