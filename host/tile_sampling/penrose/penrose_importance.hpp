// The importance that gives a number of points.
#pragma once

#include "host/tile_sampling/penrose/penrose_points.hpp"

#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// The importance whose set has as nearly as possible `points` points in the unit square. With the same density
/// everywhere, that is exact but for numbers between two rows of the table, where a few points come in or go out as all
/// of them move. With another density, it is the best of some tries. Throws InputError where tiles would have to be
/// finer than the finest.
std::uint64_t importance_for_points(const PenroseTiling& tiling, std::size_t points);

}
