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

/// Returns the cells into which darts of a class fall at first: all of the torus or, in a region, the cells above those
/// of first_level() that are not outside of it, or those of the class's density.
OpenCells start_cells(const ClassPart& part, int dimension, const ClassDistances& distances, std::size_t own);

/// Returns the cells of a level that are not outside of a region.
OpenCells cells_in_region(const FixedRegion& region, std::uint32_t level);

/// The bits of targets that are random at first: intervals have the share of one or two points of the class, which has
/// so many.
std::uint32_t spread_of(const OpenCells& cells, std::size_t points);

/// Returns the target of a class's point of this number: Kronecker's sequence of the golden ratio, moved at random.
std::uint32_t target_of(std::uint32_t own, std::size_t number, const StreamKey& stream);

/// The level at which cells are looked at first: they are about half as wide as the largest distance that the class
/// keeps, so that disks cover some.
std::uint32_t first_level(const ClassDistances& distances, std::size_t own);

/// The last level, of single coordinates.
inline constexpr std::uint32_t last_level = 32;

/// All cells of a level.
OpenCells all_cells(std::uint32_t level, int dimension);

/// The children of cells, one level below, whose bits are set; those of `level` that have it, the cells themselves.
OpenCells refined(const OpenCells& parents, const std::vector<std::uint32_t>& kept, int dimension, std::uint32_t level);

/// Finds the shares of masses before each cell.
void find_starts(OpenCells& cells);

/// Returns the level at which cells are looked at again after so many times TRIES darts of a slot failed; nothing: they
/// stay as they are. A class has `count` of `points` points. Cells without a density are divided each time. Those with
/// one are divided first only while they are large beside distances, because where the density is largest there may be
/// no room, and much elsewhere: covered cells are left out, but no more often than 64 times.
std::optional<std::uint32_t> level_after(const OpenCells& open, const ClassDistances& distances, std::size_t own,
                                         std::uint32_t failed, std::size_t count, std::size_t points);

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

/// The cells whose bits say that single points cover them, and the number of words of bits.
struct CoveredGrids
{
    std::vector<contract::class_darts::CoveredCells> grids;
    std::size_t words = 0;
};

CoveredGrids covered_grids(const ClassDartRequest& request);

/// Returns the number of parts that are filled one after another, at least one, and makes one of them.
std::size_t part_count(const ClassDartRequest& request);
ClassPart part_of(const ClassDartRequest& request, std::size_t part);

/// An upper bound of the number of points.
std::size_t most_class_points(const ClassDartRequest& request);

}
