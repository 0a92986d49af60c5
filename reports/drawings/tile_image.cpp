#include "reports/drawings/tile_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr double tile_size = 32;
constexpr double tile_gap = 8;
constexpr double tile_disk_radius = 11 / tile_size;
constexpr std::size_t arc_steps = 8; // of a quarter of a disk: it is within 0.06 units of round

/// One channel of a saturated colour; `turns` around the colour circle.
int channel(double turns)
{
    const double distance = std::abs(turns - std::floor(turns) - 0.5) * 6; // 3 at the channel's own hue
    return static_cast<int>(std::lround(255 * std::min(1.0, std::max(0.0, distance - 1))));
}

/// The distance from one tile to the next.
double pitch(const TileGrid& grid) { return tile_size + (grid.has_gaps ? tile_gap : 0); }

/// Four triangles that meet in the middle.
void add_wang_tile(std::vector<Shape>& shapes, const WangTile& tile, const DrawnSquare& square)
{
    const auto colors = edge_colors(tile);
    for (std::size_t edge = 0; edge < 4; ++edge)
        shapes.push_back({Polygon{square.beside_edge(edge, 0, 0), square.beside_edge(edge, 1, 0), square.at(0.5, 0.5)},
                          tile_color(colors[edge]),
                          {}});
}

/// A quarter of a disk around each corner.
void add_corner_tile(std::vector<Shape>& shapes, const CornerTile& tile, const DrawnSquare& square)
{
    const auto colors = corner_colors(tile);
    for (std::size_t corner = 0; corner < 4; ++corner) {
        Polygon quarter{square.beside_edge(corner, 0, 0)};
        for (std::size_t step = 0; step <= arc_steps; ++step) {
            const double angle = std::numbers::pi / 2 * static_cast<double>(step) / arc_steps;
            quarter.push_back(
                square.beside_edge(corner, tile_disk_radius * std::cos(angle), tile_disk_radius * std::sin(angle)));
        }
        shapes.push_back({std::move(quarter), tile_color(colors[corner]), {}});
    }
}

/// Tiles at their places, with their borders.
template <class Tile>
Drawing drawn(const TileGrid& grid, std::span<const Tile> tiles,
              void (*add_tile)(std::vector<Shape>&, const Tile&, const DrawnSquare&))
{
    Drawing drawing = empty_tile_drawing(grid);
    for (std::size_t i = 0; i < tiles.size(); ++i) add_tile(drawing.shapes, tiles[i], tile_square(grid, i));
    group_by_fill(drawing.shapes);
    add_tile_borders(drawing.shapes, grid, 1);
    return drawing;
}

}

std::string tile_color(Color color)
{
    static const std::array<std::string, 8> known{"#ff0000", "#ffff00", "#00ff00", "#00ffff",
                                                  "#0000ff", "#ff00ff", "#ff8000", "#808080"};
    if (color < known.size()) return known[color];
    const double turns = color * 0.6180339887498949; // golden section: far from those before
    return fmt::format("#{:02x}{:02x}{:02x}", channel(turns), channel(turns - 1.0 / 3), channel(turns - 2.0 / 3));
}

Drawing empty_tile_drawing(const TileGrid& grid)
{
    if (grid.kind != TileKind::wang && grid.kind != TileKind::corner)
        throw std::logic_error("only Wang and corner tiles are drawn");
    const auto length = [&](std::size_t tiles) {
        return 2 * tile_gap + static_cast<double>(tiles) * pitch(grid) - (pitch(grid) - tile_size);
    };
    const std::size_t columns = std::max<std::size_t>(1, grid.columns);
    const std::size_t rows = std::max<std::size_t>(1, (grid.tiles.size() + columns - 1) / columns);
    return {length(columns), length(rows), {}};
}

DrawnSquare tile_square(const TileGrid& grid, std::size_t tile)
{
    const auto column = static_cast<double>(tile % grid.columns);
    const auto row = static_cast<double>(tile / grid.columns);
    return {
        {tile_gap + column * pitch(grid), tile_gap + row * pitch(grid) + tile_size}, {tile_size, 0}, {0, -tile_size}};
}

void add_tile_borders(std::vector<Shape>& shapes, const TileGrid& grid, double width)
{
    for (std::size_t i = 0; i < grid.tiles.size(); ++i)
        shapes.push_back({tile_square(grid, i).outline(), {}, "#000000", width});
}

Drawing draw_tiles(const TileGrid& grid, std::span<const WangTile> tiles) { return drawn(grid, tiles, add_wang_tile); }

Drawing draw_tiles(const TileGrid& grid, std::span<const CornerTile> tiles)
{
    return drawn(grid, tiles, add_corner_tile);
}

Drawing draw_tiles(const TileGrid& grid)
{
    std::vector<WangTile> wang;
    std::vector<CornerTile> corners;
    for (const TileIndex tile : grid.tiles) {
        if (grid.kind == TileKind::wang)
            wang.push_back(wang_tile(tile, grid.colors));
        else
            corners.push_back(corner_tile(tile, grid.colors.horizontal));
    }
    return grid.kind == TileKind::wang ? draw_tiles(grid, wang) : draw_tiles(grid, corners);
}

}
