// Minimum distances that vary from place to place, as a table that every device reads alike.
//
// Nodes lie a power of two of positions apart, and between four of them the distance is bilinear, in whole numbers. The
// slope is therefore known exactly, and bounds over boxes are exact. In most regions the nodes are those of a grid over
// the region's box. Where the region fills little of its box, as roads do, they are the corners of small squares that
// cover the region and are found by their row and column.
#pragma once

#include "base/geometry/torus.hpp"
#include "base/regions/fixed_region.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// A distance at a place, both in units of the region.
using DistanceAt = std::function<double(double x, double y)>;

/// The distances of a formula or a picture at the nodes of a region's grid, in the region's units.
struct DistanceTable
{
    /// Nodes of a grid over the box are 2^22 positions apart: 512 cells along the longest side.
    static constexpr std::uint32_t box_shift = 22;

    /// Squares are no smaller than 2^15 positions, so that 32 bits say which one it is.
    static constexpr std::uint32_t least_shift = 15;

    std::uint32_t shift = box_shift; ///< nodes are 2^shift positions apart
    std::uint32_t columns = 0;       ///< cells of the box; there is a node more along each axis
    std::uint32_t rows = 0;

    /// The squares whose corners are the nodes of a long region: column and row of each, row by row. It is empty
    /// where the nodes are those of the whole box.
    std::vector<std::array<std::uint32_t, 2>> squares;

    std::vector<double> nodes; ///< row by row, or of each square the lower two and the upper two
    std::vector<double> share; ///< the part of each cell that lies in the region, from 0 to 1
    double slope = 0;          ///< the largest one in the region: by how much the distance grows along a unit of length
    double slope_of_box = 0;   ///< the largest one in the box around it; infinite where some of it has no distances
    std::array<double, 2> steepest{}; ///< where the slope in the region is largest, in its units
    double least = 0, most = 0;       ///< distances in the region

    /// The integral over the region of 1 / distance^2: twice the number of points over the root of 3 of the densest
    /// packing, nearly.
    double packing = 0;
};

/// Looks at the distances in a region; `name` is what messages call them. Between nodes they are no more than bilinear
/// interpolation says, nearly: where a formula is curved, the nodes around have more. Throws InputError where a
/// distance in the region is not above 0.
DistanceTable distance_table(const FixedRegion& region, const DistanceAt& distance, const std::string& name);

/// The distance of a picture that is laid over a region's box, from the smallest one where its values are 0 to the
/// largest one where they are 1: bilinear between middles of pixels. Or of a formula in the region's coordinates.
/// Throws InputError, one line with the text, for what is neither.
DistanceAt distance_of_text(const std::string& text, const std::string& from, const std::array<double, 2>& range,
                            const RegionBox& box);

/// A table in whole numbers: distances in positions of the region's grid.
class DistanceField
{
public:
    /// Distances are those of a table times `scale`, enlarged by what rounding can take from them.
    DistanceField(const DistanceTable& table, const FixedRegion& region, double scale);

    /// The distance at a position, at least 2 and below 2^31.
    std::uint32_t at(const TorusPoint<2>& position) const;

    /// A lower bound over positions low, low + 1, ..., low + 2^bits - 1 along each axis, where low is a multiple of
    /// that many: exact at a single position, and at most 2 below elsewhere.
    std::uint32_t least_in(const TorusPoint<2>& low, std::uint32_t bits) const;

    std::uint32_t least() const { return bounds_.back(); }

    // Kernels read these: kernels/common/darts/distance_field.clh.
    std::uint32_t columns() const { return columns_; } ///< 0: squares
    std::uint32_t rows() const { return rows_; }
    std::uint32_t shift() const { return shift_; }
    std::span<const std::uint32_t> nodes() const { return nodes_; }
    /// With a grid: the least node of each cell, then of each block of 2 x 2 cells, and so on until one block is left;
    /// sides are halved and rounded up. With squares there is a list for each size, from 2^shift to 2^31 positions,
    /// doubling each time. First come the places in bounds() where the lists begin, and where the last one ends. Each
    /// list has the numbers row << 16 | column of its squares, in rising order, and then the least node of each square.
    std::span<const std::uint32_t> bounds() const { return bounds_; }

private:
    void bound_cells();
    void bound_squares(const DistanceTable& table);
    std::uint32_t number_of_square(const TorusPoint<2>& position, std::uint32_t level) const;

    std::uint32_t columns_ = 0, rows_ = 0, shift_ = DistanceTable::box_shift;
    std::vector<std::uint32_t> nodes_, bounds_;
};

}
