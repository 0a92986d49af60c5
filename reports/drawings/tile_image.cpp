#include "reports/drawings/tile_image.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace poissonlab {
namespace {

constexpr double tile_size = 32;
constexpr double tile_gap = 8;

/// Tiles of larger pictures are too small for letters.
constexpr std::size_t most_lettered = 256;
constexpr double number_size = 6, number_height = 0.36; ///< the height of a figure's middle over its foot, in sizes

/// The distance from one tile to the next.
double pitch(const TileGrid& grid) { return tile_size + (grid.has_gaps ? tile_gap : 0); }

void add_tile(std::vector<Shape>& shapes, const auto& tile, const DrawnSquare& square)
{
    for (const TileShape& shape : shapes_of(tile)) {
        Polygon polygon;
        for (const auto& [x, y] : shape.corners) polygon.push_back(square.at(x, y));
        shapes.push_back({std::move(polygon), tile_color(shape.color), {}});
    }
}

/// The number of a colour around a place, black, or white on dark colours.
Shape color_number(Color color, const DrawingPoint& at)
{
    const auto [red, green, blue] = color_channels(tile_color(color));
    const bool is_dark = 299 * red + 587 * green + 114 * blue < 110'000;
    return {Text{{at[0], at[1] + number_height * number_size}, number_size, std::to_string(color), true},
            is_dark ? "#ffffff" : "#000000",
            {}};
}

/// Returns the place of a shape's number, between the shape's first corners and the middle of the tile.
TilePoint number_place(const WangTile&, std::size_t side)
{
    constexpr double inwards = 0.17;
    const std::array<TilePoint, 4> places{{{0.5, inwards}, {1 - inwards, 0.5}, {0.5, 1 - inwards}, {inwards, 0.5}}};
    return places[side];
}

TilePoint number_place(const CornerTile&, std::size_t corner)
{
    constexpr double inwards = 5 / tile_size;
    const std::array<TilePoint, 4> places{
        {{inwards, inwards}, {1 - inwards, inwards}, {1 - inwards, 1 - inwards}, {inwards, 1 - inwards}}};
    return places[corner];
}

TilePoint number_place(const Domino&, std::size_t half) { return {0.25 + 0.5 * static_cast<double>(half), 0.5}; }

/// Tiles of a tiling share their corners, and each corner gets one number. The tile to its north-east draws the number;
/// other tiles do so beyond the last column and above the first row.
bool has_number(const TileGrid& grid, std::size_t tile, std::size_t corner)
{
    const bool is_last_column = tile % grid.columns + 1 == grid.columns, is_first_row = tile < grid.columns;
    return corner == 0 || (corner == 1 && is_last_column) || (corner == 2 && is_last_column && is_first_row) ||
           (corner == 3 && is_first_row);
}

/// Numbers of colours in their shapes, as figures of the dissertation have them in disks.
template <class Tile>
void add_color_numbers(std::vector<Shape>& shapes, const TileGrid& grid, std::span<const Tile> tiles)
{
    if (tiles.size() > most_lettered) return;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const std::vector<TileShape> of = shapes_of(tiles[i]);
        for (std::size_t k = 0; k < of.size(); ++k) {
            const bool is_shared = std::is_same_v<Tile, CornerTile> && !grid.has_gaps;
            if (is_shared && !has_number(grid, i, k)) continue;
            const auto [x, y] = is_shared ? of[k].corners.front() : number_place(tiles[i], k);
            const DrawingPoint at = tile_square(grid, i).at(x, y);
            if (is_shared) shapes.push_back({Disk{at, 0.8 * number_size}, tile_color(of[k].color), {}}); // over borders
            shapes.push_back(color_number(of[k].color, at));
        }
    }
}

/// Tiles at their places, with their borders.
template <class Tile>
Drawing drawn(const TileGrid& grid, std::span<const Tile> tiles)
{
    Drawing drawing = empty_tile_drawing(grid);
    for (std::size_t i = 0; i < tiles.size(); ++i) add_tile(drawing.shapes, tiles[i], tile_square(grid, i));
    group_by_fill(drawing.shapes);
    add_tile_borders(drawing.shapes, grid, 1);
    add_color_numbers(drawing.shapes, grid, tiles);
    return drawing;
}

}

Drawing empty_tile_drawing(const TileGrid& grid)
{
    if (axes_of(grid.kind) == 3) throw std::logic_error("cubes are no flat tiles");
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

Drawing draw_tiles(const TileGrid& grid, std::span<const WangTile> tiles) { return drawn(grid, tiles); }

Drawing draw_tiles(const TileGrid& grid, std::span<const CornerTile> tiles) { return drawn(grid, tiles); }

Drawing draw_tiles(const TileGrid& grid)
{
    const auto drawn_as = [&](const auto& tile_of) {
        std::vector<std::decay_t<decltype(tile_of(0))>> tiles;
        for (const TileIndex tile : grid.tiles) tiles.push_back(tile_of(tile));
        return drawn<typename decltype(tiles)::value_type>(grid, tiles);
    };
    const Color colors = grid.colors.horizontal;
    if (grid.kind == TileKind::wang) return drawn_as([&](TileIndex tile) { return wang_tile(tile, grid.colors); });
    if (grid.kind == TileKind::domino) return drawn_as([&](TileIndex tile) { return domino(tile, colors); });
    return drawn_as([&](TileIndex tile) { return corner_tile(tile, colors); });
}

namespace {

const std::string shared_corner_color = "#d0d0d0";

void add_wang_regions(std::vector<Shape>& shapes, const WangTile& tile, const DrawnSquare& square, RegionSizes sizes)
{
    const auto colors = edge_colors(tile);
    for (std::size_t i = 0; i < 4; ++i) {
        shapes.push_back(corner_region(square, sizes, i, shared_corner_color));
        shapes.push_back(edge_region(square, sizes, i, tile_color(colors[i])));
    }
}

void add_corner_regions(std::vector<Shape>& shapes, const CornerTile& tile, const DrawnSquare& square,
                        RegionSizes sizes)
{
    const auto colors = corner_colors(tile);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string color = tile_color(colors[i]);
        shapes.push_back(corner_region(square, sizes, i, color));
        shapes.push_back(half_edge_region(square, sizes, i, false, edge_tint(color)));
        shapes.push_back(half_edge_region(square, sizes, (i + 3) % 4, true, edge_tint(color)));
    }
}

}

Drawing draw_tile_regions(const TileGrid& grid, double radius)
{
    if (!(radius > 0 && radius <= max_disk_region_radius))
        throw InputError(fmt::format("tile regions for the Poisson disk radius {}: must be above 0 and at "
                                     "most {:.4f} of the tile's side",
                                     radius, max_disk_region_radius));
    const RegionSizes sizes{std::min(0.5, radius * (1 + std::numbers::sqrt2)), radius};
    Drawing drawing = empty_tile_drawing(grid);
    for (std::size_t i = 0; i < grid.tiles.size(); ++i) {
        if (grid.kind == TileKind::wang)
            add_wang_regions(drawing.shapes, wang_tile(grid.tiles[i], grid.colors), tile_square(grid, i), sizes);
        else
            add_corner_regions(drawing.shapes, corner_tile(grid.tiles[i], grid.colors.horizontal), tile_square(grid, i),
                               sizes);
    }
    group_by_fill(drawing.shapes);
    for (std::size_t i = 0; i < grid.tiles.size(); ++i)
        add_region_outlines(drawing.shapes, tile_square(grid, i), sizes);
    add_tile_borders(drawing.shapes, grid, 0.6);
    return drawing;
}

}
