// The tile of an isohedral tiling at a place: see tiles/isohedral/tile_lookup.hpp.
#include "kernels/common/tile_finder.h"

/// True where a ray to the right of a point crosses the outline an odd number of times. Edges count from their lower end
/// on and without their upper end, and points on an edge are to its right.
bool is_inside(global const int* corners, int count, int x, int y)
{
    bool inside = false;
    int ax = corners[2 * count - 2];
    int ay = corners[2 * count - 1];
    for (int i = 0; i < count; ++i) {
        const int bx = corners[2 * i];
        const int by = corners[2 * i + 1];
        if ((ay > y) != (by > y)) {
            const long left = (long)(x - ax) * (by - ay);
            const long right = (long)(y - ay) * (bx - ax);
            inside ^= by > ay ? left < right : left > right;
        }
        ax = bx;
        ay = by;
    }
    return inside;
}

/// `points`: x and y, one after the other. The first candidate that a point is in is its tile.
kernel void find_tiles(const uint count, const uint candidate_count, global const long* points,
                       global const struct Candidate* candidates, global const int* corners,
                       global struct FoundTile* found)
{
    const uint item = get_global_id(0);
    if (item >= count) return;
    const long x = points[2 * item];
    const long y = points[2 * item + 1];
    const int unit = 1 << LATTICE_BITS;
    const int column = (int)(x >> LATTICE_BITS);
    const int row = (int)(y >> LATTICE_BITS);
    const int inside_x = (int)(x & (unit - 1));
    const int inside_y = (int)(y & (unit - 1));
    struct FoundTile tile;
    tile.aspect = -1;
    tile.column = tile.row = tile.x = tile.y = 0;
    for (uint i = 0; i < candidate_count && tile.aspect < 0; ++i) {
        const struct Candidate c = candidates[i];
        const int at_x = inside_x - c.column * unit;
        const int at_y = inside_y - c.row * unit;
        if (at_x < c.low_x || at_x > c.high_x || at_y < c.low_y || at_y > c.high_y) continue;
        if (!is_inside(corners + 2 * c.first, c.count, at_x, at_y)) continue;
        tile.aspect = c.aspect;
        tile.column = column + c.column;
        tile.row = row + c.row;
        tile.x = at_x - c.anchor_x;
        tile.y = at_y - c.anchor_y;
    }
    found[item] = tile;
}
