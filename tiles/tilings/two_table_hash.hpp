// The hash function with a permutation table for each coordinate: h(x, y) = (Px[x % N] + Py[y % N]) % N.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.4.1, equation 3.2, which has it before the hash
// function that makes do with one table (permutation_hash.hpp). Rows of its colours are one row whose colours are
// shifted, where the number of colours C divides N: the colours at the corners of a tile obey NE - NW = SE - SW modulo
// C, so that only C^3 of the C^4 corner tiles occur.
#pragma once

#include "base/random/random.hpp"
#include "tiles/tilings/hash_period.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <array>
#include <cstdint>
#include <span>
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

}
