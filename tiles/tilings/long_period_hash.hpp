// Long-period hash functions over the integer lattice: several small permutation tables whose periods
// multiply.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.4.2, equations 3.5 to 3.7. Each table
// is looked up like a permutation hash of its own; the sum of the entries is taken modulo the size of one of
// the tables, the range, and that modulo the number of colours.
#pragma once

#include "base/random/random.hpp"
#include "tiles/tilings/permutation_hash.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// The sizes of the tables. The range is one of them.
struct LongPeriodDesign
{
    std::uint32_t range = 24;
    std::vector<std::uint32_t> sizes{17, 19, 23, 24, 29, 31, 37};

    bool operator==(const LongPeriodDesign&) const = default;
};

/// Colours are exactly as frequent only where their number divides the range. So the range is the multiple of
/// it that is nearest to 24 (of two, the larger): 24 for 2, 3, 4, 6, 8; 25 for 5, 21 for 7. The other sizes
/// are the nearest three primes on either side that do not divide the range; for 24, those of D. 3.4.3.
LongPeriodDesign tiling_hash_design(Color colors);

class LongPeriodHash
{
public:
    /// Random tables. Throws InputError unless
    /// - sizes are pairwise coprime, at least 2 and at most 65536: then periods multiply,
    /// - the range is one of them and a multiple of `colors`: then colours are exactly as frequent,
    /// - the product of all sizes, times the largest, is below 2^64: then remainders need no division.
    LongPeriodHash(Color colors, LongPeriodDesign design, const StreamKey& key);

    /// The tables for tilings.
    LongPeriodHash(Color colors, const StreamKey& key) : LongPeriodHash(colors, tiling_hash_design(colors), key) {}

    Color colors() const { return colors_; }
    const LongPeriodDesign& design() const { return design_; }
    std::uint32_t range() const { return design_.range; }

    /// The exact period of the colours. At most, and but for freak tables, the product of all sizes.
    HashPeriod period() const;

    Color operator()(std::int64_t x) const;
    Color operator()(std::int64_t x, std::int64_t y) const;
    Color operator()(std::int64_t x, std::int64_t y, std::int64_t z) const;

    /// The colours at (x, y), (x + step, y), (x + 2 step, y), ...; step >= 1.
    void fill_row(std::int64_t x, std::int64_t step, std::int64_t y, std::span<std::uint8_t> row) const;

    /// The words that hash_color_... of kernels/common/tiles/tiling.clh takes.
    std::vector<std::uint32_t> device_words() const;

private:
    /// One permutation table. Entries are there twice over, so that the sum of an entry and a reduced
    /// coordinate needs no reduction.
    struct Table
    {
        std::uint32_t size = 0;
        std::uint64_t reciprocal = 0; ///< 2^64 / size, rounded up
        std::size_t begin = 0;        ///< of its entries

        /// reduced % size.
        std::uint32_t remainder(std::uint64_t reduced) const;
    };

    std::uint64_t reduced(std::int64_t coordinate) const;
    std::span<const std::uint16_t> permutation(const Table& table) const
    {
        return std::span(entries_).subspan(table.begin, table.size);
    }

    Color colors_;
    LongPeriodDesign design_;
    std::uint64_t product_ = 1; ///< of all sizes
    std::vector<Table> tables_;
    std::vector<std::uint16_t> entries_;
    std::vector<std::uint8_t> color_of_sum_;
};

/// The remainder without a division (Lemire, Kaser, Kurz: Faster remainder by direct computation, Software:
/// Practice and Experience 49, 2019): exact, because reduced * size < 2^64.
inline std::uint32_t LongPeriodHash::Table::remainder(std::uint64_t reduced) const
{
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::uint32_t>(static_cast<Wide>(reduced * reciprocal) * size >> 64);
}

inline std::uint64_t LongPeriodHash::reduced(std::int64_t coordinate) const
{
    const std::int64_t remainder = coordinate % static_cast<std::int64_t>(product_);
    return static_cast<std::uint64_t>(remainder) + (remainder < 0 ? product_ : 0);
}

inline Color LongPeriodHash::operator()(std::int64_t x) const
{
    const std::uint64_t x0 = reduced(x);
    std::uint32_t sum = 0;
    for (const Table& table : tables_) sum += entries_[table.begin + table.remainder(x0)];
    return color_of_sum_[sum];
}

inline Color LongPeriodHash::operator()(std::int64_t x, std::int64_t y) const
{
    const std::uint64_t x0 = reduced(x);
    const std::uint64_t y0 = reduced(y);
    std::uint32_t sum = 0;
    for (const Table& table : tables_) {
        const std::uint16_t* const entry = entries_.data() + table.begin;
        sum += entry[entry[table.remainder(x0)] + table.remainder(y0)];
    }
    return color_of_sum_[sum];
}

inline Color LongPeriodHash::operator()(std::int64_t x, std::int64_t y, std::int64_t z) const
{
    const std::uint64_t x0 = reduced(x);
    const std::uint64_t y0 = reduced(y);
    const std::uint64_t z0 = reduced(z);
    std::uint32_t sum = 0;
    for (const Table& table : tables_) {
        const std::uint16_t* const entry = entries_.data() + table.begin;
        sum += entry[entry[entry[table.remainder(x0)] + table.remainder(y0)] + table.remainder(z0)];
    }
    return color_of_sum_[sum];
}

}
