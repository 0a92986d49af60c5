#include "host/sampling/relaxing_grids.hpp"

#include "base/geometry/lattice.hpp"
#include "host/sampling/cells/cells_around.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

template <std::size_t D>
std::array<std::uint32_t, D> shifted(std::array<std::uint32_t, D> corner, int shift)
{
    for (std::uint32_t& c : corner) c >>= shift;
    return corner;
}

}

int TableFineness::block_bits() const { return std::max(square_shift + grid_bits + cover_bits - 32, cover_bits); }

template <std::size_t D>
std::size_t block_count(const SquareCorners<D>& squares, const TableFineness& fineness)
{
    const int shift = fineness.block_shift();
    if (shift == fineness.square_shift) return squares.size();
    std::size_t count = squares.empty() ? 0 : 1;
    for (std::size_t i = 1; i < squares.size(); ++i)
        count += shifted(squares[i], shift) != shifted(squares[i - 1], shift);
    return count;
}

template <std::size_t D>
TableBlocks table_blocks(const SquareCorners<D>& squares, const TableFineness& fineness)
{
    const int block_bits = fineness.block_bits(), shift = fineness.block_shift();
    const int part_shift = shift - block_bits;
    TableBlocks table;
    std::vector<std::array<std::uint32_t, D>> blocks;
    table.first_parts.reserve(squares.size());
    for (const auto& corner : squares) {
        const std::array<std::uint32_t, D> block = shifted(corner, shift);
        if (blocks.empty() || blocks.back() != block) blocks.push_back(block);
        auto part = static_cast<std::uint32_t>((blocks.size() - 1) << static_cast<int>(D) * block_bits);
        for (std::size_t k = 0; k < D; ++k)
            part += (corner[k] >> part_shift & ((1u << block_bits) - 1)) << static_cast<int>(k) * block_bits;
        table.first_parts.push_back(part);
    }
    for (const auto& block : blocks)
        for (const std::uint32_t c : block) table.corners.push_back(c << (block_bits - fineness.cover_bits));
    table.around = numbers_around(blocks);
    return table;
}

template std::size_t block_count<2>(const SquareCorners<2>&, const TableFineness&);
template std::size_t block_count<3>(const SquareCorners<3>&, const TableFineness&);
template TableBlocks table_blocks<2>(const SquareCorners<2>&, const TableFineness&);
template TableBlocks table_blocks<3>(const SquareCorners<3>&, const TableFineness&);

namespace {

/// Folded cells along each axis at most: they are at least as wide as distances, which have more positions than this
/// leaves.
constexpr std::uint32_t most_folded_cells = 1u << 28;

/// Folded cells have twice as many numbers as there are points, or some more.
std::uint32_t folded_bits(std::size_t points) { return static_cast<std::uint32_t>(std::bit_width(points)) + 1; }

/// Cells of the table's grid, a point of the whole set, at most: a grid that would be made for less than the last
/// quarter of the points costs more, with all points to be entered anew, than darts that it decides.
constexpr double table_cells_a_point = 1.5;

/// A table around squares gets half as many cells: more of its cells lie where darts fail without the table.
constexpr double table_cells_a_point_in_squares = table_cells_a_point / 2;

/// Parts of the table: more leave fewer darts undecided, and fit the caches less.
constexpr int most_table_bits = 29;

/// Squares that the region fills to less get a coarser table; this happens where the number of squares is limited.
constexpr double least_filled_part = 1.0 / 4;

int cover_bits_in(int dimension) { return dimension == 2 ? 3 : 2; }

/// The part of the squares that is the region's.
double filled_part(const RelaxationDartThrowingRequest& request)
{
    const double squares =
        with_squares(request, [](const auto& all) { return static_cast<double>(all.corners.size()); });
    if (request.squares)
        return request.region->area() /
               (squares * std::pow(request.region->unit() * std::exp2(request.squares->shift), 2));
    return request.space->volume() / (squares * std::pow(request.space->unit() * std::exp2(request.cubes->shift), 3));
}

/// Returns limits for a table around squares, which counts only cells where darts fall into the region.
GridLimits limits_in_squares(const RelaxationDartThrowingRequest& request)
{
    const double cells = table_cells_a_point_in_squares * static_cast<double>(request.points) /
                         std::max(filled_part(request), least_filled_part);
    const auto parts = [&](int grid_bits) {
        return with_squares(request,
                            [&](const auto& all) { return part_count(all.corners, fineness_of(request, grid_bits)); });
    };
    const auto is_too_fine = [&](int grid_bits) {
        const int of_cell = request.dimension * cover_bits_in(request.dimension);
        return static_cast<double>(parts(grid_bits)) > std::min(std::ldexp(cells, of_cell), std::exp2(most_table_bits));
    };
    // From cells that are as wide as squares on.
    int bits = 32 - with_squares(request, [](const auto& all) { return all.shift; });
    const int most_bits = std::min(24, 32 - cover_bits_in(request.dimension)); // UNIT_BITS of the kernel is positive
    while (bits > 1 && is_too_fine(bits)) --bits;
    while (bits < most_bits && !is_too_fine(bits + 1)) ++bits;
    return {bits, cover_bits_in(request.dimension), most_folded_cells, folded_bits(request.points), parts(bits)};
}

}

std::size_t GridLimits::cell_numbers(std::uint32_t grid_size, int dimension) const
{
    return number_bits > 0 ? std::size_t{1} << number_bits : lattice_cells(grid_size, dimension);
}

TableFineness fineness_of(const RelaxationDartThrowingRequest& request, int grid_bits)
{
    return {with_squares(request, [](const auto& all) { return all.shift; }), grid_bits,
            cover_bits_in(request.dimension)};
}

GridLimits grid_limits(const RelaxationDartThrowingRequest& request)
{
    if (request.is_in_squares()) return limits_in_squares(request);
    const std::size_t points = request.points;
    const int dimension = request.dimension;
    const auto most_cells_of_table = static_cast<std::uint64_t>(table_cells_a_point * static_cast<double>(points));
    const int for_points = (static_cast<int>(std::bit_width(most_cells_of_table)) - 1) / dimension;
    const int most_grid_bits = std::clamp(for_points, 0, most_table_bits / dimension - 2);
    const int cover_bits = std::min(cover_bits_in(dimension), most_table_bits / dimension - most_grid_bits);
    const double most_cells = std::pow(static_cast<double>(points), 1.0 / dimension);
    return {most_grid_bits, cover_bits, std::max(1u, static_cast<std::uint32_t>(most_cells)), 0,
            std::size_t{1} << dimension * (most_grid_bits + cover_bits)};
}

}
