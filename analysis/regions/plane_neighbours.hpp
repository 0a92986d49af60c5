// Points of the unit square in a grid of cells, without torus: nearest ones, and all within reach.
//
// Cells are as wide as points are far apart where there are some. Where these are few in the square, because a region
// is long, most cells are empty: those that are not are listed row by row then, and looked for in their rows.
#pragma once

#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace poissonlab {

class PlaneNeighbours
{
public:
    /// `share` is the part of the square that has points: cells hold some two of them there.
    PlaneNeighbours(const PointSet& points, double share);

    /// The number of points; their order here is that of their cells, x fastest, and in a cell that of the set.
    std::size_t size() const { return places_.size(); }
    const std::array<double, 2>& place(std::size_t i) const { return places_[i]; }

    /// The number here of the point that is number i of the set.
    std::size_t number_of(std::size_t i) const { return numbers_[i]; }

    /// The distance of a place from the nearest point other than number `left_out`; infinite where there is none.
    double nearest(const std::array<double, 2>& place, std::size_t left_out = none) const;

    /// Calls what(number, squared distance) for all points that are no farther from a place than `reach`.
    template <class What>
    void for_each_near(const std::array<double, 2>& place, double reach, What&& what) const
    {
        const int first = cell_along(place[0] - reach), last = cell_along(place[0] + reach);
        for (int row = cell_along(place[1] - reach); row <= cell_along(place[1] + reach); ++row) {
            const std::size_t end = first_point(last + 1, row);
            for (std::size_t i = first_point(first, row); i < end; ++i) {
                const double squared = squared_distance(place, i);
                if (squared <= reach * reach) what(i, squared);
            }
        }
    }

    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

private:
    int cell_along(double coordinate) const
    {
        return std::clamp(static_cast<int>(std::floor(coordinate * cells_)), 0, cells_ - 1);
    }

    /// The first point in a cell or, if it has none, after it; a row has `cells_` of them.
    std::size_t first_point(int column, int row) const
    {
        const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_);
        if (filled_.empty()) return starts_[cell + static_cast<std::size_t>(column)];
        const auto begin = filled_.begin() + static_cast<std::ptrdiff_t>(rows_[static_cast<std::size_t>(row)]);
        const auto end = filled_.begin() + static_cast<std::ptrdiff_t>(rows_[static_cast<std::size_t>(row) + 1]);
        return starts_[static_cast<std::size_t>(std::lower_bound(begin, end, column) - filled_.begin())];
    }

    double squared_distance(const std::array<double, 2>& place, std::size_t i) const
    {
        const double x = places_[i][0] - place[0], y = places_[i][1] - place[1];
        return x * x + y * y;
    }

    void number_cells(const std::vector<std::size_t>& cell_of_point);
    void list_filled(const std::vector<std::size_t>& cell_of_point);

    int cells_ = 1; ///< along each axis
    std::vector<std::array<double, 2>> places_;
    std::vector<std::size_t> numbers_;
    std::vector<int> filled_;         ///< the columns of cells that have points; none: all cells count
    std::vector<std::size_t> rows_;   ///< the first such cell of each row, and the end of the last
    std::vector<std::size_t> starts_; ///< the first point of each cell that counts, and the end of the last
};

}
