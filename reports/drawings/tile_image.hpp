// Pictures of tile sets and tilings, in the papers' colours.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 2.3 to 2.7 and 3.1 to 3.8; tile_shapes.hpp has
// the shapes.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "reports/drawings/square_regions.hpp"
#include "tiles/tilings/tile_set.hpp"
#include "tiles/tilings/tile_shapes.hpp"

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace poissonlab {

/// Wang tiles, corner tiles or dominoes in rows, the first row at the top.
struct TileGrid
{
    TileKind kind = TileKind::corner;
    WangColors colors;
    std::size_t columns = 1;
    std::vector<TileIndex> tiles; ///< row after row; the last row may be shorter
    bool has_gaps = false;        ///< between tiles: a set, not a tiling
};

/// Tiles with black borders on white. Tiles are 32 units wide, gaps and margins 8. Throws
/// std::logic_error for other tiles.
Drawing draw_tiles(const TileGrid& grid);

/// Draws tiles with any colours, which need no index; `grid` says how many and where, not which. They are Wang or
/// corner tiles, as the grid's kind says.
Drawing draw_tiles(const TileGrid& grid, std::span<const WangTile> tiles);
Drawing draw_tiles(const TileGrid& grid, std::span<const CornerTile> tiles);

// Parts for other pictures of the same tiles at the same places:

/// A drawing with the size of the grid's picture and no shapes. Throws std::logic_error as above.
Drawing empty_tile_drawing(const TileGrid& grid);

/// The place of a tile of the grid.
DrawnSquare tile_square(const TileGrid& grid, std::size_t tile);

/// Appends black lines around the tiles, `width` units wide.
void add_tile_borders(std::vector<Shape>& shapes, const TileGrid& grid, double width);

// Pictures of the Poisson disk tile regions that a tiling or a tile set stands for.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 and 4.5, figures 4.4 and 4.18.

/// The largest Poisson disk radius for which the regions fit in a unit tile.
constexpr double max_disk_region_radius = 1 / (2 * (1 + std::numbers::sqrt2));

/// The regions for a Poisson disk radius r, half the minimum distance, in units of the tile's side. Wang
/// tiles: the edge regions are in the colours of the edges, the corner regions, which depend on four edges,
/// are grey. Corner tiles: the corner regions are in the colours of the corners, edge regions half and half
/// in the colours of their ends, but paler. Throws InputError unless 0 < radius <= max_disk_region_radius,
/// std::logic_error for other tiles.
Drawing draw_tile_regions(const TileGrid& grid, double radius);

}
