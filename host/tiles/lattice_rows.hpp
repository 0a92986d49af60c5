// Rows of lattice colours for streaming tiles, each evaluated once.
#pragma once

#include "tiles/color_hash.hpp"
#include "tiles/lattice.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// The colours of hash functions along rows of the lattice. The last two rows of each of three series are
/// kept, so that a row that bounds two rows of tiles is evaluated once.
class LatticeRows
{
public:
    /// `period`: of the lattice, 0 where it does not close.
    explicit LatticeRows(Period period) : period_(period) {}

    /// The colours at (x, y), (x + step, y), ...: `count` of them. Valid until two other rows were asked for
    /// in the same series (0, 1 or 2). A series has one hash function.
    const std::uint8_t* row(unsigned series, const ColorHash& hash, std::int64_t x, std::int64_t y,
                            std::uint64_t step, std::size_t count);

private:
    struct Row
    {
        std::int64_t x = 0;
        std::int64_t y = 0;
        std::uint64_t step = 0;
        std::vector<std::uint8_t> colors; ///< at least as many as are valid
        std::size_t count = 0;
    };

    void evaluate(Row& row, const ColorHash& hash) const;

    Period period_;
    std::array<std::array<Row, 2>, 3> kept_;
    std::array<unsigned, 3> newest_{};
};

}
