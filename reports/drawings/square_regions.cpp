#include "reports/drawings/square_regions.hpp"

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

}
