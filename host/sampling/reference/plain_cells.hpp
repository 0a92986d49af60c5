// The grid of cells of the plain twins: what kernels find by host/sampling/cells/point_grid.hpp, in the same order.
#pragma once

#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab::reference {

/// The points of each cell in order of their ids.
class PlainCells
{
public:
    PlainCells(const PointSet& points, int cells_per_axis)
        : dimension_(points.dimension), size_(cells_per_axis),
          members_(static_cast<std::size_t>(std::pow(cells_per_axis, points.dimension) + 0.5))
    {
        for (std::size_t id = 0; id < points.size(); ++id) members_[number_of(cell_of(points[id]))].push_back(id);
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
        for (const std::size_t id : members_[number_of(cell)]) what(id, repetition);
    }

private:
    std::size_t number_of(const std::array<int, 3>& cell) const
    {
        return static_cast<std::size_t>(cell[0] + size_ * (cell[1] + size_ * cell[2]));
    }

    int dimension_;
    int size_;
    std::vector<std::vector<std::size_t>> members_;
};

}
