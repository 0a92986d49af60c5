#include "reports/drawings/square_regions.hpp"

#include "tiles/tilings/tile_shapes.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

const std::string outline_color = "#606060";
constexpr double outline_width = 0.4;
constexpr double paleness = 0.6;

/// The strip along an edge from `start` to `end`.
std::vector<DrawingPoint> strip(const DrawnSquare& square, std::size_t edge, double start, double end, double width)
{
    return {square.beside_edge(edge, start, 0), square.beside_edge(edge, end, 0), square.beside_edge(edge, end, width),
            square.beside_edge(edge, start, width)};
}

}

DrawingPoint DrawnSquare::beside_edge(std::size_t edge, double along, double inwards) const
{
    switch (edge) {
    case 0:
        return at(along, inwards);
    case 1:
        return at(1 - inwards, along);
    case 2:
        return at(1 - along, 1 - inwards);
    default:
        return at(inwards, 1 - along);
    }
}

Shape corner_region(const DrawnSquare& square, RegionSizes sizes, std::size_t corner, const std::string& color)
{
    const auto place = [&](double along, double inwards) { return square.beside_edge(corner, along, inwards); };
    return {Polygon{place(0, 0), place(sizes.reach, 0), place(sizes.reach, sizes.width),
                    place(sizes.width, sizes.reach), place(0, sizes.reach)},
            color,
            {}};
}

Shape edge_region(const DrawnSquare& square, RegionSizes sizes, std::size_t edge, const std::string& color)
{
    return {strip(square, edge, sizes.reach, 1 - sizes.reach, sizes.width), color, {}};
}

Shape half_edge_region(const DrawnSquare& square, RegionSizes sizes, std::size_t edge, bool second,
                       const std::string& color)
{
    const double middle = 0.5;
    return {
        strip(square, edge, second ? middle : sizes.reach, second ? 1 - sizes.reach : middle, sizes.width), color, {}};
}

std::string edge_tint(const std::string& color) { return mixed_color(color, "#ffffff", paleness); }

void add_region_outlines(std::vector<Shape>& shapes, const DrawnSquare& square, RegionSizes sizes)
{
    Polygon interior;
    for (std::size_t edge = 0; edge < 4; ++edge) {
        interior.push_back(square.beside_edge(edge, sizes.reach, sizes.width));
        interior.push_back(square.beside_edge(edge, 1 - sizes.reach, sizes.width));
    }
    shapes.push_back({std::move(interior), {}, outline_color, outline_width});
    for (std::size_t edge = 0; edge < 4; ++edge)
        for (const double end : {sizes.reach, 1 - sizes.reach})
            shapes.push_back({Line{{square.beside_edge(edge, end, 0), square.beside_edge(edge, end, sizes.width)}},
                              {},
                              outline_color,
                              outline_width});
}

void group_by_fill(std::vector<Shape>& shapes) { std::ranges::stable_sort(shapes, {}, &Shape::fill); }

namespace {

const std::string no_color = "#dcdcdc";
const std::string white = "#ffffff";

/// Shares of white.
constexpr double own_color = 0.55;
constexpr double shared_color = 0.72;
constexpr double interior_color = 0.82;

std::string pale(const ScenePiece& piece, std::uint32_t color, int dimension)
{
    const double share = piece.axes == all_axes(dimension) ? interior_color
                         : piece.colors.size() > 1         ? shared_color
                                                           : own_color;
    return mixed_color(tile_color(color), white, share);
}

/// The wedges of a corner, each on the side and in the colour of an edge that leaves it north, east, south or west.
std::vector<ColoredPart> wedges(const ScenePiece& piece)
{
    constexpr std::array<std::array<double, 2>, 4> ways{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};
    const double x = double(piece.base[0]) * tile_units, y = double(piece.base[1]) * tile_units;
    std::vector<ColoredPart> parts;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        ColoredPart part{{}, pale(piece, piece.colors[i], 2)};
        for (const double side : {-1.0, 1.0}) {
            const ShapeVector normal{side * ways[i][1] - ways[i][0], -side * ways[i][0] - ways[i][1], 0};
            part.bounds.push_back({normal, normal[0] * x + normal[1] * y});
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

}

std::vector<ColoredPart> colored_parts(const ScenePiece& piece, int dimension)
{
    if (piece.colors.empty()) return {{{}, piece.axes == all_axes(dimension) ? white : no_color}};
    if (piece.colors.size() == 1) return {{{}, pale(piece, piece.colors.front(), dimension)}};
    if (piece.axes == 0) return wedges(piece);
    std::vector<ColoredPart> parts;
    for (std::size_t corner = 0; corner < piece.colors.size(); ++corner) {
        ColoredPart part{{}, pale(piece, piece.colors[corner], dimension)};
        std::size_t bit = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!(piece.axes >> k & 1)) continue;
            const double middle = (piece.base[k] + 0.5) * tile_units;
            const double side = corner >> bit++ & 1 ? -1 : 1; // the upper half: -x <= -middle
            ShapeHalfSpace half{{}, side * middle};
            half.normal[k] = side;
            part.bounds.push_back(half);
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

std::string wire_color(const ScenePiece& piece)
{
    const bool one = !piece.colors.empty() &&
                     std::ranges::all_of(piece.colors, [&](std::uint32_t c) { return c == piece.colors.front(); });
    return one ? mixed_color(tile_color(piece.colors.front()), "#000000", 0.3) : "#808080";
}

const PointColor& point_color(std::size_t point_class)
{
    static const std::array<PointColor, stored_point_classes.size()> colors{
        {{"#9a9a9a", "grey"}, {"#3c78c8", "blue"}, {"#202020", "black"}, {"#d02818", "red"}}};
    return colors.at(point_class);
}

TileRegions regions_of(const Scene& scene, const ScenePanel& panel)
{
    return panel.modified ? modified_regions(scene.dimension, scene.width)
                          : unmodified_regions(scene.dimension, scene.width);
}

RegionShape shown_region(const Scene& scene, const ScenePanel& panel, const ScenePiece& piece)
{
    return clipped_to_box(region_shape(regions_of(scene, panel), piece.axes, piece.base), scene.dimension,
                          panel.part.low_corner(), panel.part.high_corner());
}

}
