// Pictures of the Poisson disk tile regions that a tiling or a tile set stands for.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 and 4.5, figures 4.4 and 4.18.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "reports/drawings/tile_image.hpp"

#include <numbers>

namespace poissonlab {

/// The largest Poisson disk radius for which the regions fit in a unit tile.
constexpr double max_disk_region_radius = 1 / (2 * (1 + std::numbers::sqrt2));

/// The regions for a Poisson disk radius r, half the minimum distance, in units of the tile's side. Wang
/// tiles: the edge regions are in the colours of the edges, the corner regions, which depend on four edges,
/// are grey. Corner tiles: the corner regions are in the colours of the corners, edge regions half and half
/// in the colours of their ends, but paler. Throws InputError unless 0 < radius <= max_disk_region_radius,
/// std::logic_error for other tiles.
Drawing draw_tile_regions(const TileGrid& grid, double radius);

}
