// Counts the points in balls on the unit torus.
#pragma once

#include "analysis/measures/cell_grid.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// The smallest balls of a list, whose points are looked at one by one: larger ones hold so many that it takes less
/// time to look at the cells on their surface.
class BallShells
{
public:
    /// `radii` ascend; the balls lie among `points` points in the unit square (cube).
    BallShells(const std::vector<double>& radii, std::size_t points, int dimension)
    {
        const double most_points = dimension == 2 ? 300 : 8000; // both ways take as long where boxes hold so many
        for (const double radius : radii) {
            if (static_cast<double>(points) * std::pow(2 * radius, dimension) > most_points) break;
            outer_radius_ = radius;
            squared_radii_.push_back(radius * radius);
        }
        if (squared_radii_.empty()) return;
        lowest_ = head_of(squared_radii_.front());
        first_.push_back(0);
        for (std::uint64_t head = lowest_ + 1; least_with(head) < squared_radii_.back(); ++head) {
            std::size_t shell = first_.back();
            while (squared_radii_[shell] <= least_with(head)) ++shell;
            first_.push_back(shell);
        }
    }

    std::size_t count() const { return squared_radii_.size(); }
    double outer_radius() const { return outer_radius_; } ///< of the largest of these balls; 0 where there are none

    /// The number of the smallest ball that holds a point inside of the largest.
    std::size_t shell_of(double squared_distance) const
    {
        const std::uint64_t head = head_of(squared_distance);
        std::size_t shell = head <= lowest_ ? 0 : first_[head - lowest_];
        while (squared_distance >= squared_radii_[shell]) ++shell;
        return shell;
    }

private:
    static constexpr int tail_bits = 48; ///< the exponent and four more bits are left: steps of at most a sixteenth

    /// The leading bits of a positive number, in whose order numbers are.
    static std::uint64_t head_of(double number) { return std::bit_cast<std::uint64_t>(number) >> tail_bits; }

    static double least_with(std::uint64_t head) { return std::bit_cast<double>(head << tail_bits); }

    double outer_radius_ = 0;
    std::vector<double> squared_radii_;
    std::uint64_t lowest_ = 0;       ///< leading bits of the least squared radius
    std::vector<std::size_t> first_; ///< of each leading bits from there on, the smallest ball that may hold the point
};

/// Points in the cells of a grid, in lengths of their box. Radii are at most a quarter of its shortest side: balls meet
/// no cell twice.
template <int D>
class BallCounter
{
public:
    explicit BallCounter(const PointSet& points, const PeriodicBox& box = {})
        : grid_(points, CellGrid<D>::cells_of(points.size())), sides_(box.sides)
    {
        grid_.stretch(box);
        for (std::size_t k = 0; k < D; ++k) cells_[k] = grid_.cells / sides_[k];
    }

    /// A place of the unit torus in the box.
    std::array<double, D> stretched(std::array<double, D> place) const
    {
        for (std::size_t k = 0; k < D; ++k) place[k] *= sides_[k];
        return place;
    }

    /// The points of a ball. It takes the time of its surface: cells inside of it are counted at once.
    std::int64_t count(const std::array<double, D>& centre, double radius) const
    {
        std::int64_t points = 0;
        for_each_row(centre, radius, [&](Ball& ball, const Row& row) { points += count_row(ball, row); });
        return points;
    }

    /// Adds the numbers of points that lie in each of several balls and in no smaller one.
    void add_to_shells(const std::array<double, D>& centre, const BallShells& shells,
                       std::span<std::int64_t> numbers) const
    {
        for_each_row(centre, shells.outer_radius(), [&](Ball& ball, const Row& row) {
            for_each_stretch(ball, row.line, row.begin, row.end, [&](std::size_t from, std::size_t to) {
                for (std::size_t i = from; i < to; ++i)
                    if (const double squared = squared_distance(ball, i); squared < ball.squared_radius)
                        ++numbers[shells.shell_of(squared)];
            });
        });
    }

private:
    struct Ball
    {
        std::array<double, D> centre;
        double squared_radius;
        std::array<int, D> turns; ///< of the torus that lie between cells and their images near the ball
    };

    /// A row of cells along x, on the torus, and which of them, maybe beyond the unit square (cube), meet a ball.
    struct Row
    {
        std::size_t line;
        int begin, end;
        double farthest; ///< squared distance of the row's points from the ball's centre across the row
    };

    /// Hands on each row that has points and meets the ball.
    template <class Visit>
    void for_each_row(const std::array<double, D>& centre, double radius, const Visit& visit) const
    {
        Ball ball{centre, radius * radius, {}};
        const auto low = [&](int k) { return static_cast<int>(std::floor((centre[k] - radius) * cells_[k])); };
        const auto high = [&](int k) { return static_cast<int>(std::floor((centre[k] + radius) * cells_[k])); };
        if constexpr (D == 2) {
            for (int y = low(1); y <= high(1); ++y) visit_row(ball, {0, y}, visit);
        } else {
            for (int z = low(2); z <= high(2); ++z)
                for (int y = low(1); y <= high(1); ++y) visit_row(ball, {0, y, z}, visit);
        }
    }

    template <class Visit>
    void visit_row(Ball& ball, const std::array<int, D>& place, const Visit& visit) const
    {
        const int m = grid_.cells;
        double nearest = 0, farthest = 0; // squared distances of the row's points across it
        std::size_t line = 0;
        for (int k = D - 1; k > 0; --k) {
            const double below = static_cast<double>(place[k]) / cells_[k] - ball.centre[k];
            const double above = static_cast<double>(place[k] + 1) / cells_[k] - ball.centre[k];
            const double near = std::max({0.0, below, -above}), far = std::max(-below, above);
            nearest += near * near, farthest += far * far;
            ball.turns[k] = turns_of(place[k]);
            line = line * static_cast<std::size_t>(m) + static_cast<std::size_t>(place[k] - ball.turns[k] * m);
        }
        if (nearest >= ball.squared_radius || is_empty(line)) return;
        const double outer = std::sqrt(ball.squared_radius - nearest);
        const int begin = static_cast<int>(std::floor((ball.centre[0] - outer) * cells_[0]));
        const int end = static_cast<int>(std::floor((ball.centre[0] + outer) * cells_[0])) + 1;
        visit(ball, Row{line, begin, end, farthest});
    }

    std::int64_t count_row(Ball& ball, const Row& row) const
    {
        int inner_begin = row.end, inner_end = row.end; // cells inside of the ball
        if (row.farthest < ball.squared_radius) {
            const double inner = std::sqrt(ball.squared_radius - row.farthest);
            inner_begin = std::min(row.end, static_cast<int>(std::ceil((ball.centre[0] - inner) * cells_[0])));
            inner_end = std::max(inner_begin, static_cast<int>(std::floor((ball.centre[0] + inner) * cells_[0])));
        }
        std::int64_t points = 0;
        const auto add_all = [&](std::size_t from, std::size_t to) { points += static_cast<std::int64_t>(to - from); };
        const auto add_inside = [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) points += squared_distance(ball, i) < ball.squared_radius;
        };
        for_each_stretch(ball, row.line, row.begin, inner_begin, add_inside);
        for_each_stretch(ball, row.line, inner_begin, inner_end, add_all);
        for_each_stretch(ball, row.line, inner_end, row.end, add_inside);
        return points;
    }

    /// Hands on where the points of the cells begin .. end - 1 of a row lie, in up to two parts: the row is a ring.
    template <class Visit>
    void for_each_stretch(Ball& ball, std::size_t line, int begin, int end, const Visit& visit) const
    {
        const std::size_t* const starts = &grid_.starts[line * static_cast<std::size_t>(grid_.cells)];
        for (int from = begin; from < end;) {
            ball.turns[0] = turns_of(from);
            const int turn = ball.turns[0] * grid_.cells, to = std::min(end, turn + grid_.cells);
            visit(starts[from - turn], starts[to - turn]);
            from = to;
        }
    }

    /// True for a row of cells without points, as most are where they lie in a strip.
    bool is_empty(std::size_t line) const
    {
        const std::size_t first = line * static_cast<std::size_t>(grid_.cells);
        return grid_.starts[first] == grid_.starts[first + static_cast<std::size_t>(grid_.cells)];
    }

    int turns_of(int cell) const { return cell < 0 ? -1 : cell / grid_.cells; }

    double squared_distance(const Ball& ball, std::size_t point) const
    {
        double squared = 0;
        for (int k = 0; k < D; ++k) {
            const double along = grid_.position[k][point] + ball.turns[k] * sides_[k] - ball.centre[k];
            squared += along * along;
        }
        return squared;
    }

    CellGrid<D> grid_;
    std::array<double, 3> sides_;   ///< of the torus
    std::array<double, D> cells_{}; ///< in a unit length along each axis
};

}
