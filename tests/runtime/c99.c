/* runtime/poisson_tiles.h and runtime/texture_tiles.h as C99. */
#include "runtime/poisson_tiles.h"
#include "runtime/texture_tiles.h"

uint32_t tile_in_c99(const ptiles_tiling* tiling, int32_t i, int32_t j, int32_t k);

uint32_t tile_in_c99(const ptiles_tiling* tiling, int32_t i, int32_t j, int32_t k)
{
    return ptiles_tile(tiling, i, j, k);
}
