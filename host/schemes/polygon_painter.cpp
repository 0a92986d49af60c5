#include "host/schemes/polygon_painter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double outline_width = 0.04;
constexpr double arc_width = 0.09;

/// Curves that fit only one way round: a tab off the middle of the edge, to one side or the other.
const PlaneCurve& puzzle_curve(char letter)
{
    static const PlaneCurve first{{0, 0}, {0.3, 0}, {0.27, 0.12}, {0.43, 0.12}, {0.4, 0}, {1, 0}};
    static const PlaneCurve second{{0, 0}, {0.6, 0}, {0.7, -0.16}, {0.8, 0}, {1, 0}};
    static const PlaneCurve straight{{0, 0}, {1, 0}};
    if (letter == 'a') return first;
    return letter == 'b' ? second : straight;
}

/// Returns a curve like an S, which fits itself.
const PlaneCurve& bent_curve()
{
    static const PlaneCurve curve = [] {
        constexpr int steps = 12;
        constexpr double height = 0.14;
        PlaneCurve points;
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            points.push_back({t, height * 12 * std::numbers::sqrt3 * t * (t - 0.5) * (t - 1)}); // a cubic
        }
        return points;
    }();
    return curve;
}

char small_letter(char letter) { return static_cast<char>(std::tolower(static_cast<unsigned char>(letter))); }

std::string direction_color(double turn, bool is_mirrored)
{
    // Twelve hues; mirrored tiles are darker.
    const double light = is_mirrored ? 0.62 : 0.86, strong = is_mirrored ? 0.3 : 0.13;
    const auto channel = [&](double away) {
        const double value = light + strong * std::cos(2 * std::numbers::pi * (turn - away));
        return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(1.0 / 3), channel(2.0 / 3));
}

}

MarkPoint PolygonPainter::at(const RingPlace& place) const
{
    const auto away = point_of(tiling_, place - view_.middle);
    return {view_.shift[0] + away[0] / view_.unit, view_.shift[1] + away[1] / view_.unit};
}

const PlaneCurve& PolygonPainter::curve_of(char small_letter) const
{
    static const PlaneCurve straight{{0, 0}, {1, 0}};
    const auto given = style_.curves.find(small_letter);
    if (given != style_.curves.end()) return given->second;
    if (style_.edges == "puzzle") return puzzle_curve(small_letter);
    return style_.edges == "curved" ? bent_curve() : straight;
}

/// The place to which shifts move a vertex of an outline.
MarkPoint PolygonPainter::shifted(const PlacedTile& tile, const ShiftedPlace& vertex) const
{
    MarkPoint place = at(moved(tiling_.ring, tile.motion, vertex.place));
    for (std::size_t i = 0; i < 2; ++i) {
        const auto turn = tiling_.ring.value(tiling_.ring.times(tile.motion.turn, vertex.shifts[i]));
        const double length = (*style_.shifts)[2 * i] / view_.unit;
        const double angle = (*style_.shifts)[2 * i + 1] * std::numbers::pi / 180;
        const MarkPoint shift{length * std::cos(angle), length * std::sin(angle)};
        place[0] += turn[0] * shift[0] - turn[1] * shift[1];
        place[1] += turn[0] * shift[1] + turn[1] * shift[0];
    }
    return place;
}

std::vector<PolygonPainter::Vertex> PolygonPainter::vertices_of(const PlacedTile& tile) const
{
    const Prototile& prototile = tiling_.prototiles[tile.prototile];
    std::vector<Vertex> vertices;
    if (style_.shifts) {
        for (std::size_t i = 0; i < prototile.outline.size(); ++i)
            vertices.push_back({shifted(tile, prototile.outline[i]), prototile.outline_edges[i]});
        return vertices;
    }
    const std::vector<RingPlace> corners = corners_of(tiling_, tile);
    for (std::size_t i = 0; i < corners.size(); ++i)
        vertices.push_back({at(corners[i]), edge_letter(tiling_, tile, i)});
    return vertices;
}

std::vector<MarkPoint> PolygonPainter::outline(const PlacedTile& tile) const
{
    const std::vector<Vertex> vertices = vertices_of(tile);
    std::vector<MarkPoint> outline;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const char letter = vertices[i].letter, small = small_letter(letter);
        const bool is_backwards = letter != small; // an edge with a capital letter has the opposite direction
        const MarkPoint &from = vertices[i].place, &to = vertices[(i + 1) % vertices.size()].place;
        const MarkPoint &a = is_backwards ? to : from, &b = is_backwards ? from : to;
        const double side = tile.motion.is_mirrored ? -1 : 1;
        const PlaneCurve& curve = curve_of(small);
        for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
            const PlanePoint& p = curve[is_backwards ? curve.size() - 1 - k : k];
            outline.push_back({a[0] + p[0] * (b[0] - a[0]) - side * p[1] * (b[1] - a[1]),
                               a[1] + p[0] * (b[1] - a[1]) + side * p[1] * (b[0] - a[0])});
        }
    }
    return outline;
}

std::string PolygonPainter::color_of(const PlacedTile& tile) const
{
    if (style_.colors == "tiles") return tiling_.prototiles[tile.prototile].color;
    const auto turn = tiling_.ring.value(tile.motion.turn);
    return direction_color(std::atan2(turn[1], turn[0]) / (2 * std::numbers::pi), tile.motion.is_mirrored);
}

void PolygonPainter::paint(std::span<const PlacedTile> tiles)
{
    std::vector<std::vector<MarkPoint>> outlines;
    for (const PlacedTile& tile : tiles) {
        outlines.push_back(outline(tile));
        canvas_.polygon(color_of(tile), outlines.back());
    }
    if (style_.has_arcs)
        for (const PlacedTile& tile : tiles) paint_arcs(tile);
    for (const auto& outline : outlines) canvas_.outline("#000000", outline, outline_width);
    if (style_.has_letters)
        for (const PlacedTile& tile : tiles) paint_letters(tile);
}

void PolygonPainter::paint_arcs(const PlacedTile& tile)
{
    constexpr double step = std::numbers::pi / 24;
    const Prototile& prototile = tiling_.prototiles[tile.prototile];
    const double radius_unit = scale_of(tiling_.ring, tile.motion) / view_.unit;
    const std::size_t count = prototile.corners.size();
    for (const TileArc& arc : prototile.arcs) {
        const auto corner_at = [&](std::size_t i) {
            return at(moved(tiling_.ring, tile.motion, prototile.corners[i]));
        };
        const MarkPoint middle = corner_at(arc.corner);
        const auto direction = [&](const MarkPoint& p) { return std::atan2(p[1] - middle[1], p[0] - middle[0]); };
        double from = direction(corner_at((arc.corner + 1) % count));
        double to = direction(corner_at((arc.corner + count - 1) % count));
        if (tile.motion.is_mirrored) std::swap(from, to);
        if (to <= from) to += 2 * std::numbers::pi;
        const auto steps = static_cast<int>(std::ceil((to - from) / step));
        const auto place = [&](int i) {
            const double angle = from + (to - from) * i / steps;
            return MarkPoint{middle[0] + arc.radius * radius_unit * std::cos(angle),
                             middle[1] + arc.radius * radius_unit * std::sin(angle)};
        };
        for (int i = 0; i < steps; ++i) canvas_.line(arc.color, place(i), place(i + 1), arc_width);
    }
}

void PolygonPainter::paint_letters(const PlacedTile& tile)
{
    constexpr double largest = 0.22, part_of_edge = 0.28;
    const std::vector<Vertex> vertices = vertices_of(tile);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const MarkPoint &a = vertices[i].place, &b = vertices[(i + 1) % vertices.size()].place;
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        if (vertices[i].letter == 0 || !(length > 0)) continue;
        const MarkPoint inwards{-(b[1] - a[1]) / length, (b[0] - a[0]) / length};
        const double size = std::min(largest, part_of_edge * length);
        canvas_.words({(a[0] + b[0]) / 2 + 0.8 * size * inwards[0], (a[1] + b[1]) / 2 + 0.8 * size * inwards[1]}, size,
                      std::string(1, vertices[i].letter));
    }
}

double picture_unit(const PolygonTiling& tiling, double scale) { return scale * std::sqrt(area_of(tiling, 0)); }

std::array<MarkPoint, 2> box_around(const PolygonPainter& painter, std::span<const PlacedTile> tiles)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    std::array<MarkPoint, 2> box{MarkPoint{none, none}, MarkPoint{-none, -none}};
    for (const PlacedTile& tile : tiles)
        for (const MarkPoint& p : painter.outline(tile)) box = box_with(box, p);
    return box;
}

std::array<MarkPoint, 2> box_with(std::array<MarkPoint, 2> box, const MarkPoint& point)
{
    for (std::size_t axis = 0; axis < 2; ++axis) {
        box[0][axis] = std::min(box[0][axis], point[axis]);
        box[1][axis] = std::max(box[1][axis], point[axis]);
    }
    return box;
}

double pixels_a_unit(double width)
{
    constexpr double most_pixels = 1600, largest_unit = 64;
    return std::min(largest_unit, most_pixels / width);
}

}
