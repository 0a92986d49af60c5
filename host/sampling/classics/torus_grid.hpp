// Points on a torus of 2^32 units a side, in a grid of cells, for methods that add and ask for points one by one.
#pragma once

#include "base/geometry/point_set.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

// The cells of a grid on a torus of 2^32 units a side, and which of them are near a position.

using TorusPosition = std::array<std::uint32_t, 3>; ///< in units; 2D: z is 0

/// The squared distance in units, exact: at most 3 * 2^62.
inline std::uint64_t squared_torus_distance(const TorusPosition& a, const TorusPosition& b)
{
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t difference = static_cast<std::int32_t>(a[k] - b[k]); // the shorter way round
        sum += static_cast<std::uint64_t>(difference * difference);
    }
    return sum;
}

/// No two positions are farther apart along an axis.
inline constexpr std::uint64_t half_torus = std::uint64_t{1} << 31;

/// Points at a squared distance or nearer are within this reach along each axis.
inline std::uint64_t reach_for(std::uint64_t squared)
{
    return std::min(half_torus, static_cast<std::uint64_t>(std::sqrt(static_cast<double>(squared))) + 1);
}

/// Cells are numbered with x fastest, so that those of a row are beside each other in memory.
///
/// Where points lie in a small part of the torus, cells are folded: as narrow as one likes, but many of them share a
/// number. Rows go on to be beside each other, and begin at multiples of the golden ratio of all numbers, so that cells
/// that are near each other, or along a line, share none.
class TorusCells
{
public:
    /// One cell for each of about so many points. Not a power of two: cells would hold up to eight points in 3D, and
    /// how many would depend on the number of points.
    TorusCells(std::size_t points, int dimension)
        : dimension_(dimension),
          size_(std::max<std::int64_t>(1, std::llround(std::pow(static_cast<double>(points), 1.0 / dimension))))
    {}

    /// Folded cells of at least that width, for about so many points.
    static TorusCells folded(std::size_t points, int dimension, std::uint64_t width)
    {
        TorusCells cells(1, dimension);
        cells.size_ = static_cast<std::int64_t>(std::max<std::uint64_t>(1, (std::uint64_t{1} << 32) / width));
        const int bits = std::max(4, static_cast<int>(std::bit_width(points)) + 1);
        cells.numbers_ = std::uint64_t{1} << bits;
        return cells;
    }

    std::size_t count() const
    {
        if (numbers_ > 0) return numbers_;
        return static_cast<std::size_t>(dimension_ == 3 ? size_ * size_ * size_ : size_ * size_);
    }

    bool is_folded() const { return numbers_ > 0; }

    /// The width of a cell in units, rounded down.
    std::uint64_t width() const { return (std::uint64_t{1} << 32) / static_cast<std::uint64_t>(size_); }

    std::size_t number_of(const TorusPosition& position) const
    {
        const auto along = [&](std::size_t axis) { return position[axis] * size_ >> 32; };
        if (numbers_ > 0) return folded_number(along(0), along(1), dimension_ == 3 ? along(2) : 0);
        return static_cast<std::size_t>(((dimension_ == 3 ? along(2) * size_ : 0) + along(1)) * size_ + along(0));
    }

    /// Calls what(first, end), numbers of cells beside each other, until it is true; folded ones may come twice. The
    /// cells are those of places up to `reach`, at most half the torus, away from a position along each axis. True if
    /// it was.
    template <typename What>
    bool any_row_around(const TorusPosition& position, std::uint64_t reach, const What& what) const
    {
        const auto [x, width] = range(position[0], reach);
        const auto [first_y, rows] = range(position[1], reach);
        const auto [first_z, layers] = dimension_ == 3 ? range(position[2], reach) : Range{0, 1};
        const std::int64_t before_end = std::min(width, size_ - x);
        const auto numbers = static_cast<std::int64_t>(numbers_);
        // Rows of more cells could have some in common.
        if (numbers > 0 && 4.0 * static_cast<double>(width) * static_cast<double>(rows) * static_cast<double>(layers) >=
                               static_cast<double>(numbers))
            return what(0, numbers);
        for (std::int64_t z = 0; z < layers; ++z)
            for (std::int64_t y = 0; y < rows; ++y) {
                if (numbers > 0) {
                    const std::int64_t from_z = dimension_ == 3 ? wrapped(first_z + z) : 0;
                    if (any_folded(x, wrapped(first_y + y), from_z, before_end, what)) return true;
                    if (before_end < width && any_folded(0, wrapped(first_y + y), from_z, width - before_end, what))
                        return true;
                    continue;
                }
                const std::int64_t layer = dimension_ == 3 ? wrapped(first_z + z) * size_ : 0;
                const std::int64_t row = (layer + wrapped(first_y + y)) * size_;
                if (what(row + x, row + x + before_end)) return true;
                if (before_end < width && what(row, row + width - before_end)) return true;
            }
        return false;
    }

private:
    std::size_t folded_number(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        // Parts of all numbers: the golden ratio, and that of the plastic number's square.
        const auto part = [this](double ratio) {
            return static_cast<std::uint64_t>(ratio * static_cast<double>(numbers_)) | 1;
        };
        const std::uint64_t row = static_cast<std::uint64_t>(y) * part(0.6180339887498949);
        const std::uint64_t layer = static_cast<std::uint64_t>(z) * part(0.5698402909980532);
        return (static_cast<std::uint64_t>(x) + row + layer) & (numbers_ - 1);
    }

    /// Calls what() for `width` cells of a row from one on: their numbers may begin anew in between.
    template <typename What>
    bool any_folded(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t width, const What& what) const
    {
        const auto first = static_cast<std::int64_t>(folded_number(x, y, z)), end = static_cast<std::int64_t>(numbers_);
        if (what(first, std::min(end, first + width))) return true;
        return first + width > end && what(0, first + width - end);
    }

    /// Cells along an axis, from one on around the torus.
    struct Range
    {
        std::int64_t first;
        std::int64_t count;
    };

    std::int64_t wrapped(std::int64_t along) const
    {
        return along < 0 ? along + size_ : along >= size_ ? along - size_ : along;
    }

    Range range(std::int64_t coordinate, std::uint64_t reach) const
    {
        const auto away = static_cast<std::int64_t>(reach);
        const std::int64_t first = (coordinate - away) * size_ >> 32; // rounded down, also below 0
        return {wrapped(first), std::min(size_, ((coordinate + away) * size_ >> 32) - first + 1)};
    }

    int dimension_;
    std::int64_t size_;         ///< cells along each axis
    std::uint64_t numbers_ = 0; ///< of folded cells: a power of two; 0: cells are not folded
};

// Points on a torus of 2^32 units a side, sorted by the cells of a grid, for methods that ask for many nearest points
// before they add any.

class SortedTorus
{
public:
    SortedTorus(std::span<const TorusPosition> points, int dimension);

    /// The squared distance of the nearest point, or that of any one that is at most `enough`; UINT64_MAX without
    /// points.
    std::uint64_t squared_nearest(const TorusPosition& position, std::uint64_t enough = 0) const;

    /// Positions that are asked for in the order of their cells find in caches what the ones before them have looked
    /// at.
    const TorusCells& cells() const { return cells_; }

private:
    std::uint64_t nearest_within(const TorusPosition& position, std::uint64_t reach) const;

    TorusCells cells_;
    std::vector<std::uint32_t> starts_; ///< the first point of each cell, and the end of the last
    std::vector<TorusPosition> points_; ///< sorted
};

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
