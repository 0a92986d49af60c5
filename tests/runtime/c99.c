/* runtime/poisson_tiles.h, runtime/texture_tiles.h and runtime/monotile_points.h as C99. */
#include "runtime/monotile_points.h"
#include "runtime/poisson_tiles.h"
#include "runtime/texture_tiles.h"

uint32_t tile_in_c99(const ptiles_tiling* tiling, int32_t i, int32_t j, int32_t k);

uint32_t tile_in_c99(const ptiles_tiling* tiling, int32_t i, int32_t j, int32_t k)
{
    return ptiles_tile(tiling, i, j, k);
}

uint64_t points_in_c99(const pmono_set* set, const int64_t* origin, const double* low, const double* high);

uint64_t points_in_c99(const pmono_set* set, const int64_t* origin, const double* low, const double* high)
{
    return pmono_in_window(set, 1, origin, low, high, 0, 0, 1);
}
