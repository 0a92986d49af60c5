// Points of the unit square in a grid of cells, without torus: nearest ones, and all within reach.
#pragma once

#include "analysis/measures/cell_grid.hpp"
#include "base/geometry/point_set.hpp"

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
    PlaneNeighbours(const PointSet& points, double share)
        : grid_(points, CellGrid<2>::cells_of(static_cast<std::size_t>(static_cast<double>(points.size()) / share))),
          numbers_(numbers_in(points))
    {}

    /// The number of points; their order here is that of their cells.
    std::size_t size() const { return grid_.position[0].size(); }
    std::array<double, 2> place(std::size_t i) const { return {grid_.position[0][i], grid_.position[1][i]}; }

    /// The number here of the point that is number i of the set.
    std::size_t number_of(std::size_t i) const { return numbers_[i]; }

    /// The distance of a place from the nearest point other than number `left_out`; infinite where there is none.
    double nearest(const std::array<double, 2>& place, std::size_t left_out = none) const;

    /// Calls what(number, squared distance) for all points that are no farther from a place than `reach`.
    template <class What>
    void for_each_near(const std::array<double, 2>& place, double reach, What&& what) const
    {
        for (int row = cell_along(place[1] - reach); row <= cell_along(place[1] + reach); ++row)
            for (int column = cell_along(place[0] - reach); column <= cell_along(place[0] + reach); ++column)
                visit(column, row, [&](std::size_t i) {
                    const double squared = squared_distance(place, i);
                    if (squared <= reach * reach) what(i, squared);
                });
    }

    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

private:
    /// The grid keeps the order of the set within cells.
    std::vector<std::size_t> numbers_in(const PointSet& points) const
    {
        std::vector<std::size_t> next(grid_.starts.begin(), grid_.starts.end() - 1), numbers;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto column = static_cast<std::size_t>(cell_along(points[i][0]));
            const auto row = static_cast<std::size_t>(cell_along(points[i][1]));
            numbers.push_back(next[row * static_cast<std::size_t>(grid_.cells) + column]++);
        }
        return numbers;
    }

    int cell_along(double coordinate) const
    {
        return std::clamp(static_cast<int>(std::floor(coordinate * grid_.cells)), 0, grid_.cells - 1);
    }
    double squared_distance(const std::array<double, 2>& place, std::size_t i) const
    {
        const double x = grid_.position[0][i] - place[0], y = grid_.position[1][i] - place[1];
        return x * x + y * y;
    }
    template <class What>
    void visit(int column, int row, What&& what) const
    {
        const auto cell =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.cells) + static_cast<std::size_t>(column);
        for (std::size_t i = grid_.starts[cell]; i < grid_.starts[cell + 1]; ++i) what(i);
    }

    CellGrid<2> grid_;
    std::vector<std::size_t> numbers_;
};

}
