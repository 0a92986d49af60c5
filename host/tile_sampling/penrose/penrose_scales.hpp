// The levels of a Penrose tiling in fixed-point numbers.
#pragma once

#include "host/tile_sampling/penrose/penrose_table.hpp"
#include "kernels/common/tile_sampling/penrose.h"

#include <array>
#include <cstdint>

namespace poissonlab {

using PenroseScale = contract::penrose::Scale;
using PenroseScales = std::array<PenroseScale, contract::penrose::SCALES>;

/// A place in multiples of 2^-56 of the unit square's side.
using FixedPlace = std::array<std::int64_t, 2>;

/// The first corner of the root, a fat triangle whose first side has 2 phi^2 sides of the square: the square is in its
/// middle. (-(phi^2 - 1/2), -1/4), that of the authors' program.
inline constexpr FixedPlace penrose_root{static_cast<std::int64_t>(-2.118033988749895 * 0x1p56),
                                         static_cast<std::int64_t>(-0.25 * 0x1p56)};

/// The largest importance that has a level.
std::uint64_t most_penrose_importance();

/// All levels. Places are multiples of 2^-56 of the unit square's side, right within 2^-44: products and sums of
/// doubles make them, which every machine rounds alike.
PenroseScales penrose_scales(const PenroseTable& table);

/// The level of a root with a triangle of 2 sides that covers the unit square, and the row of a table, for an
/// importance from 1 to most_penrose_importance().
struct PenroseRow
{
    std::size_t level;
    std::size_t row;

    bool operator==(const PenroseRow&) const = default;
};
PenroseRow row_of_importance(const PenroseScales& scales, std::uint64_t importance);

/// The first importance of a row, and the one after its last. Rows of the first levels may be empty.
struct ImportanceRange
{
    std::uint64_t begin;
    std::uint64_t end;
};
ImportanceRange importances_of(const PenroseScales& scales, const PenroseRow& row);

/// Points per unit of importance in the unit square, on average: half of the values below an importance belong to
/// points of the root.
inline constexpr double points_per_importance = 0.4998 / 4.979797;

}
