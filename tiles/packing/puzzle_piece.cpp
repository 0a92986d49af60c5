#include "tiles/packing/puzzle_piece.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr int arc_steps = 24; // of a knob's outline: within 0.001 tiles of round

/// A knob on the line y = 0: a circle whose middle lies 0.6 radii beside the line, so that it is wider than its neck.
/// `side` is 1 for knobs to the left of the line, -1 to the right.
void add_knob(std::vector<PiecePoint>& line, double place, double radius, double side)
{
    const double first = -std::asin(0.6), turn = std::numbers::pi + 2 * std::asin(0.6);
    for (int step = 0; step <= arc_steps; ++step) {
        const double angle = std::numbers::pi - first - turn * step / arc_steps; // from the left end of the neck
        line.push_back({place + radius * std::cos(angle), side * radius * (0.6 + std::sin(angle))});
    }
}

/// Even colours are to the left, odd ones to the right; pairs of them share a place out of `places`.
double side_of(Color color) { return color % 2 == 0 ? 1 : -1; }

double place_of(Color color, Color colors, double lowest, double highest)
{
    const Color places = (colors + 1) / 2;
    return lowest + (highest - lowest) * (color / 2 + 0.5) / places;
}

PiecePoint moved(const PiecePoint& point, double x, double y) { return {point[0] + x, point[1] + y}; }

/// A side from west to east through (0, y), or from south to north through (x, 0).
std::vector<PiecePoint> horizontal(std::vector<PiecePoint> profile, double y)
{
    for (PiecePoint& point : profile) point = moved(point, 0, y);
    return profile;
}

std::vector<PiecePoint> vertical(std::vector<PiecePoint> profile, double x)
{
    for (PiecePoint& point : profile) point = moved({-point[1], point[0]}, x, 0);
    return profile;
}

std::vector<PiecePoint> reversed(std::vector<PiecePoint> line)
{
    std::ranges::reverse(line);
    return line;
}

}

std::vector<PiecePoint> side_profile(TileKind kind, Color start, Color end, Color colors)
{
    std::vector<PiecePoint> line{{0, 0}};
    if (kind == TileKind::wang) {
        add_knob(line, place_of(start, colors, 0.25, 0.75), 0.08, side_of(start));
    } else {
        // Seen from the corner at its end, the left of the line is its right.
        add_knob(line, place_of(start, colors, 0.14, 0.34), 0.06, side_of(start));
        add_knob(line, 1 - place_of(end, colors, 0.14, 0.34), 0.06, -side_of(end));
    }
    line.push_back({1, 0});
    return line;
}

std::array<std::vector<PiecePoint>, 4> piece_sides(TileKind kind, TileIndex tile, Color colors)
{
    if (kind == TileKind::wang) {
        const WangTile t = wang_tile(tile, {colors, colors});
        const auto profile = [&](Color color) { return side_profile(kind, color, color, colors); };
        return {horizontal(profile(t.south), 0), vertical(profile(t.east), 1),
                reversed(horizontal(profile(t.north), 1)), reversed(vertical(profile(t.west), 0))};
    }
    const CornerTile t = corner_tile(tile, colors);
    const auto profile = [&](Color start, Color end) { return side_profile(kind, start, end, colors); };
    return {horizontal(profile(t.south_west, t.south_east), 0), vertical(profile(t.south_east, t.north_east), 1),
            reversed(horizontal(profile(t.north_west, t.north_east), 1)),
            reversed(vertical(profile(t.south_west, t.north_west), 0))};
}

std::vector<PiecePoint> piece_outline(TileKind kind, TileIndex tile, Color colors)
{
    std::vector<PiecePoint> outline;
    for (const auto& side : piece_sides(kind, tile, colors))
        outline.insert(outline.end(), side.begin(), side.end() - 1);
    return outline;
}

}
