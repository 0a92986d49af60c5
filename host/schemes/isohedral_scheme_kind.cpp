// kind = "isohedral": the keys of a scheme that draws an isohedral tiling, its colours, and the path that divides
// tiles.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II, section 7).
#include "host/kinds/kinds.hpp"
#include "host/schemes/scheme_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

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
    curve_keys(keys, s.parameters.curves);
    for (const char* const key : {"parameters", "curves"})
        if (s.is_random && keys.is_given(key)) throw keys.invalid(key, "cannot be combined with random = true");
    const std::size_t given = s.parameters.deformations.size(), needed = type.shape.parameters();
    if (given > 0 && given != needed)
        throw keys.invalid("parameters", fmt::format("must be as many as IH{} has: {}", type.number, needed));
    if (s.parameters.curves.size() > type.shape.curve_shapes.size())
        throw keys.invalid("curves",
                           fmt::format("must be at most {} for IH{}", type.shape.curve_shapes.size(), type.number));
}

/// The shape that tiles are to look like.
void goal_keys(Keys& keys, IsohedralSettings& s)
{
    constexpr auto help = "a shape, such as a file of SVG: the tile that looks most like it is searched";
    Keys::Said said = keys.region("goal", s.goal, help).otherwise("none");
    for (const char* const other : {"random", "parameters", "curves", "coloring", "split"}) said.excludes(other);
    if (keys.is_read() && !s.goal.empty()) keys.check("goal", [&] { goal_of(s.goal); });
}

void isohedral_keys(Keys& keys, IsohedralSettings& s)
{
    keys.integer("type", s.type, 1, 93, "of Gruenbaum and Shephard").otherwise("16; with goal, all");
    const IsohedralType& type = type_of(s);
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
    split_keys(keys, s.split, {"coloring", "random"});
    goal_keys(keys, s);
    if (keys.is_read()) keys.check([&] { tile_of(s, 1); });
    if (keys.is_read() && s.split) keys.check("split", [&] { split_tile(tile_of(s, 1), *s.split); });
}

}

Kind isohedral_kind()
{
    return make_kind<IsohedralSettings>(
        {"scheme", "isohedral", "", "Isohedral tiling", "Draw a tiling of a type with parameters, curves and colours",
         false},
        isohedral_keys,
        [](const IsohedralSettings& s) {
            return s.goal.empty() ? fmt::format("Isohedral tiling of type IH{}", type_of(s).number)
                                  : fmt::format("Isohedral tiling like {}", name_of_input(s.goal));
        },
        make_isohedral);
}

const IsohedralType& type_of(const IsohedralSettings& settings)
{
    constexpr int usual = 16;
    return isohedral_types()[static_cast<std::size_t>(settings.type.value_or(usual) - 1)];
}

IsohedralTile tile_of(const IsohedralSettings& settings, std::uint64_t seed)
{
    const IsohedralType& type = type_of(settings);
    if (settings.is_random) return random_tile(type, seed, drawn_deformation, drawn_amplitude);
    return {type, settings.parameters};
}

}
