// Buckets of cells of space, as kernels/common/surfaces/surface.clh has them.
#pragma once

#include "host/sampling/surfaces/fixed_surface.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// A power of two. Blocks of 64 cells are used in part only, as surfaces cross them.
inline std::size_t surface_bucket_count(std::size_t points)
{
    return std::bit_ceil(std::max<std::size_t>(64, 4 * points));
}

/// The bucket of a place, of cells `cell` wide.
inline std::uint32_t surface_bucket(const SurfacePoint& point, std::uint32_t cell, std::uint32_t mask)
{
    const auto along = [&](int k) { return static_cast<std::uint32_t>(point.place[k]) / cell + 1; };
    const std::uint32_t x = along(0), y = along(1), z = along(2);
    std::uint32_t block = ((x >> 2) * 0x8da6b343u) ^ ((y >> 2) * 0xd8163841u) ^ ((z >> 2) * 0xcb1ab31fu);
    block = (block ^ (block >> 15)) * 0x2c1b3c6du;
    block ^= block >> 12;
    return (block << 6 | (z & 3) << 4 | (y & 3) << 2 | (x & 3)) & mask;
}

}
