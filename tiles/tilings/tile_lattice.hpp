// The integer lattice on which colours are given: the plane (space), or one that closes after a period.
//
// Coordinates are 64-bit and wrap around: the neighbour of 2^63 - 1 is -2^63.
#pragma once

#include <cstdint>

namespace poissonlab {

/// coordinate + steps on the circle of the 2^64 coordinates.
constexpr std::int64_t stepped(std::int64_t coordinate, std::uint64_t steps)
{
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(coordinate) + steps);
}

/// 2 coordinate on the same circle.
constexpr std::int64_t doubled(std::int64_t coordinate)
{
    return stepped(coordinate, static_cast<std::uint64_t>(coordinate));
}

/// The number of tiles after which a tiling closes along each axis; 0: it does not close. One axis gives a cylinder,
/// two a torus.
struct Period
{
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;

    bool operator==(const Period&) const = default;
};

/// Returns the period that it is given. Throws InputError if one coordinate is negative, or 2^62 or more.
Period checked_period(const Period& period);

/// The lattice that does not close.
struct Plane
{
    static constexpr std::int64_t x(std::int64_t coordinate) { return coordinate; }
    static constexpr std::int64_t y(std::int64_t coordinate) { return coordinate; }
    static constexpr std::int64_t z(std::int64_t coordinate) { return coordinate; }
};

/// The lattice that closes after these periods: coordinates are reduced to 0, 1, ..., period - 1.
struct Torus
{
    Period period;

    constexpr std::int64_t x(std::int64_t coordinate) const { return reduced(coordinate, period.x); }
    constexpr std::int64_t y(std::int64_t coordinate) const { return reduced(coordinate, period.y); }
    constexpr std::int64_t z(std::int64_t coordinate) const { return reduced(coordinate, period.z); }

    static constexpr std::int64_t reduced(std::int64_t coordinate, std::int64_t period)
    {
        if (period == 0) return coordinate;
        const std::int64_t remainder = coordinate % period;
        return remainder < 0 ? remainder + period : remainder;
    }
};

}
