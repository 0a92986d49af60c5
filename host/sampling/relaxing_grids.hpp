// Limits of the grids of relaxation dart throwing: the grid of its points, and the table of what their disks cover.
//
// The cells of a long region in the table of relaxation dart throwing: kernels/common/darts/cover_table.clh.
//
// Cells of a grid with 2^grid_bits of them along each axis of the torus are divided into 2^cover_bits parts along each
// axis. Those around the squares that darts fall into are kept in blocks: a square is a block where cells are no wider
// than it, and else a cell is, with all squares in it.
#pragma once

#include "host/sampling/relaxation_dart_throwing.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The fineness of the table: the widths of its squares, cells and parts.
struct TableFineness
{
    int square_shift; ///< squares are 2^square_shift positions wide
    int grid_bits;
    int cover_bits;

    /// The logarithms of the number of parts of a block along each axis, and of its width in positions.
    int block_bits() const;
    int block_shift() const { return 32 - grid_bits - cover_bits + block_bits(); }
};

/// The corners of squares, by halves of halves of a square, so that those in a wider square follow each other.
template <std::size_t D>
using SquareCorners = std::vector<std::array<std::uint32_t, D>>;

/// The number of blocks, and that of parts of all of them.
template <std::size_t D>
std::size_t block_count(const SquareCorners<D>& squares, const TableFineness& fineness);
template <std::size_t D>
std::size_t part_count(const SquareCorners<D>& squares, const TableFineness& fineness)
{
    return block_count(squares, fineness) << static_cast<int>(D) * fineness.block_bits();
}

struct TableBlocks
{
    std::vector<std::uint32_t> first_parts; ///< of each square: the number of its first part in the table
    std::vector<std::uint32_t> corners;     ///< D words a block: its lowest cell
    std::vector<std::uint32_t> around;      ///< the numbers of the blocks around each: see numbers_around()
};

template <std::size_t D>
TableBlocks table_blocks(const SquareCorners<D>& squares, const TableFineness& fineness);

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
