// Dart throwing as one would write it first, made as fast as that gets: random darts, a cell grid, no gap
// list.
#pragma once

#include "base/geometry/torus.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace poissonlab::bench {

/// xoroshiro128+ of Blackman and Vigna: the cheapest generator that is good enough, so that the comparison is
/// not won by the price of random numbers.
class Xoroshiro
{
public:
    explicit Xoroshiro(std::uint64_t seed) : a_(seed * 0x9E3779B97F4A7C15u + 1), b_(seed ^ 0xD1B54A32D192ED03u) {}

    std::uint64_t operator()()
    {
        const std::uint64_t result = a_ + b_;
        const std::uint64_t c = a_ ^ b_;
        a_ = (a_ << 24 | a_ >> 40) ^ c ^ (c << 16);
        b_ = c << 37 | c >> 27;
        return result;
    }

private:
    std::uint64_t a_, b_;
};

/// `count` points in 2D or 3D, at least min_distance apart.
template <int D>
std::vector<TorusPoint<D>> plain_dart_throwing(std::size_t count, double min_distance, std::uint64_t seed)
{
    static_assert(D == 2 || D == 3);
    constexpr int reach = 2;
    constexpr int reach_in_z = D == 3 ? reach : 0;
    const std::uint64_t squared_min_distance = squared_threshold(min_distance);
    // One point a cell: a cell's diagonal is at most min_distance.
    const auto size = static_cast<std::uint32_t>(std::ceil(std::sqrt(double{D}) / min_distance));
    std::vector<TorusPoint<D>> cells(std::size_t{size} * size * (D == 3 ? size : 1));
    std::vector<char> occupied(cells.size());
    const auto wrapped = [size](std::uint32_t cell, int offset) {
        const std::uint32_t c = cell + static_cast<std::uint32_t>(offset);
        return c < size ? c : offset < 0 ? c + size : c - size;
    };
    const auto cell_along = [size](std::uint32_t coordinate) {
        return static_cast<std::uint32_t>(std::uint64_t{coordinate} * size >> 32);
    };

    std::vector<TorusPoint<D>> points;
    points.reserve(count);
    Xoroshiro random(seed);
    while (points.size() < count) {
        const std::uint64_t word = random();
        TorusPoint<D> dart{static_cast<std::uint32_t>(word), static_cast<std::uint32_t>(word >> 32)};
        if constexpr (D == 3) dart[2] = static_cast<std::uint32_t>(random() >> 32);
        const std::uint32_t x = cell_along(dart[0]);
        const std::uint32_t y = cell_along(dart[1]);
        const std::uint32_t z = D == 3 ? cell_along(dart[D - 1]) : 0;
        const std::uint32_t own = (z * size + y) * size + x;
        if (occupied[own]) continue;
        bool free = true;
        for (int c = -reach_in_z; c <= reach_in_z && free; ++c) {
            const std::uint32_t plane = D == 3 ? wrapped(z, c) * size : 0;
            for (int b = -reach; b <= reach && free; ++b) {
                const std::uint32_t row = (plane + wrapped(y, b)) * size;
                for (int a = -reach; a <= reach && free; ++a) {
                    const std::uint32_t cell = row + wrapped(x, a);
                    free = !occupied[cell] || squared_distance<D>(cells[cell], dart) >= squared_min_distance;
                }
            }
        }
        if (!free) continue;
        occupied[own] = true;
        cells[own] = dart;
        points.push_back(dart);
    }
    return points;
}

}
