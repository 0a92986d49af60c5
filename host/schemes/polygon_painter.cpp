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
    const auto away = tiling_.ring.value(place - view_.middle);
    return {view_.shift[0] + away[0] / view_.unit, view_.shift[1] + away[1] / view_.unit};
}

void PolygonPainter::add_edge(std::vector<MarkPoint>& outline, const MarkPoint& from, const MarkPoint& to,
                              char letter) const
{
    static const PlaneCurve straight{{0, 0}, {1, 0}};
    const char small = small_letter(letter);
    const auto given = style_.curves.find(small);
    const PlaneCurve& curve = given != style_.curves.end() ? given->second
                              : style_.edges == "puzzle"   ? puzzle_curve(small)
                                                           : straight;
    // A capital letter's edge is walked along the other way.
    const bool is_backwards = letter != small;
    const MarkPoint &a = is_backwards ? to : from, &b = is_backwards ? from : to;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const PlanePoint& p = curve[is_backwards ? curve.size() - 1 - i : i];
        outline.push_back(
            {a[0] + p[0] * (b[0] - a[0]) - p[1] * (b[1] - a[1]), a[1] + p[0] * (b[1] - a[1]) + p[1] * (b[0] - a[0])});
    }
}

std::vector<MarkPoint> PolygonPainter::outline(const PlacedTile& tile) const
{
    const std::vector<RingPlace> corners = corners_of(tiling_, tile);
    std::vector<MarkPoint> outline;
    for (std::size_t i = 0; i < corners.size(); ++i)
        add_edge(outline, at(corners[i]), at(corners[(i + 1) % corners.size()]), edge_letter(tiling_, tile, i));
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
    constexpr double letter_size = 0.2, inside = 0.16;
    const std::vector<RingPlace> corners = corners_of(tiling_, tile);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const char letter = edge_letter(tiling_, tile, i);
        if (letter == 0) return;
        const MarkPoint a = at(corners[i]), b = at(corners[(i + 1) % corners.size()]);
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const MarkPoint inwards{-(b[1] - a[1]) / length, (b[0] - a[0]) / length};
        canvas_.words({(a[0] + b[0]) / 2 + inside * inwards[0], (a[1] + b[1]) / 2 + inside * inwards[1]}, letter_size,
                      std::string(1, letter));
    }
}

double picture_unit(const PolygonTiling& tiling, double scale) { return scale * std::sqrt(area_of(tiling, 0)); }

std::array<MarkPoint, 2> box_around(const PolygonPainter& painter, std::span<const PlacedTile> tiles)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    std::array<MarkPoint, 2> box{MarkPoint{none, none}, MarkPoint{-none, -none}};
    for (const PlacedTile& tile : tiles)
        for (const MarkPoint& p : painter.outline(tile))
            for (std::size_t axis = 0; axis < 2; ++axis) {
                box[0][axis] = std::min(box[0][axis], p[axis]);
                box[1][axis] = std::max(box[1][axis], p[axis]);
            }
    return box;
}

double pixels_a_unit(double width)
{
    constexpr double most_pixels = 1600, largest_unit = 64;
    return std::min(largest_unit, most_pixels / width);
}

}
