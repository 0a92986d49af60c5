// Rows of lattice colours for streaming tiles, each evaluated once.
#pragma once

#include "tiles/tilings/color_hash.hpp"
#include "tiles/tilings/tile_lattice.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Lattice points in a row, one a tile: those at (scale X + offset, y), where X is the coordinate x, x + 1,
/// ... of the tile, reduced to the period.
struct PointRow
{
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::uint8_t scale = 1; ///< 2: on the lattice that is twice as dense
    std::uint8_t offset = 0;
    std::size_t count = 0;

    bool operator==(const PointRow&) const = default;
};

/// The colours of hash functions along rows of the lattice. The last two rows of each of three series are
/// kept, so that a row that bounds two rows of tiles is evaluated once.
class LatticeRows
{
public:
    /// `period`: of the tiles along x, 0 where they do not close.
    explicit LatticeRows(std::int64_t period) : torus_{{period, 0, 0}} {}

    /// The colours of the points. Valid until two other rows were asked for in the same series (0, 1 or 2),
    /// which must always be of the same hash function.
    const std::uint8_t* row(unsigned series, const ColorHash& hash, const PointRow& points);

private:
    struct Row
    {
        PointRow points;
        std::vector<std::uint8_t> colors; ///< at least as many as points
    };

    void evaluate(Row& row, const ColorHash& hash) const;

    Torus torus_;
    std::array<std::array<Row, 2>, 3> kept_;
    std::array<unsigned, 3> newest_{};
};

}
