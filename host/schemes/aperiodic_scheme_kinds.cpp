// The kinds of [[scheme]] that are about aperiodic sets, isohedral tilings and surfaces.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapter 8.
#include "host/kinds/kinds.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr auto curves_allowed = "a list of curves, each a list of points [x, y] from -100 to 100";

/// curves = [[[0.3, 0.1], [0.7, -0.1]], ...]: the points of each between (0, 0) and (1, 0).
std::vector<PlaneCurve> curves_of(const Keys& keys, const ConfigNode& node)
{
    const auto refused = [&] { return keys.invalid("curves", std::string("must be ") + curves_allowed); };
    const auto* curves = node.get_if<ConfigList>();
    if (!curves) throw refused();
    std::vector<PlaneCurve> all;
    for (const ConfigNode& curve : *curves) {
        const auto read = curve_of_node(curve);
        if (!read) throw refused();
        all.push_back(*read);
    }
    return all;
}

/// A list of `count` colours, each below `colors`; where it is not given, they are 0.
std::vector<std::uint32_t> read_colors_of(const ConfigTable& entries, const char* key, std::size_t count,
                                          std::uint32_t colors)
{
    const ConfigNode* node = find(entries, key);
    if (!node) return std::vector<std::uint32_t>(count);
    const auto numbers = numbers_of_list(*node);
    const auto is_color = [&](double number) { return number == std::floor(number) && number >= 0 && number < colors; };
    if (!numbers || numbers->size() != count || !std::ranges::all_of(*numbers, is_color))
        throw invalid_node(key, *node, fmt::format("must be a list of {} colours from 0 to {}", count, colors - 1));
    return {numbers->begin(), numbers->end()};
}

/// Two permutations of the colours, each a list of the colours that follow 0, 1, ...
std::array<std::vector<std::uint32_t>, 2> read_permutations(const ConfigTable& entries, std::uint32_t colors)
{
    const ConfigNode& node = *find(entries, "permutations");
    const auto refused = [&] {
        return invalid_node("permutations", node,
                            fmt::format("must be two lists of all colours from 0 to {}", colors - 1));
    };
    const auto* lists = node.get_if<ConfigList>();
    if (!lists || lists->size() != 2) throw refused();
    std::array<std::vector<std::uint32_t>, 2> permutations;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto numbers = numbers_of_list((*lists)[i]);
        if (!numbers || numbers->size() != colors) throw refused();
        for (std::uint32_t color = 0; color < colors; ++color)
            if (std::ranges::count(*numbers, static_cast<double>(color)) != 1) throw refused();
        permutations[i].assign(numbers->begin(), numbers->end());
    }
    return permutations;
}

/// coloring = { colors = 3, aspects = [0, 1, 2], steps = [1, 2] }, or with permutations = [[1, 2, 0], [2, 0, 1]] in
/// place of steps: see TileColoring.
TileColoring coloring_of(const Keys& keys, const ConfigNode& node, std::size_t aspects)
{
    const auto* entries = node.get_if<ConfigTable>();
    if (!entries) throw keys.invalid("coloring", "must be a table { colors, aspects, steps or permutations }");
    check_keys(*entries, {"colors", "aspects", "steps", "permutations"});
    TileColoring coloring;
    Keys(*entries, node.location, "").integer("colors", coloring.colors, 1, 8, "how many there are");
    coloring.aspects = read_colors_of(*entries, "aspects", aspects, coloring.colors);
    if (find(*entries, "permutations")) {
        if (find(*entries, "steps")) throw keys.invalid("coloring", "must have steps or permutations, not both");
        coloring.permutations = read_permutations(*entries, coloring.colors);
        return coloring;
    }
    const auto steps = read_colors_of(*entries, "steps", 2, coloring.colors);
    coloring.steps = {steps[0], steps[1]};
    return coloring;
}

/// A tiling with Wang or corner tiles by the word of its algorithm, if it is one.
std::optional<TilingRequest> request_of_word(const std::string& word, Color colors)
{
    TilingRequest request;
    request.algorithm = word;
    for (const TileKind kind : {TileKind::wang, TileKind::corner}) {
        const auto& known = tiling_algorithms(kind);
        if (std::ranges::find(known, word) == known.end()) continue;
        request.kind = kind;
        const Color own = own_colors(kind, word);
        request.colors = own > 0 ? own : colors;
        return request;
    }
    return std::nullopt;
}

void lattice_keys(Keys& keys, ConstructionSettings& s)
{
    keys.word("set", s.set, {"ammann", "culik", "kari"}, "the Wang tiles");
    keys.word("construction", s.construction, corner_constructions, "what makes corner tiles of them");
    std::array<std::uint32_t, 2> size{static_cast<std::uint32_t>(s.width), static_cast<std::uint32_t>(s.height)};
    keys.integers("window", size, {1, 8}, {"width", "height"}, "Wang tiles that are drawn");
    s.width = size[0];
    s.height = size[1];
}

void aperiodic_table_keys(Keys& keys, AperiodicTableSettings& s)
{
    constexpr std::int64_t widest = 8; // 214 tiles take seconds there, and several times as long for each one more
    keys.integer("width", s.width, 1, widest, "the widest cylinder of the search for periods");
}

/// The tilings by their words, which are different ones.
void read_words_of_tilings(const Keys& keys, const ConfigNode& node, std::vector<std::string>& words)
{
    constexpr auto allowed = "must be a list of different algorithms of Wang or corner tiles";
    words.clear();
    const auto* items = node.get_if<ConfigList>();
    if (!items || items->empty()) throw keys.invalid("tilings", allowed);
    for (const ConfigNode& item : *items) {
        const auto* word = item.get_if<std::string>();
        if (!word || std::ranges::find(words, *word) != words.end()) throw keys.invalid("tilings", allowed);
        if (!request_of_word(*word, 2))
            throw keys.invalid("tilings", fmt::format("{}; \"{}\" is none", allowed, *word));
        words.push_back(*word);
    }
}

void diffraction_keys(Keys& keys, DiffractionSettings& s)
{
    constexpr std::int64_t least_size = 256, most_size = 1024; // the pictures show 256 tiles along each side
    std::vector<std::string> words{"scanline-compact", "ammann"};
    keys.value("tilings", "a list of algorithms of Wang or corner tiles", "what is compared",
               [&](const ConfigNode& node) { read_words_of_tilings(keys, node, words); })
        .otherwise("scanline-compact, ammann");
    Color colors = 2;
    keys.integer("colors", colors, 2, max_scanline_colors, "of those that can have several");
    keys.integer("size", s.size, least_size, most_size, "tiles along each axis");
    Color fewest = max_colors;
    s.tilings.clear();
    for (const std::string& word : words) {
        s.tilings.push_back(*request_of_word(word, colors));
        fewest = std::min(fewest, s.tilings.back().colors);
    }
    keys.integer("color", s.color, 0, fewest - 1, "whose power is shown");
}

/// Parameters and curves of a tile, which are random or given.
void shape_keys(Keys& keys, IsohedralSettings& s, const IsohedralType& type)
{
    constexpr auto numbers_allowed = "a list of numbers from -100 to 100";
    keys.flag("random", s.is_random, "whether parameters and curves are random");
    keys.value("parameters", numbers_allowed, "where the corners are",
               [&](const ConfigNode& node) {
                   const auto numbers = numbers_of_list(node);
                   if (!numbers) throw keys.invalid("parameters", std::string("must be ") + numbers_allowed);
                   s.parameters.deformations = *numbers;
               })
        .otherwise("those of the Laves tiling");
    keys.value("curves", curves_allowed, "the points of curves between (0, 0) and (1, 0)",
               [&](const ConfigNode& node) { s.parameters.curves = curves_of(keys, node); })
        .otherwise("straight");
    for (const char* const key : {"parameters", "curves"})
        if (s.is_random && keys.is_given(key)) throw keys.invalid(key, "cannot be combined with random = true");
    const std::size_t given = s.parameters.deformations.size(), needed = type.shape.parameters();
    if (given > 0 && given != needed)
        throw keys.invalid("parameters", fmt::format("must be as many as IH{} has: {}", type.number, needed));
    if (s.parameters.curves.size() > type.shape.curve_shapes.size())
        throw keys.invalid("curves",
                           fmt::format("must be at most {} for IH{}", type.shape.curve_shapes.size(), type.number));
}

void isohedral_keys(Keys& keys, IsohedralSettings& s)
{
    keys.integer("type", s.type, 1, 93, "of Gruenbaum and Shephard");
    const IsohedralType& type = isohedral_types()[static_cast<std::size_t>(s.type - 1)];
    shape_keys(keys, s, type);
    keys.value("coloring", "a table { colors, aspects, steps or permutations }", "the colours of tiles",
               [&](const ConfigNode& node) { s.coloring = coloring_of(keys, node, type.shape.aspects.size()); })
        .otherwise("the fewest colours");
    keys.value("window", "[width, height], each from 1 to 100", "in sides of a square as large as the tile",
               [&](const ConfigNode& node) {
                   const auto size = numbers_of_list(node);
                   if (!size || size->size() != 2 || !(std::ranges::min(*size) >= 1 && std::ranges::max(*size) <= 100))
                       throw keys.invalid("window", "must be [width, height], each from 1 to 100");
                   s.columns = (*size)[0];
                   s.rows = (*size)[1];
               })
        .otherwise("[10, 10]");
    if (keys.is_read()) keys.check([&] { tile_of(s, 1); });
}

void surface_keys(Keys& keys, SurfaceSettings& s)
{
    constexpr auto allowed = "a list of different cubes [x, y, z], at most 1000, from -50 to 50";
    constexpr double farthest = 50;
    constexpr std::size_t most_cubes = 1000;
    keys.integer("colors", s.colors, 2, 8, "of the surface's vertices");
    s.cubes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}};
    const auto read = [&](const ConfigNode& node) {
        const auto refused = [&] { return keys.invalid("cubes", std::string("must be ") + allowed); };
        const auto* cubes = node.get_if<ConfigList>();
        if (!cubes || cubes->empty() || cubes->size() > most_cubes) throw refused();
        s.cubes.clear();
        for (const ConfigNode& cube : *cubes) {
            const auto place = numbers_of_list(cube);
            const auto is_wrong = [](double c) { return c != std::floor(c) || std::abs(c) > farthest; };
            if (!place || place->size() != 3 || std::ranges::any_of(*place, is_wrong)) throw refused();
            s.cubes.push_back(
                {static_cast<int>((*place)[0]), static_cast<int>((*place)[1]), static_cast<int>((*place)[2])});
        }
        std::ranges::sort(s.cubes);
        if (std::ranges::adjacent_find(s.cubes) != s.cubes.end()) throw refused();
    };
    keys.value("cubes", allowed, "the polycube", read).otherwise("six of them");
}

}

Kind lattice_construction_kind()
{
    return make_kind<ConstructionSettings>(
        {"scheme", "construction", "", "Lattices of constructions",
         "Draw Wang tiles, and the corner tiles that are made of them", false},
        lattice_keys,
        [](const ConstructionSettings& s) {
            return fmt::format("The {} construction", corner_constructions[s.construction]);
        },
        make_construction);
}

Kind aperiodic_table_kind()
{
    return make_kind<AperiodicTableSettings>(
        {"scheme", "aperiodic-tables", "", "Aperiodic sets",
         "Compare printed tables of aperiodic sets with computed ones", false},
        aperiodic_table_keys,
        [](const AperiodicTableSettings&) { return std::string("Sets of corner tiles made of aperiodic sets"); },
        [](const AperiodicTableSettings& s, std::uint64_t, DistributionFiles& files) {
            return make_aperiodic_tables(s, files);
        });
}

Kind diffraction_kind()
{
    return make_kind<DiffractionSettings>(
        {"scheme", "diffraction", "", "Diffraction", "Measure how much tilings repeat", false}, diffraction_keys,
        [](const DiffractionSettings&) { return std::string("Aperiodic and stochastic tilings"); },
        [](const DiffractionSettings& s, std::uint64_t seed, DistributionFiles& files) {
            DiffractionSettings own = s;
            for (TilingRequest& request : own.tilings) request.seed = seed;
            return make_diffraction(own, files);
        });
}

Kind isohedral_kind()
{
    return make_kind<IsohedralSettings>(
        {"scheme", "isohedral", "", "Isohedral tiling", "Draw a tiling of a type with parameters, curves and colours",
         false},
        isohedral_keys, [](const IsohedralSettings& s) { return fmt::format("Isohedral tiling of type IH{}", s.type); },
        make_isohedral);
}

Kind surface_kind()
{
    return make_kind<SurfaceSettings>(
        {"scheme", "surface", "", "Tiled surface", "Draw corner tiles on the faces of a polycube", false}, surface_keys,
        [](const SurfaceSettings&) { return std::string("Corner tiles on a polycube"); },
        [](const SurfaceSettings& s, std::uint64_t seed, DistributionFiles& files) {
            return make_surface(s, seed, files);
        });
}

IsohedralTile tile_of(const IsohedralSettings& settings, std::uint64_t seed)
{
    const IsohedralType& type = isohedral_types()[static_cast<std::size_t>(settings.type - 1)];
    if (settings.is_random) return random_tile(type, seed, drawn_deformation, drawn_amplitude);
    return {type, settings.parameters};
}

}
