// Tilings by Beatty sequences: see tiles/aperiodic/beatty_tiling.hpp.
#include "kernels/common/tiles/beatty_tiling.h"

/// A number of 128 bits.
struct Wide
{
    ulong high, low;
};

struct Wide sum_of(struct Wide a, struct Wide b)
{
    struct Wide sum;
    sum.low = a.low + b.low;
    sum.high = a.high + b.high + (sum.low < a.low ? 1 : 0);
    return sum;
}

/// i slope + offset modulo 2^128; i is signed.
struct Wide number_at(long i, struct Wide slope, struct Wide offset)
{
    struct Wide product;
    product.low = (ulong)i * slope.low;
    product.high = mul_hi((ulong)i, slope.low) + (ulong)i * slope.high - (i < 0 ? slope.low : 0);
    return sum_of(product, offset);
}

uint floor_of(struct Wide x) { return (uint)(x.high >> 32); }

/// A work-item makes RUN_TILES tiles of a row. `table`: as BeattyTable. `rows` has one row more than the part.
kernel void make_tiles(const struct Part part, global const uchar* table, global const struct Row* rows,
                       global uchar* tiles)
{
    const uint runs = (part.width + RUN_TILES - 1) / RUN_TILES;
    const uint item = get_global_id(0);
    const uint row = item / runs;
    if (row >= part.rows) return;
    const uint begin = item % runs * RUN_TILES;
    const uint end = min(begin + (uint)RUN_TILES, part.width);
    const struct Row north = rows[row];
    const struct Row south = rows[row + 1];
    struct Machine machine = part.first;
    if (north.machine != 0) machine = part.second;
    const uint kind = (uint)(north.machine * 2 + south.machine) * 9;
    const struct Wide north_slope = {north.slope_high, north.slope_low};
    const struct Wide south_slope = {south.slope_high, south.slope_low};
    const struct Wide north_offset = {north.offset_high, north.offset_low};
    const struct Wide south_offset = {south.offset_high, south.offset_low};
    const long i = (long)(part.x + begin);
    struct Wide x = number_at(i, north_slope, north_offset);
    struct Wide y = number_at(i, south_slope, south_offset);
    uint f = floor_of(x);
    uint g = floor_of(y);
    uint west = machine.factor * f - machine.divisor * g + machine.shift;
    for (uint column = begin; column < end; ++column) {
        x = sum_of(x, north_slope);
        y = sum_of(y, south_slope);
        const uint next_f = floor_of(x);
        const uint next_g = floor_of(y);
        const uint east = machine.factor * next_f - machine.divisor * next_g + machine.shift;
        const uint north_digit = next_f - f;
        const uint south_digit = next_g - g;
        const bool is_tile = north_digit < 3 && south_digit < 3 && west < 4 && east < 4;
        const uint place = ((kind + north_digit * 3 + south_digit) * 4 + west) * 4 + east;
        tiles[(ulong)row * part.width + column] = is_tile ? table[place] : NO_TILE;
        f = next_f;
        g = next_g;
        west = east;
    }
}
