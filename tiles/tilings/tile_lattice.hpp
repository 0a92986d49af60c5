// The integer lattice on which colours are given: the plane (space), or one that closes after a period.
//
// Coordinates are 64-bit and wrap around: the neighbour of 2^63 - 1 is -2^63.
//
// The hash function with a permutation table for each coordinate: h(x, y) = (Px[x % N] + Py[y % N]) % N.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.4.1, equation 3.2, which has it before the hash
// function that makes do with one table (permutation_hash.hpp). Rows of its colours are one row whose colours are
// shifted, where the number of colours C divides N: the colours at the corners of a tile obey NE - NW = SE - SW modulo
// C, so that only C^3 of the C^4 corner tiles occur.
//
// A modern integer hash function over the integer lattice: XXH64 of the coordinates.
//
// XXH64 (Collet, xxHash, https://github.com/Cyan4973/xxHash, doc/xxhash_spec.md) of the coordinates as 64-bit
// words, low bytes first, x before y before z. It passes the SMHasher tests, has no tables, and its period is
// that of the coordinates themselves, 2^64.
#pragma once

#include "base/random/random.hpp"
#include "tiles/tilings/long_period_hash.hpp"
#include "tiles/tilings/permutation_hash.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace poissonlab {

class TwoTableHash
{
public:
    /// Takes random tables of `size` entries. Throws InputError unless colors <= size <= PermutationHash::max_size.
    TwoTableHash(Color colors, std::uint32_t size, const StreamKey& key);

    Color colors() const { return colors_; }
    const std::vector<std::uint32_t>& table(std::size_t axis) const { return tables_.at(axis); }
    HashPeriod period() const;

    Color operator()(std::int64_t x) const { return color(entry(0, x)); }
    Color operator()(std::int64_t x, std::int64_t y) const { return color(entry(0, x) + entry(1, y)); }
    Color operator()(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return color(entry(0, x) + entry(1, y) + entry(2, z));
    }

    /// The colours at (x, y), (x + step, y), (x + 2 step, y), ...; step >= 1.
    void fill_row(std::int64_t x, std::int64_t step, std::int64_t y, std::span<std::uint8_t> row) const;

    /// The words that hash_color_... of kernels/common/tiles/tiling.clh takes.
    std::vector<std::uint32_t> device_words() const;

private:
    std::int64_t reduced(std::int64_t coordinate) const
    {
        const std::int64_t remainder = coordinate % size_;
        return remainder < 0 ? remainder + size_ : remainder;
    }
    std::uint32_t entry(std::size_t axis, std::int64_t coordinate) const
    {
        return tables_[axis][static_cast<std::size_t>(reduced(coordinate))];
    }
    Color color(std::uint32_t sum) const { return sum % static_cast<std::uint32_t>(size_) % colors_; }

    Color colors_;
    std::int64_t size_;
    std::array<std::vector<std::uint32_t>, 3> tables_; ///< of x, y and z
};

/// XXH64 of one to three words.
constexpr std::uint64_t xxh64(std::initializer_list<std::uint64_t> words, std::uint64_t seed)
{
    constexpr std::uint64_t prime_1 = 0x9E3779B185EBCA87;
    constexpr std::uint64_t prime_2 = 0xC2B2AE3D27D4EB4F;
    constexpr std::uint64_t prime_3 = 0x165667B19E3779F9;
    constexpr std::uint64_t prime_4 = 0x85EBCA77C2B2AE63;
    constexpr std::uint64_t prime_5 = 0x27D4EB2F165667C5;
    std::uint64_t hash = seed + prime_5 + 8 * words.size();
    for (const std::uint64_t word : words) {
        hash ^= std::rotl(word * prime_2, 31) * prime_1;
        hash = std::rotl(hash, 27) * prime_1 + prime_4;
    }
    hash = (hash ^ hash >> 33) * prime_2;
    hash = (hash ^ hash >> 29) * prime_3;
    return hash ^ hash >> 32;
}

class Xxh64Hash
{
public:
    Xxh64Hash(Color colors, const StreamKey& key) : colors_(colors), seed_(std::uint64_t{key[1]} << 32 | key[0]) {}

    Color colors() const { return colors_; }
    HashPeriod period() const { return {}; }

    Color operator()(std::int64_t x) const { return color(xxh64({bits(x)}, seed_)); }
    Color operator()(std::int64_t x, std::int64_t y) const { return color(xxh64({bits(x), bits(y)}, seed_)); }
    Color operator()(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return color(xxh64({bits(x), bits(y), bits(z)}, seed_));
    }

    /// The colours at (x, y), (x + step, y), (x + 2 step, y), ...
    void fill_row(std::int64_t x, std::int64_t step, std::int64_t y, std::span<std::uint8_t> row) const
    {
        std::uint64_t at = bits(x);
        for (std::uint8_t& result : row) {
            result = static_cast<std::uint8_t>(color(xxh64({at, bits(y)}, seed_)));
            at += bits(step);
        }
    }

    /// The words that hash_color_... of kernels/common/tiles/tiling.clh takes.
    std::vector<std::uint32_t> device_words() const
    {
        return {xxh64_hash_tag, colors_, static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)};
    }

private:
    static constexpr std::uint64_t bits(std::int64_t coordinate) { return static_cast<std::uint64_t>(coordinate); }

    /// The colour of a hash. Each has equally many of the 2^32 values or one less: a relative bias below colors / 2^32.
    Color color(std::uint64_t hash) const { return static_cast<Color>((hash >> 32) * colors_ >> 32); }

    Color colors_;
    std::uint64_t seed_;
};

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
