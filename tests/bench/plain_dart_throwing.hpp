// Dart throwing as one would write it first, made as fast as that gets: random darts, a cell grid, no gap
// list.
#pragma once

#include "geometry/torus.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace poissonlab::bench {

/// xoroshiro128+ of Blackman and Vigna: the cheapest generator that is good enough, so that the comparison is
/// not won by the price of random numbers.
class Xoroshiro
{
public:
    explicit Xoroshiro(std::uint64_t seed)
        : a_(seed * 0x9E3779B97F4A7C15u + 1), b_(seed ^ 0xD1B54A32D192ED03u)
    {}

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

/// `count` points in 2D, at least min_distance apart.
inline std::vector<TorusPoint<2>> plain_dart_throwing(std::size_t count, double min_distance,
                                                      std::uint64_t seed)
{
    const std::uint64_t squared_min_distance = squared_threshold(min_distance);
    const auto size = static_cast<std::uint32_t>(std::ceil(std::sqrt(2.0) / min_distance));
    std::vector<TorusPoint<2>> cells(std::size_t{size} * size);
    std::vector<char> occupied(cells.size());
    const auto wrapped = [size](std::uint32_t cell, int offset) {
        const std::uint32_t c = cell + static_cast<std::uint32_t>(offset);
        return c < size ? c : offset < 0 ? c + size : c - size;
    };

    std::vector<TorusPoint<2>> points;
    points.reserve(count);
    Xoroshiro random(seed);
    while (points.size() < count) {
        const std::uint64_t word = random();
        const TorusPoint<2> dart = {static_cast<std::uint32_t>(word), static_cast<std::uint32_t>(word >> 32)};
        const auto i = static_cast<std::uint32_t>(std::uint64_t{dart[0]} * size >> 32);
        const auto j = static_cast<std::uint32_t>(std::uint64_t{dart[1]} * size >> 32);
        if (occupied[j * size + i]) continue;
        bool free = true;
        for (int b = -2; b <= 2 && free; ++b) {
            const std::uint32_t row = wrapped(j, b) * size;
            for (int a = -2; a <= 2 && free; ++a) {
                const std::uint32_t cell = row + wrapped(i, a);
                free = !occupied[cell] || squared_distance<2>(cells[cell], dart) >= squared_min_distance;
            }
        }
        if (!free) continue;
        occupied[j * size + i] = true;
        cells[j * size + i] = dart;
        points.push_back(dart);
    }
    return points;
}

}
