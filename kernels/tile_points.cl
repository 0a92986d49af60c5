// The points of a block of tiles: see host/tile_points/tile_points.hpp.
//
// Constants: KIND, DIMENSION, COLORS, TILES and POINTS (per tile) of the tile set; LOW and STEP: a stored number n is
// at LOW + STEP n units; VALUE, the type of positions: float, in tiles, or uint, in units of 1/65,536 of a tile, modulo
// 2^32.
#include "kernels/common/tiles/tile_points.h"
#include "runtime/poisson_tiles_gpu.h"

#define VALUES (POINTS * DIMENSION) // of a tile
#define JOINED(a, b) a##b
#define VECTOR_OF(type, n) JOINED(type, n)
#define VALUE16 VECTOR_OF(VALUE, 16)

// Vectors of 16 values at any value. Clang has types for that; it warns of functions that take or return such vectors
// where the processor has none as long.
#ifdef __clang__
typedef VALUE16 LooseVector __attribute__((aligned(4)));
typedef ushort16 LooseUnits __attribute__((aligned(2)));
#define LOAD(n, source) (__builtin_convertvector(((global const LooseUnits*)(source))[n], VALUE16) SCALE)
#define STORE(vector, n, target) ((global LooseVector*)(target))[n] = (vector)
#else
#define LOAD(n, source) (VECTOR_OF(convert_, VALUE16)(vload16(n, source)) SCALE)
#define STORE(vector, n, target) vstore16(vector, n, target)
#endif

// Past the caches, where the compiler can and vectors are aligned: what is written is not read again soon.
#if defined(__has_builtin)
#if __has_builtin(__builtin_nontemporal_store) && VALUES % 16 == 0
#undef STORE
#define STORE(vector, n, target) __builtin_nontemporal_store(vector, (global VALUE16*)(target) + (n))
#endif
#endif

/// The place in the block of the tile number `n` of a run. n + run.x is below 2^31, so that the quotient by the width
/// is that of a product, which processors have for vectors, unlike division.
PTILES_FUNCTION uint3 place_in_block(uint n, struct Run run)
{
    const uint row = (uint)((ulong)(run.x + n) * run.reciprocal >> run.shift);
    const uint x = run.x + n - row * run.width;
    if (DIMENSION == 2) return (uint3)(x, run.y + row, 0);
    return (uint3)(x, (run.y + row) % run.height, run.z + (run.y + row) / run.height);
}

/// One work-item finds the number of one tile.
kernel void look_up_tiles(struct Run run, struct Window window, global uint* tiles)
{
    const uint id = get_global_id(0);
    if (id >= run.count) return;
    const struct ptiles_tiling tiling = {KIND,          DIMENSION, COLORS, TILES, POINTS, window.seed,
                                         window.period, LOW,       STEP,   0,     0,      0};
    const uint3 place = place_in_block(id, run);
    tiles[id] = ptiles_tile(
        tiling, (int3)(window.west + (int)place.x, window.south + (int)place.y, window.bottom + (int)place.z));
}

/// Units within a tile, and places of tiles, as positions.
#define IS_float 1
#define IS_uint 0
#if VECTOR_OF(IS_, VALUE)
#define SCALE *(STEP / 65536.0f)
#define FROM_PLACE(place) ((float)(place) + LOW / 65536.0f)
#else
#define SCALE *(uint)STEP
#define FROM_PLACE(place) (((place) << 16) + (uint)(LOW))
#endif

/// One work-item places one tile: its points, with the tile's place added to each. Points stay the 16-bit units of the
/// tile set: what has to be read fits into caches better, and that matters more than conversions.
kernel void place_points(struct Run run, global const uint* tiles, global const ushort* units, global VALUE* points)
{
    const uint id = get_global_id(0);
    if (id >= run.count) return;
    const uint3 place = place_in_block(id, run);
    const VALUE x = FROM_PLACE(place.x);
    const VALUE y = FROM_PLACE(place.y);
#if DIMENSION == 2
    const VALUE16 a = (VALUE16)(x, y, x, y, x, y, x, y, x, y, x, y, x, y, x, y);
    const VALUE16 b = a;
    const VALUE16 c = a;
#else
    // The sequence x, y, z of summands repeats after three vectors of 16.
    const VALUE z = FROM_PLACE(place.z);
    const VALUE16 a = (VALUE16)(x, y, z, x, y, z, x, y, z, x, y, z, x, y, z, x);
    const VALUE16 b = (VALUE16)(y, z, x, y, z, x, y, z, x, y, z, x, y, z, x, y);
    const VALUE16 c = (VALUE16)(z, x, y, z, x, y, z, x, y, z, x, y, z, x, y, z);
#endif
    global const ushort* source = units + (size_t)tiles[id] * VALUES;
    global VALUE* target = points + (size_t)id * VALUES;
    uint n = 0;
    for (; n + 3 <= VALUES / 16; n += 3) {
        STORE(LOAD(n, source) + a, n, target);
        STORE(LOAD(n + 1, source) + b, n + 1, target);
        STORE(LOAD(n + 2, source) + c, n + 2, target);
    }
    if (VALUES / 16 % 3 > 0) STORE(LOAD(n, source) + a, n, target);
    if (VALUES / 16 % 3 > 1) STORE(LOAD(n + 1, source) + b, n + 1, target);
    for (n = VALUES / 16 * 16; n < VALUES; ++n) {
        const uint axis = n % DIMENSION;
        target[n] = (VALUE)source[n] SCALE + (axis == 0 ? x : axis == 1 ? y : FROM_PLACE(place.z));
    }
}
