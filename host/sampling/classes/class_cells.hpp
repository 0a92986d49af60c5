// The cells that dart throwing with classes looks at: those that may have room, and those in which points lie.
#pragma once

#include "host/sampling/classes/class_darts.hpp"
#include "kernels/common/darts/class_darts.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace poissonlab {

// The order in which classes get points: the one that is least filled is next.
//
// Wei, Multi-class blue noise sampling, 2010, section 3.3 (fill rate).

class FillOrder
{
public:
    /// `shares`: the points of each class that fill it, or numbers in proportion to them; positive. `ends`: what each
    /// has at most; empty: no end.
    FillOrder(std::vector<double> shares, std::vector<std::size_t> ends);

    /// The class whose points over its share are fewest, the first of several; nothing where all are closed or at
    /// their ends.
    std::optional<std::uint32_t> next() const;

    /// The class has one point more.
    void add(std::uint32_t to);

    /// No further point of the class fits.
    void close(std::uint32_t full);

    bool is_closed(std::uint32_t of) const { return is_closed_[of]; }
    const std::vector<std::size_t>& counts() const { return counts_; }

private:
    std::vector<double> shares_;
    std::vector<std::size_t> ends_;
    std::vector<std::size_t> counts_;
    std::vector<bool> is_closed_;
};

/// Cells that may have room for a class: 2^level along each axis, D coordinates each. At first one, all of the torus.
struct OpenCells
{
    std::uint32_t level = 0;
    std::vector<std::uint32_t> cells;

    std::size_t count(int dimension) const { return cells.size() / static_cast<std::size_t>(dimension); }
};

/// Returns the cells into which darts of a class fall at first: all of the torus or, in a region, the cells above those
/// of first_level() that are not outside of it.
OpenCells start_cells(const ClassDartRequest& request, const ClassDistances& distances, std::size_t own);

/// The level at which cells are looked at first: they are about half as wide as the largest distance that the class
/// keeps, so that disks cover some.
std::uint32_t first_level(const ClassDistances& distances, std::size_t own);

/// The last level, of single coordinates.
inline constexpr std::uint32_t last_level = 32;

/// All cells of a level.
OpenCells all_cells(std::uint32_t level, int dimension);

/// The children of cells, one level below, whose bits are set; at the last level, the cells themselves.
OpenCells refined(const OpenCells& parents, const std::vector<std::uint32_t>& kept, int dimension);

/// Returns the pairs of a class with all classes, class after class; `shares` are the classes' shares of the points.
std::vector<contract::class_darts::ClassPair> class_pairs(const ClassDistances& distances,
                                                          const std::vector<double>& shares);

/// Grids with about a point a cell at most, and the number of their cells.
struct ClassGrids
{
    std::vector<contract::class_darts::ClassGrid> grids;
    std::size_t cells = 0;
};

ClassGrids class_grids(const ClassDartRequest& request);

/// An upper bound of the number of points.
std::size_t most_class_points(const ClassDartRequest& request);

}
