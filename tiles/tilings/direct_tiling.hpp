// Direct stochastic tiling algorithms: the tile at a place from hash functions alone, in constant time.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.3. A hash function gives a colour for
// the coordinates of a lattice point; colours of tiles are those of lattice points or sums of them, so that
// neighbours agree. A tile's coordinates are those of its lower left (bottom) corner. `lattice` is a Plane or
// a Torus. kernels/common/tiles/tiling.clh has the same functions.
#pragma once

#include "tiles/tilings/tile_index.hpp"
#include "tiles/tilings/tile_lattice.hpp"

namespace poissonlab {

/// One hash evaluation for each corner (D. 3.3.1): a complete set.
template <class Hash, class Lattice>
CornerTile direct_corner_tile(const Hash& hash, const Lattice& lattice, std::int64_t x, std::int64_t y)
{
    const std::int64_t west = lattice.x(x);
    const std::int64_t east = lattice.x(stepped(x, 1));
    const std::int64_t south = lattice.y(y);
    const std::int64_t north = lattice.y(stepped(y, 1));
    return {hash(east, north), hash(east, south), hash(west, south), hash(west, north)};
}

/// (a + b) % colors for a, b < colors.
constexpr Color color_sum(Color a, Color b, Color colors)
{
    const Color sum = a + b;
    return sum < colors ? sum : sum - colors;
}

/// Two hash functions at the corners, one for horizontal and one for vertical edges; the colour of an edge is
/// the sum at its ends (D. 3.3.2.1): a complete set.
template <class Hash, class Lattice>
WangTile two_hash_wang_tile(const Hash& horizontal, const Hash& vertical, const Lattice& lattice, std::int64_t x,
                            std::int64_t y)
{
    const WangColors c{horizontal.colors(), vertical.colors()};
    const CornerTile h = direct_corner_tile(horizontal, lattice, x, y);
    const CornerTile v = direct_corner_tile(vertical, lattice, x, y);
    return {color_sum(h.north_west, h.north_east, c.horizontal), color_sum(v.north_east, v.south_east, c.vertical),
            color_sum(h.south_east, h.south_west, c.horizontal), color_sum(v.south_west, v.north_west, c.vertical)};
}

/// One hash function at the corners; the colour of every edge is the sum at its ends (D. 3.3.2.2): the compact set
/// one_hash_wang_set().
template <class Hash, class Lattice>
WangTile one_hash_wang_tile(const Hash& hash, const Lattice& lattice, std::int64_t x, std::int64_t y)
{
    const Color colors = hash.colors();
    const CornerTile c = direct_corner_tile(hash, lattice, x, y);
    return {color_sum(c.north_west, c.north_east, colors), color_sum(c.north_east, c.south_east, colors),
            color_sum(c.south_east, c.south_west, colors), color_sum(c.south_west, c.north_west, colors)};
}

/// A hash evaluation at the middle of each edge, on a lattice twice as dense, whose other points are not used
/// (D. 3.3.2.3): a complete set. `horizontal` and `vertical` are the same hash function unless the two have
/// different numbers of colours. Coordinates on the dense lattice wrap around too, so that on the Plane tiles
/// 2^63 apart are the same.
template <class Hash, class Lattice>
WangTile edge_hash_wang_tile(const Hash& horizontal, const Hash& vertical, const Lattice& lattice, std::int64_t x,
                             std::int64_t y)
{
    const std::int64_t west = doubled(lattice.x(x));
    const std::int64_t east = doubled(lattice.x(stepped(x, 1)));
    const std::int64_t south = doubled(lattice.y(y));
    const std::int64_t north = doubled(lattice.y(stepped(y, 1)));
    const std::int64_t middle_x = stepped(west, 1);
    const std::int64_t middle_y = stepped(south, 1);
    return {horizontal(middle_x, north), vertical(east, middle_y), horizontal(middle_x, south),
            vertical(west, middle_y)};
}

/// One hash evaluation for each corner of the cube (D. 2.10, 4.6): a complete set.
template <class Hash, class Lattice>
CornerCube direct_cube(const Hash& hash, const Lattice& lattice, std::int64_t x, std::int64_t y, std::int64_t z)
{
    const auto slice = [&](std::int64_t level) {
        return direct_corner_tile([&](std::int64_t cx, std::int64_t cy) { return hash(cx, cy, level); }, lattice, x, y);
    };
    return {slice(lattice.z(stepped(z, 1))), slice(lattice.z(z))};
}

/// A hash evaluation at the middle of each face, on a lattice twice as dense: what edge_hash_wang_tile() does, in
/// space, which D. does not have. A complete set.
template <class Hash, class Lattice>
WangCube face_hash_wang_cube(const Hash& hash, const Lattice& lattice, std::int64_t x, std::int64_t y, std::int64_t z)
{
    const std::int64_t west = doubled(lattice.x(x));
    const std::int64_t south = doubled(lattice.y(y));
    const std::int64_t bottom = doubled(lattice.z(z));
    const std::int64_t middle_x = stepped(west, 1);
    const std::int64_t middle_y = stepped(south, 1);
    const std::int64_t middle_z = stepped(bottom, 1);
    return {hash(middle_x, doubled(lattice.y(stepped(y, 1))), middle_z),
            hash(doubled(lattice.x(stepped(x, 1))), middle_y, middle_z),
            hash(middle_x, south, middle_z),
            hash(west, middle_y, middle_z),
            hash(middle_x, middle_y, doubled(lattice.z(stepped(z, 1)))),
            hash(middle_x, middle_y, bottom)};
}

/// One hash evaluation for each end: in one dimension, Wang and corner tiles are dominoes (D. 2.10).
template <class Hash, class Lattice>
Domino direct_domino(const Hash& hash, const Lattice& lattice, std::int64_t x)
{
    return {hash(lattice.x(stepped(x, 1))), hash(lattice.x(x))};
}

}
