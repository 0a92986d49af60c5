// Darts, boxes and the grid of points that reference dart throwing looks at.
#pragma once

#include "base/geometry/torus.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace poissonlab::reference {

template <int D>
using Cell = std::array<std::uint32_t, D>;

/// A box of fixed-point coordinates: low, low + 1, ..., low + extent along each axis.
template <int D>
struct Box
{
    TorusPoint<D> low;
    std::array<std::uint32_t, D> extent;
};

template <int D>
struct Dart
{
    std::uint32_t time;
    TorusPoint<D> position;
    Cell<D> cell; ///< of level 0, in the grid

    bool operator<(const Dart& other) const { return std::tie(time, position) < std::tie(other.time, other.position); }
};

/// The toroidal distance of two coordinates.
inline std::uint32_t axis_distance(std::uint32_t difference) { return std::min(difference, 0u - difference); }

/// The squared distance from a point to the farthest point of a box.
template <int D>
std::uint64_t squared_farthest(const TorusPoint<D>& point, const Box<D>& box)
{
    std::uint64_t sum = 0;
    for (int k = 0; k < D; ++k) {
        const std::uint32_t forward = point[k] - box.low[k];
        const bool antipode_inside = (forward ^ 0x80000000u) <= box.extent[k];
        const std::uint64_t farthest =
            antipode_inside ? 0x80000000u : std::max(axis_distance(forward), axis_distance(forward - box.extent[k]));
        sum += farthest * farthest;
    }
    return sum;
}

/// The points in cells: a place for each cell of a block, or, where darts fall into bricks, for each point.
template <int D>
class CellPoints
{
public:
    CellPoints(std::uint32_t size, bool has_bricks) : size_(size)
    {
        if (has_bricks) return;
        std::size_t cells = 1;
        for (int k = 0; k < D; ++k) cells *= size;
        occupied_.resize(cells);
        points_.resize(cells);
    }

    void set(const Cell<D>& cell, const TorusPoint<D>& point)
    {
        if (points_.empty()) {
            scattered_[cell] = point;
            return;
        }
        occupied_[index(cell)] = true;
        points_[index(cell)] = point;
    }

    /// The point in a cell; null where there is none.
    const TorusPoint<D>* in(const Cell<D>& cell) const
    {
        if (points_.empty()) {
            const auto found = scattered_.find(cell);
            return found == scattered_.end() ? nullptr : &found->second;
        }
        return occupied_[index(cell)] ? &points_[index(cell)] : nullptr;
    }

private:
    struct Hash
    {
        std::size_t operator()(const Cell<D>& cell) const
        {
            std::uint64_t hash = 0;
            for (const std::uint32_t c : cell) hash = (hash ^ c) * 0x9E3779B97F4A7C15;
            return hash ^ hash >> 32;
        }
    };

    std::size_t index(const Cell<D>& cell) const
    {
        std::size_t result = 0;
        for (int k = D - 1; k >= 0; --k) result = result * size_ + cell[k];
        return result;
    }

    std::uint32_t size_;
    std::vector<char> occupied_;
    std::vector<TorusPoint<D>> points_;
    std::unordered_map<Cell<D>, TorusPoint<D>, Hash> scattered_;
};

/// Points by level 0 cell (at most one in each), and the tests against them. Cells are those of the grid, which is the
/// block, or the torus where darts fall into bricks.
template <int D>
class DartGrid
{
public:
    DartGrid(std::uint32_t size, int reach, std::uint64_t squared_min_distance, bool has_bricks)
        : size_(size), reach_(reach), squared_min_distance_(squared_min_distance), points_(size, has_bricks)
    {}

    void insert(const TorusPoint<D>& point, const Cell<D>& cell) { points_.set(cell, point); }

    /// Is a point nearer to `position`, which lies in `cell`, than the minimum distance?
    bool conflicts(const TorusPoint<D>& position, const Cell<D>& cell) const
    {
        return any_near(
            cell, [&](const TorusPoint<D>& p) { return squared_distance<D>(p, position) < squared_min_distance_; });
    }

    /// Does the disk of one point cover the whole box, which lies in `cell`?
    bool covers(const Box<D>& box, const Cell<D>& cell) const
    {
        return any_near(cell,
                        [&](const TorusPoint<D>& p) { return squared_farthest<D>(p, box) < squared_min_distance_; });
    }

private:
    template <typename Predicate>
    bool any_near(const Cell<D>& cell, Predicate&& predicate) const
    {
        std::array<int, D> offset;
        offset.fill(-reach_);
        for (;;) {
            Cell<D> other;
            for (int k = 0; k < D; ++k) other[k] = wrapped(cell[k], offset[k]);
            if (const TorusPoint<D>* point = points_.in(other); point && predicate(*point)) return true;
            int k = 0;
            while (k < D && ++offset[k] > reach_) offset[k++] = -reach_;
            if (k == D) return false;
        }
    }

    std::uint32_t wrapped(std::uint32_t cell, int offset) const
    {
        const auto size = static_cast<std::int64_t>(size_);
        std::int64_t c = static_cast<std::int64_t>(cell) + offset;
        while (c < 0) c += size;
        while (c >= size) c -= size;
        return static_cast<std::uint32_t>(c);
    }

    std::uint32_t size_;
    int reach_;
    std::uint64_t squared_min_distance_;
    CellPoints<D> points_;
};

}
