// The cells in which darts are thrown: a base grid fine enough for one point a cell, and its subdivisions.
//
// Ebeida, Mitchell, Patney, Davidson, Owens: A simple algorithm for maximal Poisson-disk sampling in high
// dimensions, Computer Graphics Forum 31(2), 2012. Cells that one disk covers are dropped, the others are
// split.
#pragma once

#include <cstdint>
#include <vector>

namespace poissonlab {

/// A hierarchy of grids on the fixed-point torus. Level l has size * 2^l cells along each axis; cell i of
/// level l holds the coordinates from lower_bound(i, l) up to, and without, lower_bound(i + 1, l), and
/// consists of cells 2 i and 2 i + 1 of level l + 1.
struct CellHierarchy
{
    std::uint32_t size = 0; ///< cells along each axis at level 0; their diagonal is at most the minimum distance
    std::uint64_t step = 0; ///< cell width of level 0 in units of 2^-64, rounded up
    int last_level = 0;     ///< the finest level: cells of one or two coordinates along each axis
    int reach = 0;          ///< points within the minimum distance are at most so many level 0 cells apart

    std::uint64_t lower_bound(std::uint64_t cell, int level) const
    {
        __extension__ using Wide = unsigned __int128;
        return static_cast<std::uint64_t>((static_cast<Wide>(cell << (32 - level)) * step) >> 64);
    }

    /// The cell of level 0 that holds a coordinate.
    std::uint32_t cell_of(std::uint32_t coordinate) const
    {
        std::uint64_t cell = std::uint64_t{coordinate} * size >> 32; // widths are rounded: it may be the one beside it
        while (lower_bound(cell, 0) > coordinate) --cell;
        while (lower_bound(cell + 1, 0) <= coordinate) ++cell;
        return static_cast<std::uint32_t>(cell);
    }
};

/// The number of level 0 cells for a minimum distance, and how many are possible: some 20 bytes of device
/// memory each.
double level_0_cells(double min_distance, int dimension);
inline constexpr double max_level_0_cells = 0x1p28;

/// The hierarchy for a minimum distance in (0, 1], unit lengths.
CellHierarchy cell_hierarchy(double min_distance, int dimension);

/// Darts arrive as a Poisson process ("Poisson rain"): in each batch, each open cell gets a Poisson number of
/// darts with this mean. Many darts at once reject each other, which is costly, above all in the first batch,
/// when there are no points yet, and in 3D, where disks reach more cells; few let the list of open cells grow by
/// subdivision faster than points close them.
inline double darts_per_cell(std::uint32_t batch, int dimension)
{
    if (batch > 0) return 1.0;
    return dimension == 2 ? 0.3 : 0.2;
}

/// True if a batch splits the open cells before it throws darts into them, as long as there is a finer level.
inline bool splits_cells(std::uint32_t batch) { return batch >= 2; }

/// The cumulative distribution of that Poisson number, times 2^32: a uniform 32-bit word stands for as many
/// darts as there are entries that do not exceed it. Computed by additions, multiplications and divisions
/// only, so that it is the same on every machine.
std::vector<std::uint32_t> poisson_thresholds(double mean);

/// The most points that any packing can place at this minimum distance (hexagonal; face-centred cubic).
std::uint64_t packing_bound(double min_distance, int dimension);

}
