// Periodic tilings by polygons: which tiles a window has, and which tiles and corners symmetries of the tiling
// exchange.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II), sections 5 to 7: a
// tiling is k-isohedral if its tiles are of k transitivity classes. A tiling of one class of tiles is isohedral, an
// edge-to-edge one of regular polygons with one class of corners is uniform.
#pragma once

#include "tiles/prototiles/polygon_tiling.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// A tile of a periodic tiling: which of the unit, and how many periods away.
struct RepeatedTile
{
    std::size_t in_unit = 0;
    PlacedTile tile;
};

/// All tiles that reach into the rectangle from (-x, -y) to (x, y), and some beside it, in a fixed order.
std::vector<RepeatedTile> repeated_tiles(const PolygonTiling& tiling, double x, double y);

struct TransitivityClasses
{
    std::vector<std::size_t> tiles; ///< the class of each tile of the unit: 0, 1, ...
    std::size_t tile_classes = 0;
    std::size_t vertex_classes = 0; ///< of the places where tiles have corners
    std::size_t symmetries = 0;     ///< besides the periods: how many motions, up to periods
    bool has_mirrors = false;       ///< reflections or glide reflections
};

/// Tries all motions that turn or mirror a tile of the unit onto another one, by the directions of the ring. Throws
/// Interrupted.
TransitivityClasses transitivity_classes(const PolygonTiling& tiling);

/// True if the tiles of the unit have the area of a period exactly.
bool unit_fills_period(const PolygonTiling& tiling);

}
