// Points sorted by the cells of a grid on the unit torus.
#pragma once

#include "base/geometry/periodic_box.hpp"
#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

template <int D>
struct CellGrid
{
    int cells = 1;                               ///< along each axis
    std::vector<std::size_t> starts;             ///< the first point of each cell, x fastest, and the end of the last
    std::array<std::vector<double>, D> position; ///< sorted

    CellGrid(const PointSet& points, int cells_along) : cells(cells_along) { sort(points); }

    /// The number of cells along an axis that gives some two points a cell, for up to 2^31 points.
    static int cells_of(std::size_t points)
    {
        const double per_axis = std::pow(static_cast<double>(points) / 2, 1.0 / D);
        constexpr double most = D == 2 ? 32768 : 1024;
        return std::max(1, static_cast<int>(std::min(per_axis, most)));
    }

    std::size_t count() const { return starts.size() - 1; }

    /// Positions become those in a box, in its lengths: cells are as many times longer as its sides.
    void stretch(const PeriodicBox& box)
    {
        if (box.is_unit()) return;
        for (std::size_t k = 0; k < D; ++k)
            for (double& along : position[k]) along *= box.sides[k];
    }

private:
    std::size_t cell_of(std::span<const double> x) const
    {
        std::size_t cell = 0;
        for (int k = D - 1; k >= 0; --k) {
            const int along = std::min(static_cast<int>(x[k] * cells), cells - 1);
            cell = cell * static_cast<std::size_t>(cells) + static_cast<std::size_t>(along);
        }
        return cell;
    }

    void sort(const PointSet& points)
    {
        const std::size_t total =
            D == 2 ? static_cast<std::size_t>(cells) * cells : static_cast<std::size_t>(cells) * cells * cells;
        starts.assign(total + 1, 0);
        for (std::size_t i = 0; i < points.size(); ++i) ++starts[cell_of(points[i]) + 1];
        for (std::size_t c = 0; c < total; ++c) starts[c + 1] += starts[c];
        std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
        for (auto& axis : position) axis.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t to = next[cell_of(points[i])]++;
            for (int k = 0; k < D; ++k) position[k][to] = points[i][static_cast<std::size_t>(k)];
        }
    }
};

}
