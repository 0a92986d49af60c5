// The kinds of [[scheme]] that are tilings by polygons: by substitution, periodic, and of bricks.
#include "host/kinds/kinds.hpp"
#include "host/schemes/polygon_tables.hpp"
#include "host/schemes/scheme_run.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tiles/prototiles/substitution.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

constexpr int most_divisions = 200;

/// The keys `tiling` and `file`; what they name is read where a table is.
void tiling_keys(Keys& keys, PolygonTilingChoice& choice, const std::vector<std::string>& words, bool is_periodic)
{
    keys.word("tiling", choice.word, words, "a tiling that the program brings");
    keys.file("file", choice.file, "a tiling of your own, as TOML").excludes("tiling");
    if (!keys.is_given("file")) return;
    if (tiling_of(choice).is_periodic() != is_periodic)
        throw keys.invalid("file", is_periodic ? "must have a period: kind = \"substitution\" is for those without"
                                               : "must have no period: kind = \"periodic\" is for those with one");
}

/// curves = { a = [[0.3, 0.1]], b = [[0.5, -0.1]] }: points between (0, 0) and (1, 0) by small letters.
void read_curves(const Keys& keys, const ConfigNode& node, std::map<char, PlaneCurve>& curves)
{
    const auto* entries = node.get_if<ConfigTable>();
    if (!entries) throw keys.invalid("curves", "must be a table of lists of points, by letters of edges");
    for (const ConfigEntry& entry : *entries) {
        if (entry.key.size() != 1 || entry.key[0] < 'a' || entry.key[0] > 'z')
            throw invalid_node(entry.key, entry.node, "must be called by the small letter of edges");
        const auto curve = curve_of_node(entry.node);
        if (!curve) throw invalid_node(entry.key, entry.node, "must be a list of points [x, y] from -100 to 100");
        curves[entry.key[0]] = *curve;
    }
}

void style_keys(Keys& keys, PolygonStyle& style, const PolygonTilingChoice& choice)
{
    keys.word("colors", style.colors, {"tiles", "directions"}, "what decides the colour of a tile");
    keys.word("edges", style.edges, {"straight", "puzzle", "curved"}, "how edges with letters are drawn");
    keys.value("curves", "a table of lists of points [x, y], by letters of edges",
               "curves for edges with letters, between (0, 0) and (1, 0)",
               [&](const ConfigNode& node) { read_curves(keys, node, style.curves); })
        .otherwise("none");
    keys.value("shifts", "[length, degrees, length, degrees]", "of p and q, which move the vertices of outlines",
               [&](const ConfigNode& node) {
                   const auto numbers = numbers_of_list(node, 360);
                   if (!numbers || numbers->size() != 4)
                       throw keys.invalid("shifts", "must be [length, degrees, length, degrees]");
                   style.shifts.emplace();
                   std::ranges::copy(*numbers, style.shifts->begin());
               })
        .otherwise("straight edges from corner to corner");
    keys.flag("arcs", style.has_arcs, "whether to draw the arcs that meet where tiles match");
    keys.flag("letters", style.has_letters, "whether to draw the letters of edges");
    if (!keys.is_read()) return;
    const PolygonTiling tiling = tiling_of(choice);
    const auto has_letters = [](const Prototile& p) { return !p.edges.empty(); };
    for (const char* const key : {"edges", "curves", "letters"}) {
        if (!keys.is_given(key) || (key == std::string("edges") && style.edges == "straight")) continue;
        if (!std::ranges::any_of(tiling.prototiles, has_letters))
            throw keys.invalid(key, "is for tilings whose edges have letters");
        if (key != std::string("letters") && mixes_mirrored_tiles(tiling))
            throw keys.invalid(key, "is for tilings without mirrored tiles");
    }
    if (style.shifts && !std::ranges::all_of(tiling.prototiles, [](const Prototile& p) { return !p.outline.empty(); }))
        throw keys.invalid("shifts", "is for tilings whose tiles have an outline with shifts");
    const auto has_arcs = [](const Prototile& p) { return !p.arcs.empty(); };
    if (style.has_arcs && !std::ranges::any_of(tiling.prototiles, has_arcs))
        throw keys.invalid("arcs", "is for tilings whose tiles have arcs");
}

/// Depth, start and address are checked together, as limits follow from the tiling.
void check_substitution(const Keys& keys, const SubstitutionSettings& s)
{
    const PolygonTiling tiling = tiling_of(s.tiling);
    std::size_t start = 0;
    try {
        start = start_of(tiling, s.start);
    } catch (const InputError& error) {
        throw keys.invalid("start", error.what());
    }
    const Substitution substitution(tiling, start);
    const auto refused = [&](const std::string& what) {
        return keys.is_given("depth") ? keys.invalid("depth", what) : keys.problem("depth: " + what);
    };
    if (s.depth > substitution.deepest())
        throw refused(
            fmt::format("must be at most {} for this tiling, whose corners need more than 64-bit integers then",
                        substitution.deepest()));
    if (!s.window && !substitution.counts(s.depth, most_polygon_tiles)) {
        int deepest = 0;
        while (substitution.counts(deepest + 1, most_polygon_tiles)) ++deepest;
        throw refused(fmt::format("must be at most {} without window, for {} tiles", deepest, most_polygon_tiles));
    }
    if (s.place && !s.window) throw keys.invalid("place", "needs window");
    if (s.place && !window_middle(tiling, substitution, s))
        throw keys.invalid("place",
                           "must lie in a tile; with another start or depth, tiles reach elsewhere or farther");
    if (s.address.empty()) return;
    if (!s.window) throw keys.invalid("address", "needs window");
    if (s.address.size() > static_cast<std::size_t>(s.depth) + 1)
        throw keys.invalid("address", fmt::format("must have at most {} numbers, depth + 1", s.depth + 1));
    keys.check("address", [&] { window_middle(tiling, substitution, s); });
}

std::optional<std::array<double, 2>> read_window(const Keys& keys, const ConfigNode& node)
{
    const auto size = numbers_of_list(node);
    if (!size || size->size() != 2 || !(std::ranges::min(*size) >= 1 && std::ranges::max(*size) <= 100))
        throw keys.invalid("window", "must be [width, height], each from 1 to 100");
    return std::array<double, 2>{(*size)[0], (*size)[1]};
}

constexpr auto window_help = "in sides of a square as large as the first tile";

void substitution_keys(Keys& keys, SubstitutionSettings& s)
{
    tiling_keys(keys, s.tiling, substitution_words(), false);
    keys.text("start", s.start, "the tile, or patch of tiles, that is divided").otherwise("the first tile");
    keys.integer("depth", s.depth, 0, most_divisions, "how often tiles are divided");
    keys.value("window", "[width, height], each from 1 to 100", window_help,
               [&](const ConfigNode& node) { s.window = read_window(keys, node); })
        .otherwise("all tiles");
    keys.value("address", "a list of integers",
               "the tile in the middle of the window: of the start, then a part a division",
               [&](const ConfigNode& node) {
                   const auto numbers = numbers_of_list(node);
                   const auto is_wrong = [](double c) { return c != std::floor(c) || c < 0; };
                   if (!numbers || numbers->empty() || std::ranges::any_of(*numbers, is_wrong))
                       throw keys.invalid("address", "must be a list of integers from 0 on");
                   for (const double number : *numbers) s.address.push_back(static_cast<std::int64_t>(number));
               })
        .otherwise("the first part of every tile");
    keys.value("place", "[x, y], each from -1e12 to 1e12",
               "the place in the middle of the window, in the unit of the tiling's corners",
               [&](const ConfigNode& node) {
                   const auto numbers = numbers_of_list(node, 1e12);
                   if (!numbers || numbers->size() != 2)
                       throw keys.invalid("place", "must be [x, y], each from -1e12 to 1e12");
                   s.place = {(*numbers)[0], (*numbers)[1]};
               })
        .excludes("address")
        .otherwise("that of the address");
    style_keys(keys, s.style, s.tiling);
    if (keys.is_read()) check_substitution(keys, s);
}

void periodic_keys(Keys& keys, PeriodicSettings& s)
{
    tiling_keys(keys, s.tiling, periodic_words(), true);
    keys.value("window", "[width, height], each from 1 to 100", window_help,
               [&](const ConfigNode& node) { s.window = *read_window(keys, node); })
        .otherwise("[16, 12]");
    keys.flag("unit", s.shows_unit, "whether to draw a period");
    style_keys(keys, s.style, s.tiling);
}

void brick_keys(Keys& keys, BrickSettings& s) { keys.integer("digits", s.digits, 1, 10'000, "of pi"); }

std::string tiling_label(const PolygonTilingChoice& choice)
{
    return choice.file.empty() ? built_in_tiling(choice.word).title : choice.file.stem().string();
}

}

PolygonTiling tiling_of(const PolygonTilingChoice& choice)
{
    return choice.file.empty() ? built_in_tiling(choice.word) : read_polygon_tiling(choice.file);
}

Kind substitution_kind()
{
    return make_kind<SubstitutionSettings>(
        {"scheme", "substitution", "", "Substitution tiling",
         "Draw a tiling by substitution: Penrose's tiles, rep-tiles, the hat, the spectre, and those of your own",
         false},
        substitution_keys,
        [](const SubstitutionSettings& s) { return fmt::format("{}, {} divisions", tiling_label(s.tiling), s.depth); },
        [](const SubstitutionSettings& s, std::uint64_t, DistributionFiles& files) {
            return make_substitution(s, files);
        });
}

Kind periodic_kind()
{
    return make_kind<PeriodicSettings>(
        {"scheme", "periodic", "", "Periodic tiling",
         "Draw a periodic tiling by polygons: the Archimedean ones, and those of your own", false},
        periodic_keys, [](const PeriodicSettings& s) { return fmt::format("Tiling {}", tiling_label(s.tiling)); },
        [](const PeriodicSettings& s, std::uint64_t, DistributionFiles& files) { return make_periodic(s, files); });
}

Kind brick_kind()
{
    return make_kind<BrickSettings>(
        {"scheme", "bricks", "", "Bricks by digits of pi", "Draw pairs of bricks placed by the binary digits of pi",
         false},
        brick_keys, [](const BrickSettings& s) { return fmt::format("Bricks by {} digits of pi", s.digits); },
        [](const BrickSettings& s, std::uint64_t, DistributionFiles& files) { return make_bricks(s, files); });
}

}
