#include "reports/drawings/tilings/isohedral_image.hpp"

#include "reports/drawings/square_regions.hpp"

#include <array>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double tile_outline = 1;
constexpr double panel_tiles = 5; // sides of a square as large as the tile
constexpr double panel_frame = 2; // covers the cuts
constexpr double panel_gap = 12;
constexpr double caption_size = 14;

std::string isohedral_color(std::uint32_t color)
{
    // Light ones, so that outlines show; neighbours differ in lightness as well.
    constexpr std::array colors{"#f2e2b3", "#7fa8c9", "#d98c6a", "#9bbf85", "#b79bc9", "#e8c35a"};
    return colors[color % colors.size()];
}

/// The tiling moved so that `origin` is at `place` of the drawing, y downwards.
struct Placement
{
    PlanePoint origin;
    DrawingPoint place;
    double scale;

    DrawingPoint at(const PlanePoint& p) const
    {
        return {place[0] + (p[0] - origin[0]) * scale, place[1] - (p[1] - origin[1]) * scale};
    }
};

double scale_of(const IsohedralTile& tile) { return isohedral_tile_size / std::sqrt(area_of(tile.outline())); }

Polygon placed_outline(const IsohedralTile& tile, const TilePlace& place, const Placement& placement)
{
    const PlaneMotion motion = tile.motion(place);
    Polygon polygon;
    for (const PlanePoint& p : tile.outline()) polygon.push_back(placement.at(motion(p)));
    return polygon;
}

/// First what is filled, then the lines.
void add_tiles(std::vector<Shape>& shapes, const std::vector<Polygon>& tiles, const std::vector<std::string>& fills)
{
    std::vector<Shape> filled;
    for (std::size_t i = 0; i < tiles.size(); ++i) filled.push_back({tiles[i], fills[i], {}});
    group_by_fill(filled);
    shapes.insert(shapes.end(), filled.begin(), filled.end());
    for (const Polygon& tile : tiles) shapes.push_back({tile, {}, "#000000", tile_outline});
}

/// The part of a polygon on one side of a line along an axis, x or y: `sign` 1 keeps what is larger than `bound`. Where
/// the part is in pieces, they hang together along the line.
Polygon clipped_at(const Polygon& polygon, std::size_t axis, double bound, double sign)
{
    Polygon part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const DrawingPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double from = sign * (a[axis] - bound), to = sign * (b[axis] - bound);
        if (from >= 0) part.push_back(a);
        if ((from >= 0) == (to >= 0)) continue;
        const double share = from / (from - to);
        DrawingPoint cut{std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share)};
        cut[axis] = bound;
        part.push_back(cut);
    }
    return part;
}

Polygon clipped(Polygon polygon, const DrawingPoint& corner, double side)
{
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        polygon = clipped_at(polygon, axis, corner[axis], 1);
        polygon = clipped_at(polygon, axis, corner[axis] + side, -1);
    }
    return polygon;
}

/// A square window of the tiling in a frame, and its caption below.
void add_panel(Drawing& drawing, const IsohedralPanel& panel, const DrawingPoint& corner)
{
    const double side = panel_tiles * isohedral_tile_size;
    const Placement placement{{0, 0}, {corner[0] + side / 2, corner[1] + side / 2}, scale_of(panel.tile)};
    const double reach = side / 2 / placement.scale;
    std::vector<Polygon> tiles;
    std::vector<std::string> fills;
    for (const TilePlace& place : panel.tile.tiles_near({-reach, -reach}, {reach, reach})) {
        Polygon part = clipped(placed_outline(panel.tile, place, placement), corner, side);
        if (part.empty()) continue;
        tiles.push_back(std::move(part));
        fills.push_back(isohedral_color(panel.coloring.of(place)));
    }
    add_tiles(drawing.shapes, tiles, fills);
    const Polygon frame{
        corner, {corner[0] + side, corner[1]}, {corner[0] + side, corner[1] + side}, {corner[0], corner[1] + side}};
    drawing.shapes.push_back({frame, {}, "#000000", panel_frame});
    drawing.shapes.push_back(
        {Text{{corner[0] + side / 2, corner[1] + side + caption_size}, caption_size, panel.caption, true},
         "#000000",
         {}});
}

}

Drawing draw_isohedral_tiling(const IsohedralTile& tile, const TileColoring& coloring, double columns, double rows)
{
    Drawing drawing{columns * isohedral_tile_size, rows * isohedral_tile_size, {}};
    const Placement placement{{0, 0}, {drawing.width / 2, drawing.height / 2}, scale_of(tile)};
    const double x = drawing.width / 2 / placement.scale, y = drawing.height / 2 / placement.scale;
    std::vector<Polygon> tiles;
    std::vector<std::string> fills;
    for (const TilePlace& place : tile.tiles_near({-x, -y}, {x, y})) {
        tiles.push_back(placed_outline(tile, place, placement));
        fills.push_back(isohedral_color(coloring.of(place)));
    }
    add_tiles(drawing.shapes, tiles, fills);
    return drawing;
}

Drawing draw_isohedral_gallery(const std::vector<IsohedralPanel>& panels, std::size_t columns)
{
    const double side = panel_tiles * isohedral_tile_size;
    const double pitch_x = side + panel_gap, pitch_y = side + panel_gap + caption_size + 4;
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    Drawing drawing{
        static_cast<double>(columns) * pitch_x + panel_gap, static_cast<double>(rows) * pitch_y + panel_gap, {}};
    for (std::size_t i = 0; i < panels.size(); ++i)
        add_panel(drawing, panels[i],
                  {panel_gap + static_cast<double>(i % columns) * pitch_x,
                   panel_gap + static_cast<double>(i / columns) * pitch_y});
    return drawing;
}

}
