// The grid of cells of the plain twins: what kernels find by host/sampling/cells/point_grid.hpp, in the same order.
#pragma once

#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab::reference {

/// The points of each cell in order of their ids.
class PlainCells
{
public:
    PlainCells(const PointSet& points, int cells_per_axis)
        : dimension_(points.dimension), size_(cells_per_axis),
          members_(static_cast<std::size_t>(std::min(std::pow(cells_per_axis, points.dimension) + 0.5, most_lists)))
    {
        for (std::size_t id = 0; id < points.size(); ++id) {
            const std::uint64_t cell = number_of(cell_of(points[id]));
            members_[cell % members_.size()].push_back({cell, id});
        }
    }

    /// The cell of a position.
    std::array<int, 3> cell_of(std::span<const double> position) const
    {
        std::array<int, 3> cell{};
        for (std::size_t k = 0; k < position.size(); ++k) {
            cell[k] = std::min(static_cast<int>(position[k] * size_), size_ - 1);
        }
        return cell;
    }

    /// Calls what(id, repetition) for the points in a cell of the repeated grid.
    template <typename What>
    void for_each_in(std::array<int, 3> cell, What&& what) const
    {
        std::array<int, 3> repetition{};
        for (int k = 0; k < dimension_; ++k) {
            for (; cell[k] < 0; cell[k] += size_) --repetition[k];
            for (; cell[k] >= size_; cell[k] -= size_) ++repetition[k];
        }
        const std::uint64_t number = number_of(cell);
        for (const Member& member : members_[number % members_.size()])
            if (member.cell == number) what(member.id, repetition);
    }

private:
    /// Cells of large grids share lists.
    static constexpr double most_lists = 1 << 20;

    struct Member
    {
        std::uint64_t cell;
        std::size_t id;
    };

    std::uint64_t number_of(const std::array<int, 3>& cell) const
    {
        const auto size = static_cast<std::uint64_t>(size_);
        const auto at = [&](std::size_t k) { return static_cast<std::uint64_t>(cell[k]); };
        return at(0) + size * (at(1) + size * at(2));
    }

    int dimension_;
    int size_;
    std::vector<std::vector<Member>> members_;
};

}
