// Tiles as coloured polygons in the unit square: what all pictures of tiles are made of.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 2.3 to 2.7: Wang tiles are four triangles in the
// colours of their edges, corner tiles have a quarter of a disk in the colour of each corner. The order of hues is that
// of section 2.7, the hues are those that Okabe and Ito chose so that colour-blind people tell them apart.
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

/// "#d55e00" and so on: vermilion, yellow, green, sky blue, blue for 0 to 4; then reddish purple, orange, grey, and
/// from 8 on shades all around the colour circle.
std::string tile_color(Color color);

/// Four triangles that meet in the middle, from the southern one counterclockwise.
std::vector<TileShape> shapes_of(const WangTile& tile);

/// A quarter of a disk around each corner, from the south-western one counterclockwise.
std::vector<TileShape> shapes_of(const CornerTile& tile);

/// Two halves, the western one first.
std::vector<TileShape> shapes_of(const Domino& tile);

}
