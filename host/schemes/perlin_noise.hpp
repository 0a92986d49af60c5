// Perlin's noise in space over any hash function of lattice points.
//
// Perlin, Improving noise, SIGGRAPH 2002: the lower 4 bits of a hash choose one of 12 directions, four of them twice.
// Here hash(x, y, z) is evaluated anew at each of the eight corners; his program shares look-ups between corners.
#pragma once

#include "tiles/tilings/long_period_hash.hpp"

#include <cmath>
#include <cstdint>

namespace poissonlab {

/// The slope that a hash chooses, in the direction (x, y, z).
inline double noise_slope(std::uint32_t hash, double x, double y, double z)
{
    const std::uint32_t h = hash & 15U;
    const double u = h < 8 ? x : y, v = h < 4 ? y : h == 12 || h == 14 ? x : z;
    return ((h & 1U) != 0 ? -u : u) + ((h & 2U) != 0 ? -v : v);
}

/// Noise at a place, between -1 and 1; 0 at the points of the lattice.
double perlin_noise(const auto& hash, double x, double y, double z)
{
    const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
    const auto i = static_cast<std::int64_t>(fx), j = static_cast<std::int64_t>(fy), k = static_cast<std::int64_t>(fz);
    x -= fx;
    y -= fy;
    z -= fz;
    const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const auto mix = [](double t, double a, double b) { return a + t * (b - a); };
    const auto slope = [&](int dx, int dy, int dz) {
        return noise_slope(hash(i + dx, j + dy, k + dz), x - dx, y - dy, z - dz);
    };
    const double u = fade(x), v = fade(y);
    const auto layer = [&](int dz) {
        return mix(v, mix(u, slope(0, 0, dz), slope(1, 0, dz)), mix(u, slope(0, 1, dz), slope(1, 1, dz)));
    };
    return mix(fade(z), layer(0), layer(1));
}

/// The sizes of the permutation tables of Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.4.4.
inline LongPeriodDesign noise_hash_design() { return {16, {11, 13, 16, 17, 19}}; }

}
