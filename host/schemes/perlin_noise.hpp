// Perlin's noise in space over any hash function of lattice points.
//
// Perlin, Improving noise, SIGGRAPH 2002: the lower 4 bits of a hash choose one of 12 directions, four of them twice.
// Here hash(x, y, z) is evaluated anew at each of the eight corners; his program shares look-ups between corners, as
// host/distribution/tabled_noise.hpp does.
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

/// Perlin's weight of the farther corner at a distance t of 0 to 1 from the nearer one.
inline double noise_fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

/// Noise at a place in a square, 0 to 1 along both sides: slope(dx, dy) is the slope of the corner (dx, dy) there.
double noise_in_square(double x, double y, const auto& slope)
{
    const auto mix = [](double t, double a, double b) { return a + t * (b - a); };
    const double u = noise_fade(x);
    return mix(noise_fade(y), mix(u, slope(0, 0), slope(1, 0)), mix(u, slope(0, 1), slope(1, 1)));
}

/// Noise at a place in a cube, 0 to 1 along its sides: slope(dx, dy, dz) is the slope of the corner (dx, dy, dz) there.
double noise_in_cube(double x, double y, double z, const auto& slope)
{
    const auto layer = [&](int dz) { return noise_in_square(x, y, [&](int dx, int dy) { return slope(dx, dy, dz); }); };
    const double low = layer(0), high = layer(1);
    return low + noise_fade(z) * (high - low);
}

/// Noise at a place, between -1 and 1; 0 at the points of the lattice.
double perlin_noise(const auto& hash, double x, double y, double z)
{
    const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
    const auto i = static_cast<std::int64_t>(fx), j = static_cast<std::int64_t>(fy), k = static_cast<std::int64_t>(fz);
    x -= fx;
    y -= fy;
    z -= fz;
    return noise_in_cube(x, y, z, [&](int dx, int dy, int dz) {
        return noise_slope(hash(i + dx, j + dy, k + dz), x - dx, y - dy, z - dz);
    });
}

/// The sizes of the permutation tables of Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.4.4.
inline LongPeriodDesign noise_hash_design() { return {16, {11, 13, 16, 17, 19}}; }

}
