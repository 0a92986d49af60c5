// Perlin's noise as fast as its author has it, to compare costs with: look-ups in one table are shared between corners.
//
// Perlin, Improving noise, SIGGRAPH 2002. In space it is host/schemes/perlin_noise.hpp over the table's hash function;
// the article has no noise in the plane.
#pragma once

#include "host/schemes/perlin_noise.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>

namespace poissonlab {

/// Gradient noise in the plane and in space.
class TabledNoise
{
public:
    /// Takes slopes by a random permutation, which is always the same.
    TabledNoise()
    {
        std::array<std::uint8_t, 256> order;
        std::iota(order.begin(), order.end(), std::uint8_t{0});
        std::mt19937 random(1);
        for (std::size_t i = 255; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
        fill_table(order);
    }

    /// Takes slopes by this permutation of 0 to 255.
    explicit TabledNoise(std::span<const std::uint8_t, 256> permutation) { fill_table(permutation); }

    double at(double x, double y) const
    {
        const double fx = std::floor(x), fy = std::floor(y);
        const std::size_t i = cell(fx), j = cell(fy);
        x -= fx;
        y -= fy;
        const std::size_t beside[2] = {table_[i] + j, table_[i + 1] + j};
        return noise_in_square(x, y, [&](int dx, int dy) {
            return slope_in_plane(table_[beside[dx] + static_cast<std::size_t>(dy)], x - dx, y - dy);
        });
    }

    double at(double x, double y, double z) const
    {
        const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
        const std::size_t i = cell(fx), j = cell(fy), k = cell(fz);
        x -= fx;
        y -= fy;
        z -= fz;
        const std::size_t a = table_[i] + j, b = table_[i + 1] + j;
        const std::size_t above[2][2] = {{table_[a] + k, table_[a + 1] + k}, {table_[b] + k, table_[b + 1] + k}};
        return noise_in_cube(x, y, z, [&](int dx, int dy, int dz) {
            return noise_slope(table_[above[dx][dy] + static_cast<std::size_t>(dz)], x - dx, y - dy, z - dz);
        });
    }

private:
    void fill_table(std::span<const std::uint8_t, 256> permutation)
    {
        for (std::size_t i = 0; i < 512; ++i) table_[i] = permutation[i % 256];
    }

    static std::size_t cell(double x) { return static_cast<std::size_t>(static_cast<std::int64_t>(x) & 255); }
    static double slope_in_plane(std::uint8_t hash, double x, double y)
    {
        const double u = hash & 1 ? x : y, v = hash & 1 ? y : x;
        return (hash & 2 ? -u : u) + (hash & 4 ? -v : v);
    }

    std::array<std::uint8_t, 512> table_{};
};

}
