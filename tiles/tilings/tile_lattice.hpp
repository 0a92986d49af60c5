// The integer lattice on which colours are given: the plane (space), or one that closes after a period.
//
// Coordinates are 64-bit and wrap around: the neighbour of 2^63 - 1 is -2^63.
#pragma once

#include "tiles/tilings/long_period_hash.hpp"
#include "tiles/tilings/permutation_hash.hpp"
#include "tiles/tilings/two_table_hash.hpp"
#include "tiles/tilings/xxh64_hash.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace poissonlab {

// Any of the hash functions that give lattice points their colours, chosen at run time.

enum class HashKind
{
    permutation, ///< fast, repeats after 252 to 256 points
    long_period, ///< repeats after 5,930,659,848 points, with 2, 3, 4, 6 or 8 colours
    xxh64,       ///< does not repeat
    two_tables,  ///< repeats after 252 to 256 points, and makes few of the tiles
};

/// A hash function and the sizes of its tables, of which the first is the range; none: the default ones.
struct HashChoice
{
    HashKind kind = HashKind::long_period;
    std::vector<std::uint32_t> entries;

    HashChoice(HashKind of, std::vector<std::uint32_t> sizes = {}) : kind(of), entries(std::move(sizes)) {}
};

/// "permutation", "long-period", "xxh64", "two-tables": in the order of the kinds.
const std::vector<std::string>& hash_names();

using ColorHash = std::variant<PermutationHash, LongPeriodHash, Xxh64Hash, TwoTableHash>;

/// The hash function number `stream` of a seed, for this number of colours; those of different streams are
/// independent. Throws InputError for fewer than 2 colours or more than max_colors, and for sizes of tables that the
/// hash function cannot have: a permutation has one, two equal tables as well, XXH64 none, and those of
/// LongPeriodDesign.
ColorHash make_color_hash(const HashChoice& choice, Color colors, std::uint64_t seed, std::uint32_t stream = 0);

inline HashPeriod period_of(const ColorHash& hash)
{
    return std::visit([](const auto& h) { return h.period(); }, hash);
}

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
