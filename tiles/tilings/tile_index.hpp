// The colours of a tile and its index, both ways, for Wang tiles, corner tiles, corner cubes, Wang cubes and dominoes.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 2.8: a tile is a number whose digits are
// the colours, clockwise from the north. The dissertation counts 2D tiles only; cubes and dominoes (section
// 2.10) follow the same order here. Colours and indices that are not in range give numbers without meaning.
#pragma once

#include <cstdint>

namespace poissonlab {

using Color = std::uint32_t;     ///< 0, 1, ..., C - 1
using TileIndex = std::uint32_t; ///< in the complete set, also where a set has only some of its tiles

/// The largest numbers of colours whose complete sets can be counted with a TileIndex.
constexpr Color max_colors = 256;
constexpr Color max_cube_colors = 16;
constexpr Color max_wang_cube_colors = 40;

/// The numbers of colours of a Wang tile set's edges: horizontal edges are north and south of a tile, vertical ones
/// east and west.
struct WangColors
{
    Color horizontal = 2;
    Color vertical = 2;

    bool operator==(const WangColors&) const = default;
};

struct WangTile
{
    Color north = 0;
    Color east = 0;
    Color south = 0;
    Color west = 0;

    bool operator==(const WangTile&) const = default;
};

struct CornerTile
{
    Color north_east = 0;
    Color south_east = 0;
    Color south_west = 0;
    Color north_west = 0;

    bool operator==(const CornerTile&) const = default;
};

/// Z points up: the bottom corners have the cube's own z, the top ones the next.
struct CornerCube
{
    CornerTile top;
    CornerTile bottom;

    bool operator==(const CornerCube&) const = default;
};

/// A cube with coloured faces. North is up in a map of a layer; the top has the larger z.
struct WangCube
{
    Color north = 0;
    Color east = 0;
    Color south = 0;
    Color west = 0;
    Color top = 0;
    Color bottom = 0;

    bool operator==(const WangCube&) const = default;
};

struct Domino
{
    Color east = 0;
    Color west = 0;

    bool operator==(const Domino&) const = default;
};

/// D. equation 2.2; with two numbers of colours, each digit has the base of its edge.
constexpr TileIndex wang_index(const WangTile& tile, WangColors c)
{
    return ((tile.north * c.vertical + tile.east) * c.horizontal + tile.south) * c.vertical + tile.west;
}

/// D. equation 2.4.
constexpr WangTile wang_tile(TileIndex index, WangColors c)
{
    WangTile tile;
    tile.west = index % c.vertical;
    index /= c.vertical;
    tile.south = index % c.horizontal;
    index /= c.horizontal;
    tile.east = index % c.vertical;
    tile.north = index / c.vertical;
    return tile;
}

/// D. equation 2.5.
constexpr TileIndex corner_index(const CornerTile& tile, Color colors)
{
    return ((tile.north_east * colors + tile.south_east) * colors + tile.south_west) * colors + tile.north_west;
}

/// D. equation 2.7.
constexpr CornerTile corner_tile(TileIndex index, Color colors)
{
    CornerTile tile;
    tile.north_west = index % colors;
    index /= colors;
    tile.south_west = index % colors;
    index /= colors;
    tile.south_east = index % colors;
    tile.north_east = index / colors;
    return tile;
}

/// The digits of the top, then those of the bottom.
constexpr TileIndex cube_index(const CornerCube& cube, Color colors)
{
    return corner_index(cube.top, colors) * (colors * colors * colors * colors) + corner_index(cube.bottom, colors);
}

constexpr CornerCube cube_tile(TileIndex index, Color colors)
{
    const TileIndex bottoms = colors * colors * colors * colors;
    return {corner_tile(index / bottoms, colors), corner_tile(index % bottoms, colors)};
}

/// The digits of the sides as of a Wang tile, then top and bottom.
constexpr TileIndex wang_cube_index(const WangCube& cube, Color colors)
{
    const TileIndex sides = wang_index({cube.north, cube.east, cube.south, cube.west}, {colors, colors});
    return (sides * colors + cube.top) * colors + cube.bottom;
}

constexpr WangCube wang_cube(TileIndex index, Color colors)
{
    const WangTile sides = wang_tile(index / (colors * colors), {colors, colors});
    return {sides.north, sides.east, sides.south, sides.west, index / colors % colors, index % colors};
}

constexpr TileIndex domino_index(const Domino& domino, Color colors) { return domino.east * colors + domino.west; }

constexpr Domino domino(TileIndex index, Color colors) { return {index / colors, index % colors}; }

}
