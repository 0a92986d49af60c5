// Kari's and Culik's tilings by Beatty sequences: the tile at any place from two numbers of its row.
//
// Kari, A small aperiodic set of Wang tiles, 1996; Culik, An aperiodic set of 13 Wang tiles, 1996. With x(i) = i alpha
// + beta, the digits floor(x(i + 1)) - floor(x(i)) on the north of a row have the mean alpha. The row multiplies by q,
// so that the digits on its south are those of q alpha and q beta, and the carry on the west of tile i is q floor(x(i))
// - floor(q x(i)). Kari: q = 2 up to alpha = 1, else 2/3, and 2/3 < alpha <= 2; Culik: q = 3 up to alpha = 2/3, else
// 1/2, and 1/3 < alpha <= 2. A row's zeros are marked in Culik's set where its alpha is above 2/3.
//
// The numbers of a row are exact rationals, rounded once to 96 bits after the point; rows above each other share what
// is rounded, so that tiles fit whatever the rounding. A floor that it made wrong would be a tile that the set does not
// have: each is looked up.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"
#include "tiles/tilings/tiling.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

enum class BeattySet
{
    kari,
    culik
};

/// Places of tilings from -limit to limit - 1: rows are far more digits the farther they are from row 0, and columns
/// lose digits after the point.
inline constexpr std::int64_t beatty_row_limit = std::int64_t{1} << 20;
inline constexpr std::int64_t beatty_column_limit = std::int64_t{1} << 40;

/// A number modulo 2^32 in units of 2^-96.
struct FixedPoint
{
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    bool operator==(const FixedPoint&) const = default;
};

/// The digits on the north of a row of tiles.
struct BeattyRow
{
    FixedPoint slope;          ///< alpha
    FixedPoint offset;         ///< beta
    std::uint32_t machine = 0; ///< 0: the tiles below multiply by 2 (3); 1: by 2/3 (1/2)

    bool operator==(const BeattyRow&) const = default;
};

/// A machine's multiplication: a carry's number is `factor` floor(x) - `divisor` floor(q x) + `shift`.
struct BeattyMachine
{
    std::int32_t factor = 1;
    std::int32_t divisor = 1;
    std::int32_t shift = 0;

    bool operator==(const BeattyMachine&) const = default;
};

/// Tiles by the machine of their row and of the next one, their digits 0 to 2 and carries 0 to 3:
/// ((((machine * 2 + next) * 3 + north) * 3 + south) * 4 + west) * 4 + east.
inline constexpr std::size_t beatty_table_size = 2 * 2 * 3 * 3 * 4 * 4;
/// The table's entry where there is no tile.
inline constexpr std::uint8_t no_beatty_tile = 255;
using BeattyTable = std::array<std::uint8_t, beatty_table_size>;

class BeattyTiling
{
public:
    /// The seed decides alpha and beta of row 0: multiples of 2^-62, spread evenly over the range of alpha and over 0
    /// to 1.
    BeattyTiling(BeattySet set, std::uint64_t seed);

    /// The digits on the north of the rows y, y - 1, ..., y - count + 1. The north of row 0 has the alpha and beta of
    /// the seed. Throws InputError for rows beyond the limit.
    std::vector<BeattyRow> rows(std::int64_t y, std::size_t count) const;

    const std::array<BeattyMachine, 2>& machines() const { return machines_; }
    const BeattyTable& table() const { return table_; }

private:
    BeattySet set_;
    std::uint64_t slope_;  ///< of row 0, times 2^62
    std::uint64_t offset_; ///< of row 0, times 2^62
    std::array<BeattyMachine, 2> machines_;
    BeattyTable table_;
};

/// Throws InputError for windows with places beyond the limits.
void check_beatty_window(const TileWindow& window);

namespace reference {
/// The tiles of a window: positions in kari_tiles() or culik_tiles(), rows from north to south, each from west to east.
/// Throws InputError for windows beyond the limits, and std::logic_error for a tile that the set does not have.
std::vector<std::uint8_t> beatty_tiles(const BeattyTiling& tiling, const TileWindow& window);
}

}
