// The share of each square of a lattice that lies in a region, without margins, and what margins leave of it.
#pragma once

#include "base/regions/fixed_region.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// Squares beside each other, row by row, in positions.
struct ShareLattice
{
    std::array<double, 2> low{}; ///< the lowest corner: nothing of the region lies below it or left of it
    double side = 1;             ///< of a square
    std::uint32_t columns = 0, rows = 0;
};

/// The parts of squares that lie in the region: areas between its edges, but for what doubles round.
std::vector<double> region_shares(const FixedRegion& region, const ShareLattice& lattice);

/// Shares of some squares of that lattice, given by column and row, in rising order of rows and, in a row, of columns.
std::vector<double> region_shares(const FixedRegion& region, const ShareLattice& lattice,
                                  std::span<const std::array<std::uint32_t, 2>> squares);

/// The part of what a square has of the region that margins leave, by places: 1 where none of them lies in the region.
double part_left_by_margins(const FixedRegion& region, const std::array<double, 2>& low, double side);

}
