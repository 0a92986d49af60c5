// Limits of the grids of relaxation dart throwing: the grid of its points, and the table of what their disks cover.
#pragma once

#include "host/sampling/cells/table_blocks.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// The grids of kernels/relaxation_dart_throwing.cl: for the table 2^grid_bits cells along each axis, and 2^cover_bits
/// parts of each; for points so many cells along each axis.
struct GridLimits
{
    int most_grid_bits;
    int cover_bits;
    std::uint32_t most_cells;
    std::uint32_t number_bits; ///< of folded cells of points; 0: they are not folded
    std::size_t parts;         ///< of the finest table

    /// Numbers of cells of points in a grid with so many along each axis.
    std::size_t cell_numbers(std::uint32_t grid_size, int dimension) const;
};

GridLimits grid_limits(const RelaxationDartThrowingRequest& request);

/// Calls what() with the squares of the plane or of space that the request has.
template <typename What>
auto with_squares(const RelaxationDartThrowingRequest& request, const What& what)
{
    return request.squares ? what(*request.squares) : what(*request.cubes);
}

/// The fineness of a table around squares that the request has.
TableFineness fineness_of(const RelaxationDartThrowingRequest& request, int grid_bits);

}
