// Square and cubic lattices of cells.
#pragma once

#include <cstddef>

namespace poissonlab {

/// The number of cells of a lattice with `side` of them along each axis.
constexpr std::size_t lattice_cells(std::size_t side, int dimension)
{
    return side * side * (dimension == 3 ? side : 1);
}

}
