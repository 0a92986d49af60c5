// Tiles as coloured polygons in the unit square, in the papers' colours: what all pictures of tiles are made of.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, section 2.7 (colours) and figures 2.3 to 2.7: Wang tiles
// are four triangles in the colours of their edges, corner tiles have a quarter of a disk in the colour of each corner.
#pragma once

#include "tiles/tilings/tile_index.hpp"

#include <array>
#include <string>
#include <vector>

namespace poissonlab {

using TilePoint = std::array<double, 2>; ///< x eastwards, y northwards; the tile is the unit square

struct TileShape
{
    Color color = 0;
    std::vector<TilePoint> corners; ///< of a polygon
};

/// "#ff0000" and so on: red, yellow, green, cyan, blue for 0 to 4, as in the papers; then magenta, orange,
/// grey, and from 8 on shades all around the colour circle.
std::string tile_color(Color color);

/// Four triangles that meet in the middle, from the southern one counterclockwise.
std::vector<TileShape> shapes_of(const WangTile& tile);

/// A quarter of a disk around each corner, from the south-western one counterclockwise.
std::vector<TileShape> shapes_of(const CornerTile& tile);

/// Two halves, the western one first.
std::vector<TileShape> shapes_of(const Domino& tile);

}
