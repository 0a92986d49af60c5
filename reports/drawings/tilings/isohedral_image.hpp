// Pictures of isohedral tilings.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "tiles/isohedral/isohedral_tile.hpp"

#include <vector>

namespace poissonlab {

/// The side of a square as large as the tile, in units of the drawing.
inline constexpr double isohedral_tile_size = 32;

/// A window of the tiling around the first tile, `columns` by `rows` sides of a square as large as the tile. Tiles have
/// the colours of the colouring and black outlines.
Drawing draw_isohedral_tiling(const IsohedralTile& tile, const TileColoring& coloring, double columns, double rows);

struct IsohedralPanel
{
    std::string caption;
    IsohedralTile tile;
    TileColoring coloring;
};

/// Several tilings in rows of `columns`: square windows of them, in frames, with captions below.
Drawing draw_isohedral_gallery(const std::vector<IsohedralPanel>& panels, std::size_t columns);

}
