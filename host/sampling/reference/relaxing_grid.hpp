// Darts one by one, and the points among which they fall, for methods whose minimum distance shrinks as they go on.
#pragma once

#include "base/geometry/torus.hpp"
#include "base/random/random.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace poissonlab::reference {

/// The darts of a stream, one after the other.
template <int D>
class Darts
{
public:
    explicit Darts(const StreamKey& stream) : stream_(stream) { size_.fill(std::uint64_t{1} << 32); }

    /// The darts fall into a box: FixedBox or FixedSpaceBox.
    template <typename Box>
    Darts(const StreamKey& stream, const Box& box) : stream_(stream)
    {
        low_ = box.low;
        for (std::size_t k = 0; k < D; ++k) size_[k] = std::uint64_t{box.high[k]} - box.low[k] + 1;
    }

    /// The darts fall into squares 2^shift positions wide, whose lowest corners these are.
    Darts(const StreamKey& stream, std::vector<TorusPoint<D>> corners, int shift)
        : stream_(stream), corners_(std::move(corners)), shift_(shift)
    {}

    std::uint64_t thrown() const { return thrown_; }

    TorusPoint<D> next()
    {
        constexpr std::uint64_t darts_a_block = 4 / D;
        const std::uint64_t place = thrown_ % darts_a_block;
        if (place == 0) {
            const std::uint64_t block = thrown_ / darts_a_block;
            words_ =
                philox({static_cast<std::uint32_t>(block), static_cast<std::uint32_t>(block >> 32), 0, 0}, stream_);
        }
        ++thrown_;
        if (!corners_.empty()) return in_square(place);
        TorusPoint<D> dart;
        for (std::size_t k = 0; k < D; ++k) {
            const std::uint64_t word = words_[place * D + k];
            dart[k] = low_[k] + static_cast<std::uint32_t>(word * size_[k] >> 32);
        }
        return dart;
    }

private:
    /// The first word says which square it is, and where in it along x.
    TorusPoint<D> in_square(std::uint64_t place) const
    {
        std::uint64_t first = words_[place * D] * std::uint64_t{corners_.size()};
        TorusPoint<D> dart = corners_[first >> 32];
        for (std::size_t k = 0; k < D; ++k) {
            const std::uint64_t word = k == 0 ? first & UINT32_MAX : words_[place * D + k];
            dart[k] += static_cast<std::uint32_t>(word << shift_ >> 32);
        }
        return dart;
    }

    StreamKey stream_;
    std::vector<TorusPoint<D>> corners_; ///< of squares; none: darts fall into a box
    int shift_ = 0;
    TorusPoint<D> low_{};
    std::array<std::uint64_t, D> size_{};
    std::array<std::uint32_t, 4> words_{};
    std::uint64_t thrown_ = 0;
};

/// Points in cells at least as wide as the minimum distance, so that a conflict is at most one cell away.
template <int D>
class RelaxingGrid
{
public:
    /// `points` is looked at in every call; the grid only keeps numbers.
    /// Where points are in a small part of the torus, cells are folded: see TorusCells.
    RelaxingGrid(const std::vector<TorusPoint<D>>& points, std::size_t expected_points, bool is_folded = false)
        : points_(points), is_folded_(is_folded), next_(expected_points)
    {}

    /// Makes cells for a minimum distance, and for those that are smaller by less than a half.
    void fit(double min_distance)
    {
        if (!heads_.empty() && 2 * min_distance * size_ > 1) return;
        // More cells than points are of no use.
        const double most = is_folded_ ? 0x1p31 : std::pow(2.0 * static_cast<double>(next_.size()), 1.0 / D);
        const auto size = static_cast<std::uint32_t>(std::max(1.0, std::min(most, 0.999999 / min_distance)));
        if (size == size_) return;
        size_ = size;
        std::size_t cells = 1;
        for (int k = 0; k < D; ++k) cells *= size;
        heads_.assign(is_folded_ ? std::bit_ceil(2 * next_.size()) : cells, none);
        for (std::uint32_t i = 0; i < points_.size(); ++i) insert(i);
    }

    void insert(std::uint32_t number)
    {
        std::uint32_t& head = heads_[index(cell_of(points_[number]))];
        next_[number] = head;
        head = number;
    }

    bool conflicts(const TorusPoint<D>& dart, std::uint64_t squared_min_distance) const
    {
        const Cell cell = cell_of(dart);
        // Most darts that fail do so here.
        if (conflicts_in(index(cell), dart, squared_min_distance)) return true;
        constexpr int neighbours = D == 2 ? 9 : 27;
        for (int n = 0; n < neighbours; ++n) {
            Cell other = cell;
            for (int k = 0, digits = n; k < D; ++k, digits /= 3) {
                if (digits % 3 == 1) other[k] = cell[k] == 0 ? size_ - 1 : cell[k] - 1;
                if (digits % 3 == 2) other[k] = cell[k] == size_ - 1 ? 0 : cell[k] + 1;
            }
            if (n > 0 && conflicts_in(index(other), dart, squared_min_distance)) return true;
        }
        return false;
    }

private:
    using Cell = std::array<std::uint32_t, D>;
    static constexpr std::uint32_t none = UINT32_MAX;

    Cell cell_of(const TorusPoint<D>& point) const
    {
        Cell cell;
        for (int k = 0; k < D; ++k) cell[k] = static_cast<std::uint32_t>((std::uint64_t{point[k]} * size_) >> 32);
        return cell;
    }

    std::size_t index(const Cell& cell) const
    {
        if (is_folded_) return folded_index(cell);
        std::size_t result = 0;
        for (int k = D - 1; k >= 0; --k) result = result * size_ + cell[k];
        return result;
    }

    /// Multiples of odd numbers that are the golden ratio of all, and another one.
    std::size_t folded_index(const Cell& cell) const
    {
        constexpr std::array<double, 2> ratios{0.6180339887498949, 0.5698402909980532};
        std::uint64_t result = cell[0];
        for (std::size_t k = 1; k < D; ++k)
            result += cell[k] * (static_cast<std::uint64_t>(ratios[k - 1] * static_cast<double>(heads_.size())) | 1);
        return result & (heads_.size() - 1);
    }

    bool conflicts_in(std::size_t cell, const TorusPoint<D>& dart, std::uint64_t squared_min_distance) const
    {
        for (std::uint32_t i = heads_[cell]; i != none; i = next_[i]) {
            if (squared_distance<D>(points_[i], dart) < squared_min_distance) return true;
        }
        return false;
    }

    const std::vector<TorusPoint<D>>& points_;
    bool is_folded_;
    std::uint32_t size_ = 0;           ///< cells along each axis
    std::vector<std::uint32_t> heads_; ///< the first point of each cell's chain
    std::vector<std::uint32_t> next_;  ///< the next point after each point
};

}
