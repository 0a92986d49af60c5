// The plain C++ twin of kernels/warp.cl: binary searches in the sums, and quotients bit by bit.
#include "host/sampling/warp/warp.hpp"

#include <algorithm>

namespace poissonlab::reference {
namespace {

/// rest * 2^32 / weight, rounded down; rest < weight <= 2^63.
std::uint64_t long_division(std::uint64_t rest, std::uint64_t weight)
{
    std::uint64_t quotient = 0;
    for (int bit = 0; bit < 32; ++bit) {
        rest *= 2;
        quotient *= 2;
        if (rest < weight) continue;
        rest -= weight;
        ++quotient;
    }
    return quotient;
}

/// total * u / 2^32, rounded down, by the digits of both.
std::uint64_t part_below(std::uint64_t total, std::uint32_t u)
{
    std::uint64_t part = 0;
    for (int bit = 0; bit < 32; ++bit)
        if (u >> bit & 1) part += total >> (32 - bit);
    // Bits that were cut off of each summand may have carried.
    std::uint64_t cut = 0;
    for (int bit = 0; bit < 32; ++bit)
        if (u >> bit & 1) cut += total << bit & 0xffffffff;
    return part + (cut >> 32);
}

/// The place among cells with these sums: cells times 2^32.
std::uint64_t place_among(std::span<const std::uint64_t> sums, std::uint32_t u)
{
    const std::uint64_t t = part_below(sums.back(), u);
    const auto after = std::ranges::upper_bound(sums, t);
    const auto cell = static_cast<std::uint64_t>(after - sums.begin()) - 1;
    return (cell << 32) + long_division(t - sums[cell], sums[cell + 1] - sums[cell]);
}

}

PixelPlaces warp_points(const WarpTable& table, std::span<const std::uint32_t> points)
{
    PixelPlaces places;
    places.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); i += 2) {
        const std::uint64_t y = place_among(table.row_sums, points[i + 1]);
        const std::size_t stride = std::size_t{table.width} + 1;
        const auto row = std::span(table.sums).subspan((y >> 32) * stride, stride);
        places.push_back(place_among(row, points[i]));
        places.push_back(y);
    }
    return places;
}

}
