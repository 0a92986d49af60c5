// kind = "isohedral" with a goal: the tiling whose tile looks most like a shape.
//
// Kaplan and Salesin, Escherization, 2000.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/regions/region_text.hpp"
#include "host/schemes/isohedral_picture.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/isohedral/tile_search.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double degrees_a_radian = 180 / std::numbers::pi;

/// The goal's polygons where it lies on the tile.
std::vector<PlanePoint> laid_on(const GoalTile& found, std::vector<PlanePoint> polygon)
{
    const auto& [c, s] = found.scale;
    for (PlanePoint& p : polygon) p = {c * p[0] - s * p[1] + found.shift[0], s * p[0] + c * p[1] + found.shift[1]};
    return polygon;
}

std::vector<int> searched_types(const IsohedralSettings& settings)
{
    if (settings.type) return {*settings.type};
    std::vector<int> types;
    for (const IsohedralType& type : isohedral_types())
        if (!type.is_marked) types.push_back(type.number);
    return types;
}

/// The best tile of each type, the best ten of them.
DistributionTable type_table(const std::vector<GoalTile>& tiles)
{
    DistributionTable table{
        "Tiles by type", {"type", "symbol", "difference of directions in degrees", "difference of steps"}, {}};
    for (const GoalTile& tile : tiles) {
        if (table.rows.size() == 10) break;
        table.rows.push_back({fmt::format("IH{}{}", tile.type, tile.is_mirrored ? " in a mirror" : ""),
                              type_of(tile).symbol, fmt::format("{:.1f}", tile.turning * degrees_a_radian),
                              fmt::format("{:.3f}", tile.distance)});
    }
    return table;
}

/// The tile, and the goal over it.
MarkPicture goal_picture(const IsohedralTile& tile, const TilingWindow& turned, const std::vector<PlanePoint>& goal)
{
    constexpr double margin = 0.15, pixels_a_tile = 320;
    std::vector<std::vector<MarkPoint>> outlines;
    MarkPoint low{1e300, 1e300}, high{-1e300, -1e300};
    for (const auto* outline : {&tile.outline(), &goal}) {
        auto& placed = outlines.emplace_back();
        for (const PlanePoint& p : *outline) {
            placed.push_back(in_window(turned, tile, p));
            for (const std::size_t k : {0, 1}) {
                low[k] = std::min(low[k], placed.back()[k] - margin);
                high[k] = std::max(high[k], placed.back()[k] + margin);
            }
        }
    }
    for (auto& outline : outlines)
        for (MarkPoint& p : outline)
            for (const std::size_t k : {0, 1}) p[k] -= low[k];
    MarkCanvas canvas(high[0] - low[0], high[1] - low[1], pixels_a_tile);
    canvas.polygon("#dfe7ee", outlines[0]);
    canvas.outline("#000000", outlines[0], 0.012);
    canvas.outline("#c0392b", outlines[1], 0.012);
    return canvas.picture();
}

std::string outline_csv(const IsohedralTile& tile)
{
    std::string text = "x,y\n";
    for (const auto& [x, y] : tile.outline()) text += fmt::format("{:.9g},{:.9g}\n", x, y);
    return text;
}

}

GoalShape goal_of(const std::string& text)
{
    const PlaneRegion region = read_region(text);
    if (region.polygons.size() != 1)
        throw InputError(fmt::format("has {} shapes: a goal is one", region.polygons.size()));
    const RegionPolygon& polygon = region.polygons[0];
    GoalShape goal{GoalOutline(polygon.outline), polygon.holes};
    for (auto& hole : goal.holes)
        for (PlanePoint& p : hole)
            for (double& x : p) x /= goal.outline.perimeter();
    return goal;
}

DistributionResult make_goal_tiling(const IsohedralSettings& settings, DistributionFiles& files)
{
    const GoalShape goal = goal_of(settings.goal);
    const GoalSearch search = tiles_like(goal.outline, searched_types(settings));
    if (search.tiles.empty()) throw InputError("goal: all tiles near this shape have outlines that cross themselves");
    const GoalTile& found = search.tiles[0];
    const IsohedralType& type = type_of(found);
    const IsohedralTile tile(type, found.parameters);
    const TileColoring coloring = proper_coloring(tile);
    DistributionResult result;
    describe(type, tile, result);
    result.facts.push_back(fmt::format("parameters = [{:.6g}]{}", fmt::join(found.parameters.deformations, ", "),
                                       found.is_mirrored ? ", of the type's mirror image" : ""));
    result.facts.emplace_back(is_perfect(tile, coloring) ? "a perfect colouring: symmetries permute colours"
                                                         : "not a perfect colouring");
    const DistributionNumbers numbers{
        {"turning_distance", "Difference of directions along outlines", found.turning * degrees_a_radian,
         "degrees, root mean square: the tile's from the goal's, turned and begun at its best"},
        {"step_distance", "Difference of steps along outlines", found.distance,
         "of the goal's steps; 0: the goal is a tile"},
        {"candidates", "Tiles that were compared", static_cast<double>(search.candidates), ""},
        {"colors", "Colours", static_cast<double>(coloring.colors), ""}};
    result.numbers.insert(result.numbers.begin(), numbers.begin(), numbers.end());
    if (search.tiles.size() > 1) result.tables.push_back(type_table(search.tiles));

    TilingWindow window = window_of(settings);
    const double scale = std::hypot(found.scale[0], found.scale[1]);
    window.right = {found.scale[0] / scale, found.scale[1] / scale}; // as the goal is drawn
    files.add_marks("tiling.json",
                    tiling_picture(tile, window,
                                   [&](const TilePlace& place) {
                                       TileParts parts{{tile.outline(), tile_color(coloring.of(place))}};
                                       for (const auto& hole : goal.holes)
                                           parts.emplace_back(laid_on(found, hole), "#202020");
                                       return parts;
                                   }),
                    window.caption(), result);
    files.add_marks("goal.json", goal_picture(tile, window, laid_on(found, goal.outline.corners())),
                    "The tile, and the goal in red.", result);
    write_whole_file(files.add("tile.csv", result), outline_csv(tile));
    return result;
}

}
