#include "host/config/schemes/aperiodic_scheme_table.hpp"

#include "base/errors/errors.hpp"
#include "host/config/config_values.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double most_listed = 100; ///< sides of isohedral tiles are about 1

/// The numbers of a list, from -100 to 100; `allowed` is how messages describe it.
std::vector<double> numbers_of_list(const std::string& key, const ConfigNode& node, const ConfigNode& list,
                                    const char* allowed)
{
    const auto* items = list.get_if<ConfigList>();
    if (!items) throw invalid_node(key, node, allowed);
    std::vector<double> numbers;
    for (const ConfigNode& item : *items) {
        const auto* whole = item.get_if<std::int64_t>();
        const auto* real = item.get_if<double>();
        if (!whole && !real) throw invalid_node(key, node, allowed);
        numbers.push_back(whole ? static_cast<double>(*whole) : *real);
        if (!(std::abs(numbers.back()) <= most_listed)) throw invalid_node(key, node, allowed);
    }
    return numbers;
}

/// curves = [[[0.3, 0.1], [0.7, -0.1]], ...]: the points of each between (0, 0) and (1, 0).
std::vector<PlaneCurve> read_curves(const ConfigTable& table)
{
    constexpr const char* allowed = "must be a list of curves, each a list of points [x, y] from -100 to 100";
    const ConfigNode* const node = find(table, "curves");
    if (!node) return {};
    const auto* curves = node->get_if<ConfigList>();
    if (!curves) throw invalid_node("curves", *node, allowed);
    std::vector<PlaneCurve> all;
    for (const ConfigNode& curve : *curves) {
        const auto* points = curve.get_if<ConfigList>();
        if (!points) throw invalid_node("curves", *node, allowed);
        all.push_back({{0, 0}});
        for (const ConfigNode& point : *points) {
            const auto numbers = numbers_of_list("curves", *node, point, allowed);
            if (numbers.size() != 2) throw invalid_node("curves", *node, allowed);
            all.back().push_back({numbers[0], numbers[1]});
        }
        all.back().push_back({1, 0});
    }
    return all;
}

/// A list of `count` colours, each below `colors`.
std::vector<std::uint32_t> read_colors_of(const ConfigTable& entries, const char* key, std::size_t count,
                                          std::uint32_t colors)
{
    const std::string allowed = fmt::format("a list of {} colours from 0 to {}", count, colors - 1);
    std::vector<std::uint32_t> read(count);
    const auto numbers = read_integers(entries, key, count, count, 0, allowed.c_str());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] >= colors) throw invalid_node(key, *find(entries, key), "must be " + allowed);
        read[i] = static_cast<std::uint32_t>(numbers[i]);
    }
    return read;
}

/// coloring = { colors = 3, aspects = [0, 1, 2], steps = [1, 2] }: see TileColoring.
std::optional<TileColoring> read_coloring(const ConfigTable& table, std::size_t aspects)
{
    const ConfigNode* const node = find(table, "coloring");
    if (!node) return std::nullopt;
    const auto* entries = node->get_if<ConfigTable>();
    if (!entries) throw invalid_node("coloring", *node, "must be a table { colors, aspects, steps }");
    check_keys(*entries, {"colors", "aspects", "steps"});
    TileColoring coloring;
    coloring.colors = static_cast<std::uint32_t>(read_integer(*entries, "colors", 1, 8, 1));
    coloring.aspects = read_colors_of(*entries, "aspects", aspects, coloring.colors);
    const auto steps = read_colors_of(*entries, "steps", 2, coloring.colors);
    coloring.steps = {steps[0], steps[1]};
    return coloring;
}

/// A tiling with Wang or corner tiles by the word of its algorithm, if it is one.
std::optional<TilingRequest> request_of_word(const std::string& word, Color colors, std::uint64_t seed)
{
    TilingRequest request;
    request.seed = seed;
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

}

SchemeChoice read_construction_scheme(const ConfigTable& table, std::uint64_t)
{
    check_keys(table, {"kind", "label", "set", "construction", "window"});
    constexpr std::int64_t most_side = 8;
    constexpr const char* allowed = "[width, height], each from 1 to 8";
    static const std::vector<std::string> sets{"ammann", "culik", "kari"};
    ConstructionSettings settings;
    settings.set = sets[read_word(table, "set", sets)];
    settings.construction = read_word(table, "construction", corner_constructions, CornerConstruction::diagonal);
    const auto size = read_integers(table, "window", 2, 2, 1, allowed);
    if (!size.empty()) {
        if (std::ranges::max(size) > most_side)
            throw invalid_node("window", *find(table, "window"), fmt::format("must be {}", allowed));
        settings.width = static_cast<std::uint64_t>(size[0]);
        settings.height = static_cast<std::uint64_t>(size[1]);
    }
    return {settings, fmt::format("The {} construction", corner_constructions[settings.construction])};
}

SchemeChoice read_aperiodic_tables(const ConfigTable& table, std::uint64_t)
{
    check_keys(table, {"kind", "label", "width"});
    constexpr std::int64_t widest = 8; // 214 tiles take seconds there, and several times as long for each one more
    return {AperiodicTableSettings{static_cast<std::size_t>(read_integer(table, "width", 1, widest, 6))},
            "Sets of corner tiles made of aperiodic sets"};
}

SchemeChoice read_diffraction(const ConfigTable& table, std::uint64_t seed)
{
    check_keys(table, {"kind", "label", "tilings", "colors", "size", "color"});
    constexpr std::int64_t least_size = 256, most_size = 1024; // the pictures show 256 tiles along each side
    constexpr const char* allowed = "must be a list of different algorithms of Wang or corner tiles";
    DiffractionSettings settings;
    settings.size = static_cast<std::uint64_t>(read_integer(table, "size", least_size, most_size, 512));
    const auto colors = static_cast<Color>(read_integer(table, "colors", 2, max_scanline_colors, 2));
    std::vector<std::string> words{"scanline-compact", "ammann"};
    const ConfigNode* const node = find(table, "tilings");
    if (node) {
        words.clear();
        const auto* items = node->get_if<ConfigList>();
        if (!items || items->empty()) throw invalid_node("tilings", *node, allowed);
        for (const ConfigNode& item : *items) {
            const auto* word = item.get_if<std::string>();
            if (!word || std::ranges::find(words, *word) != words.end()) throw invalid_node("tilings", *node, allowed);
            words.push_back(*word);
        }
    }
    Color fewest = max_colors;
    for (const std::string& word : words) {
        const auto request = request_of_word(word, colors, seed);
        if (!request) throw invalid_node("tilings", *node, fmt::format("{}; \"{}\" is none", allowed, word));
        settings.tilings.push_back(*request);
        fewest = std::min(fewest, request->colors);
    }
    settings.color = static_cast<Color>(read_integer(table, "color", 0, fewest - 1, 0));
    return {settings, "Aperiodic and stochastic tilings"};
}

SchemeChoice read_isohedral(const ConfigTable& table, std::uint64_t seed)
{
    check_keys(table, {"kind", "label", "type", "parameters", "curves", "random", "coloring", "window"});
    IsohedralSettings settings;
    settings.type = static_cast<int>(read_integer(table, "type", 1, 93, settings.type));
    const IsohedralType& type = isohedral_types()[static_cast<std::size_t>(settings.type - 1)];
    settings.is_random = read_flag(table, "random", false);
    if (const ConfigNode* const node = find(table, "parameters"))
        settings.parameters.deformations =
            numbers_of_list("parameters", *node, *node, "must be a list of numbers from -100 to 100");
    settings.parameters.curves = read_curves(table);
    for (const char* const key : {"parameters", "curves"})
        if (settings.is_random && find(table, key))
            throw invalid_node(key, *find(table, key), "does not go with random = true");
    if (settings.parameters.curves.size() > type.shape.curve_shapes.size())
        throw invalid_node("curves", *find(table, "curves"),
                           fmt::format("must be at most {} for IH{}", type.shape.curve_shapes.size(), type.number));
    settings.coloring = read_coloring(table, type.shape.aspects.size());
    if (const ConfigNode* const node = find(table, "window")) {
        constexpr const char* allowed = "must be [width, height], each from 1 to 100";
        const auto size = numbers_of_list("window", *node, *node, allowed);
        if (size.size() != 2 || !(std::ranges::min(size) >= 1 && std::ranges::max(size) <= 100))
            throw invalid_node("window", *node, allowed);
        settings.columns = size[0];
        settings.rows = size[1];
    }
    tile_of(settings, seed); // whose parameters are checked
    return {settings, fmt::format("Isohedral tiling of type IH{}", settings.type)};
}

SchemeChoice read_surface(const ConfigTable& table, std::uint64_t)
{
    check_keys(table, {"kind", "label", "cubes", "colors"});
    constexpr const char* allowed = "must be a list of different cubes [x, y, z], at most 1000, from -50 to 50";
    constexpr double farthest = 50;
    constexpr std::size_t most_cubes = 1000;
    SurfaceSettings settings;
    settings.colors = static_cast<Color>(read_integer(table, "colors", 2, 8, 3));
    const ConfigNode* const node = find(table, "cubes");
    if (!node) {
        settings.cubes = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}};
        return {settings, "Corner tiles on a polycube"};
    }
    const auto* cubes = node->get_if<ConfigList>();
    if (!cubes || cubes->empty() || cubes->size() > most_cubes) throw invalid_node("cubes", *node, allowed);
    for (const ConfigNode& cube : *cubes) {
        const auto place = numbers_of_list("cubes", *node, cube, allowed);
        const auto is_wrong = [](double c) { return c != std::floor(c) || std::abs(c) > farthest; };
        if (place.size() != 3 || std::ranges::any_of(place, is_wrong)) throw invalid_node("cubes", *node, allowed);
        settings.cubes.push_back({static_cast<int>(place[0]), static_cast<int>(place[1]), static_cast<int>(place[2])});
    }
    std::ranges::sort(settings.cubes);
    if (std::ranges::adjacent_find(settings.cubes) != settings.cubes.end()) throw invalid_node("cubes", *node, allowed);
    return {settings, "Corner tiles on a polycube"};
}

IsohedralTile tile_of(const IsohedralSettings& settings, std::uint64_t seed)
{
    const IsohedralType& type = isohedral_types()[static_cast<std::size_t>(settings.type - 1)];
    if (settings.is_random) return random_tile(type, seed, drawn_deformation, drawn_amplitude);
    return {type, settings.parameters};
}

}
