// How much of each square of a lattice lies in a region, margins aside.
#pragma once

#include "base/regions/fixed_region.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// The parts of squares of 2^shift positions along each side, `columns` times `rows` of them from position 0 on, row by
/// row: areas between the region's edges, but for what doubles round.
std::vector<double> region_shares(const FixedRegion& region, std::uint32_t columns, std::uint32_t rows,
                                  std::uint32_t shift);

}
