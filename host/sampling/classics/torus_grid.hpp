// Points on a torus of 2^32 units a side, in a grid of cells, for methods that ask for the nearest point one by one.
#pragma once

#include "base/geometry/point_set.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

using TorusPosition = std::array<std::uint32_t, 3>; ///< in units; 2D: z is 0

/// The squared distance in units, exact: at most 3 * 2^62.
std::uint64_t squared_torus_distance(const TorusPosition& a, const TorusPosition& b);

class TorusGrid
{
public:
    /// For about so many points.
    TorusGrid(std::size_t points, int dimension);

    void add(const TorusPosition& position);

    std::size_t size() const { return points_.size(); }
    const TorusPosition& operator[](std::size_t i) const { return points_[i].position; }

    /// Asks memory for what squared_nearest() looks at first, in two turns: for the cells of the position, and, once
    /// these are there, for the first points in them.
    void ask_for_cells(const TorusPosition& position) const;
    void ask_for_points(const TorusPosition& position) const;

    /// The squared distance of the nearest point, or any one that is at most `enough` of a point that is as near;
    /// UINT64_MAX without points.
    std::uint64_t squared_nearest(const TorusPosition& position, std::uint64_t enough = 0) const;

    /// The numbers of all points that are less than a distance away, in units below half the torus' side; of one at the
    /// position as well.
    std::vector<std::size_t> within(const TorusPosition& position, double distance) const;

    /// All points as coordinates in [0, 1).
    PointSet point_set() const;

private:
    void visit(const std::array<std::int64_t, 3>& cell, const TorusPosition& position, std::uint64_t& nearest) const;
    std::size_t cell_number(const std::array<std::int64_t, 3>& cell) const;

    /// Cells beside each other along x are beside each other in memory.
    std::array<std::int64_t, 3> cell_of(const TorusPosition& position) const;

    /// A point, and the one before it in its cell: one look into memory.
    struct Link
    {
        TorusPosition position;
        std::uint32_t next;
    };

    static constexpr std::uint32_t none = UINT32_MAX, empty = UINT32_MAX - 1;
    int dimension_;
    int bits_ = 0; ///< cells along an axis: 2^bits
    std::vector<Link> points_;
    std::vector<std::uint32_t> heads_; ///< the last point of each cell
    std::vector<Link> lasts_; ///< the same points themselves: cells in a row, with what is in them, are one look
};

}
