// A modern integer hash function over the integer lattice: XXH64 of the coordinates.
//
// XXH64 (Collet, xxHash, https://github.com/Cyan4973/xxHash, doc/xxhash_spec.md) of the coordinates as 64-bit
// words, low bytes first, x before y before z. It passes the SMHasher tests, has no tables, and its period is
// that of the coordinates themselves, 2^64.
#pragma once

#include "base/random/random.hpp"
#include "tiles/tilings/hash_period.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace poissonlab {

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

}
