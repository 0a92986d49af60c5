// Points by position: triangulations know each position once.
#pragma once

#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace poissonlab::reference {

/// Finds the numbers of all points at a position.
class PositionIndex
{
public:
    explicit PositionIndex(const PointSet& points) : points_(points), order_(points.size())
    {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
            return std::ranges::lexicographical_compare(points_[a], points_[b]);
        });
    }

    /// The numbers of the points at a position, in ascending order.
    std::span<const std::size_t> at(std::span<const double> position) const
    {
        const auto less = [](std::span<const double> a, std::span<const double> b) {
            return std::ranges::lexicographical_compare(a, b);
        };
        const auto of = [&](std::size_t i) { return points_[i]; };
        return {std::ranges::lower_bound(order_, position, less, of),
                std::ranges::upper_bound(order_, position, less, of)};
    }

private:
    const PointSet& points_;
    std::vector<std::size_t> order_;
};

/// The part of a cell that the i-th of n coinciding points gets: positions x with side * x >= 0 relative to
/// the point, all (0), or nothing.
enum class Share
{
    all = 0,
    left = -1,
    right = 1,
    nothing
};

inline Share share_of(std::size_t i, std::size_t n)
{
    if (n == 1) return Share::all;
    return i == 0 ? Share::left : i + 1 == n ? Share::right : Share::nothing;
}

}
