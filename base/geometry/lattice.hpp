// Square and cubic lattices of cells.
#pragma once

#include <cstddef>
#include <stdexcept>

namespace poissonlab {

/// The number of cells of a lattice with `side` of them along each axis, in one, two or three dimensions. Throws
/// std::invalid_argument for others.
constexpr std::size_t lattice_cells(std::size_t side, int dimension)
{
    switch (dimension) {
    case 1:
        return side;
    case 2:
        return side * side;
    case 3:
        return side * side * side;
    default:
        throw std::invalid_argument("lattice_cells: lattices have one, two or three dimensions");
    }
}

}
