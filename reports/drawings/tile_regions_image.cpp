#include "reports/drawings/tile_regions_image.hpp"

#include "base/errors/errors.hpp"
#include "reports/drawings/square_regions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
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
