// Points on a torus of 2^32 units a side, in a grid of cells, for methods that add and ask for points one by one.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/sampling/classics/torus_cells.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

class TorusGrid
{
public:
    /// Makes a grid for about so many points.
    TorusGrid(std::size_t points, int dimension);

    /// Makes a grid for about so many points in a small part of the torus, where distances are some `width`.
    TorusGrid(std::size_t points, int dimension, std::uint64_t width);

    void add(const TorusPosition& position);

    std::size_t size() const { return points_.size(); }
    const TorusPosition& operator[](std::size_t i) const { return points_[i].position; }

    /// The squared distance of the nearest point; UINT64_MAX without points.
    std::uint64_t squared_nearest(const TorusPosition& position) const;

    /// The squared distance of the nearest point or a limit, whichever is less.
    std::uint64_t squared_nearest_below(const TorusPosition& position, std::uint64_t limit) const;

    /// Is a point nearer to the position than a distance, in units below half the torus' side?
    bool is_near(const TorusPosition& position, std::uint64_t distance) const;

    /// Asks memory for what is up to a distance away, so that is_near() need not wait for one piece after the other.
    void ask_around(const TorusPosition& position, std::uint64_t distance) const;

    /// The numbers of all points that are less than a distance away, in units below half the torus' side; of one at the
    /// position as well.
    std::vector<std::size_t> within(const TorusPosition& position, double distance) const;

    /// All points as coordinates in [0, 1).
    PointSet point_set() const;

private:
    /// The last point of a cell, with its number, and a bit if there are more; or any point, with the number of the one
    /// before it in its cell.
    struct Link
    {
        TorusPosition position;
        std::uint32_t number;
    };

    /// True as soon as is(position, number) is true of a point in a cell, the last one first.
    template <typename Is>
    bool any_in(const Link& cell, const Is& is) const;

    /// True as soon as is(position, number) is true of a point in the cells of places up to `reach` away.
    template <typename Is>
    bool any_around(const TorusPosition& position, std::uint64_t reach, const Is& is) const;

    static constexpr std::uint32_t none = UINT32_MAX, has_more = std::uint32_t{1} << 31;
    int dimension_;
    TorusCells cells_;
    std::vector<Link> points_;
    std::vector<Link> lasts_; ///< of cells: a row of them, with what is in nearly all, is one look into memory
};

/// Positions as coordinates in [0, 1).
PointSet point_set_of(std::span<const TorusPosition> positions, int dimension);

}
