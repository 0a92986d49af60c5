// The points of a torus that is tiled with polyominoes: see tiles/polyominoes/polyomino_points.hpp.
//
// Constants: FACTOR, by which lengths grow when tiles are divided; CELL_UNITS, in a cell.
#include "kernels/common/tile_sampling/polyominoes.h"

#define CHILDREN (FACTOR * FACTOR)

/// A place is turned by quarters to the left, after x became -x where the third bit is set.
long2 turned(uint turn, long2 place)
{
    if (turn & 4) place.x = -place.x;
    const uint quarters = turn & 3;
    if (quarters == 1) return (long2)(-place.y, place.x);
    if (quarters == 2) return -place;
    if (quarters == 3) return (long2)(place.y, -place.x);
    return place;
}

uint composed_turn(uint second, uint first)
{
    return (((second & 4) ? second - first : second + first) & 3) | ((second ^ first) & 4);
}

/// One work-item finds the tile of one value, from division to division, and places its point. Tiles and children: x, y,
/// turn, and of tiles the class. Places wrap around.
kernel void place_points(struct Torus torus, global const uint* order, global const int4* tiles,
                         global const int4* children, global const uint* next, global const short2* corrections,
                         global ulong2* points)
{
    const uint value = get_global_id(0);
    if (value >= torus.count) return;
    uint index = order[value % torus.roots], code = value / torus.roots, level = 0;
    for (; level < torus.first_level; ++level, code /= CHILDREN) index = index * CHILDREN + code % CHILDREN;
    long2 shift = convert_long2(tiles[index].xy);
    uint turn = tiles[index].z, tile_class = tiles[index].w, number = code;
    for (; level < torus.level; ++level, code /= CHILDREN) {
        const uint child = code % CHILDREN;
        const int4 pose = children[child];
        shift = turned(turn, convert_long2(pose.xy)) + FACTOR * shift;
        turn = composed_turn(turn, pose.z);
        if (level + torus.depth >= torus.level) continue;
        tile_class = next[tile_class * CHILDREN + child];
        number = code / CHILDREN;
    }
    const short2 correction = corrections[tile_class * torus.row + number];
    const long2 place = (long2)(torus.anchor_x, torus.anchor_y) + convert_long2(correction);
    const long2 units = (turned(turn, place) + CELL_UNITS * shift) % (long)torus.side;
    points[value] = convert_ulong2(units + (units < 0 ? (long2)(torus.side) : (long2)(0)));
}
