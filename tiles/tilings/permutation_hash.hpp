// The traditional hash function over the integer lattice: one permutation table, looked up once a coordinate.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.4.1, equations 3.1, 3.3 and 3.4; the
// result is taken modulo the number of colours. Negative coordinates count downwards from the table's end.
//
// Points are as often of each colour, but not so pairs of neighbours: the columns of a tiling are one cycle of N
// colours, shifted. With 256 entries and 4 colours some corner tiles are three times as frequent as others; with 8
// colours, 256 entries have few of each of the 64 pairs, and 36 to 271 of the 4,096 tiles do not occur at all (seeds
// 1 to 3). Larger tables, and the other hash functions, do not have this weakness.
//
// The exact period of a hash function that looks up permutation tables.
//
// Random permutations: the tables that hash functions look up.
#pragma once

#include "base/random/random.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

// Hash functions as kernels/common/tiles/tiling.clh takes them: an array of words, of which the first is a tag.

constexpr std::uint32_t permutation_hash_tag = 0; ///< then: colors, size, entries
constexpr std::uint32_t long_period_hash_tag = 1; ///< then: colors, number of tables, sizes, entries
constexpr std::uint32_t xxh64_hash_tag = 2;       ///< then: colors, seed (low word, high word)
constexpr std::uint32_t two_table_hash_tag = 3;   ///< then: colors, size, entries of the tables of x, y and z

/// h(x + i x', y + j y') = h(x, y) for all integers i and j, with the least numbers x' and y' of which that
/// is true. 0: no period that fits in 64 bits.
struct HashPeriod
{
    std::uint64_t x = 0;
    std::uint64_t y = 0;

    bool operator==(const HashPeriod&) const = default;
};

/// The least divisor d of the number of values such that, cyclically, each value and the d-th after it are
/// the same modulo `modulus`.
std::uint64_t cyclic_period(std::span<const std::uint32_t> values, std::uint64_t modulus);

/// The periods of the colours P[(P[x % N] + y) % N] % C. Both divide N, and are N but for permutations that
/// chance hardly makes unless N is small. The search takes O(N) for each divisor of N.
HashPeriod permutation_period(std::span<const std::uint32_t> permutation, Color colors);

class PermutationHash
{
public:
    static constexpr std::uint32_t max_size = 65536;

    /// Takes a random permutation of 0, 1, ..., size - 1. Throws InputError unless colors <= size <= max_size.
    PermutationHash(Color colors, std::uint32_t size, const StreamKey& key);

    /// Returns the size that it is given. Throws InputError unless colors <= size <= max_size.
    static std::uint32_t checked_size(Color colors, std::uint32_t size);

    /// The largest table of at most max_colors entries in which all colours are as frequent: 256 for 2, 4, 8 and 16
    /// colours, 255 for 3 and 5, 252 for 6 and 7.
    static std::uint32_t default_size(Color colors) { return max_colors / colors * colors; }

    /// Takes a table of the default size.
    PermutationHash(Color colors, const StreamKey& key) : PermutationHash(colors, default_size(colors), key) {}

    /// Takes this permutation of 0, 1, ..., size - 1.
    PermutationHash(Color colors, std::vector<std::uint32_t> permutation);

    Color colors() const { return colors_; }
    std::span<const std::uint32_t> permutation() const { return permutation_; }
    HashPeriod period() const { return permutation_period(permutation_, colors_); }

    Color operator()(std::int64_t x) const { return color_[reduced(x)]; }
    Color operator()(std::int64_t x, std::int64_t y) const { return color_[entry_[reduced(x)] + reduced(y)]; }
    Color operator()(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return color_[entry_[entry_[reduced(x)] + reduced(y)] + reduced(z)];
    }

    /// The colours at (x, y), (x + step, y), (x + 2 step, y), ...; step >= 1.
    void fill_row(std::int64_t x, std::int64_t step, std::int64_t y, std::span<std::uint8_t> row) const;

    /// The words that hash_color_... of kernels/common/tiles/tiling.clh takes.
    std::vector<std::uint32_t> device_words() const;

private:
    std::uint32_t reduced(std::int64_t coordinate) const
    {
        if (mask_ != 0) return static_cast<std::uint32_t>(coordinate) & mask_;
        const auto size = static_cast<std::int64_t>(permutation_.size());
        const std::int64_t remainder = coordinate % size;
        return static_cast<std::uint32_t>(remainder < 0 ? remainder + size : remainder);
    }

    Color colors_;
    std::vector<std::uint32_t> permutation_;
    std::uint32_t mask_ = 0; ///< size - 1 if that is a power of two; else 0
    // The table twice over, so that sums of an entry and a reduced coordinate need no reduction.
    std::vector<std::uint16_t> entry_;
    std::vector<std::uint8_t> color_; ///< entry % colors
};

/// A permutation of 0, 1, ..., size - 1, all of them equally likely (Fisher and Yates). Tables with different
/// numbers are independent. `size` below 2^31.
std::vector<std::uint32_t> random_permutation(std::uint32_t size, const StreamKey& key, std::uint32_t table);

}
