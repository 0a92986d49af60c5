// Perlin's noise, to compare costs with: Improving noise, SIGGRAPH 2002. The permutation is made here, not his.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

namespace poissonlab {

/// Gradient noise in the plane and in space.
class PerlinNoise
{
public:
    PerlinNoise()
    {
        std::array<std::uint8_t, 256> order;
        std::iota(order.begin(), order.end(), std::uint8_t{0});
        std::mt19937 random(1);
        for (std::size_t i = 255; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
        for (std::size_t i = 0; i < 512; ++i) table_[i] = order[i % 256];
    }

    double at(double x, double y) const
    {
        const double fx = std::floor(x), fy = std::floor(y);
        const std::size_t i = cell(fx), j = cell(fy);
        x -= fx;
        y -= fy;
        const double u = fade(x), v = fade(y);
        const std::size_t a = table_[i] + j, b = table_[i + 1] + j;
        return mix(v, mix(u, slope(table_[a], x, y), slope(table_[b], x - 1, y)),
                   mix(u, slope(table_[a + 1], x, y - 1), slope(table_[b + 1], x - 1, y - 1)));
    }

    double at(double x, double y, double z) const
    {
        const double fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
        const std::size_t i = cell(fx), j = cell(fy), k = cell(fz);
        x -= fx;
        y -= fy;
        z -= fz;
        const double u = fade(x), v = fade(y), w = fade(z);
        const std::size_t a = table_[i] + j, b = table_[i + 1] + j;
        const std::size_t aa = table_[a] + k, ab = table_[a + 1] + k, ba = table_[b] + k, bb = table_[b + 1] + k;
        const auto layer = [&](std::size_t up, double h) {
            return mix(v, mix(u, slope(table_[aa + up], x, y, h), slope(table_[ba + up], x - 1, y, h)),
                       mix(u, slope(table_[ab + up], x, y - 1, h), slope(table_[bb + up], x - 1, y - 1, h)));
        };
        return mix(w, layer(0, z), layer(1, z - 1));
    }

private:
    static std::size_t cell(double x) { return static_cast<std::size_t>(static_cast<std::int64_t>(x) & 255); }
    static double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }
    static double mix(double t, double a, double b) { return a + t * (b - a); }
    static double slope(std::uint8_t hash, double x, double y)
    {
        const double u = hash & 1 ? x : y, v = hash & 1 ? y : x;
        return (hash & 2 ? -u : u) + (hash & 4 ? -v : v);
    }
    static double slope(std::uint8_t hash, double x, double y, double z)
    {
        const int h = hash & 15;
        const double u = h < 8 ? x : y, v = h < 4 ? y : h == 12 || h == 14 ? x : z;
        return (h & 1 ? -u : u) + (h & 2 ? -v : v);
    }

    std::array<std::uint8_t, 512> table_{};
};

}
