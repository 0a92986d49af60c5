// The neighbours of cells of a grid that has only some of its cells.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace poissonlab {

/// This stands for a cell that the grid has not got.
inline constexpr std::uint32_t no_cell_around = 0x7fffffff;

/// For each cell, the numbers of those around it, itself among them: 3^D of them, x fastest. `cells` are different
/// ones, by their coordinates, below 2^32 - 1. Grids do not wrap around.
template <std::size_t D>
std::vector<std::uint32_t> numbers_around(const std::vector<std::array<std::uint32_t, D>>& cells)
{
    constexpr std::size_t rows = D == 2 ? 3 : 9;
    using Cell = std::array<std::uint32_t, D>;
    const auto comes_before = [](const Cell& a, const Cell& b) {
        return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    };
    std::vector<std::uint32_t> order(cells.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return comes_before(cells[a], cells[b]); });
    std::vector<std::uint32_t> around(3 * rows * cells.size(), no_cell_around);
    // Cells that are moved by a row come in the same order.
    for (std::size_t row = 0; row < rows; ++row) {
        std::size_t first = 0;
        for (const std::uint32_t number : order) {
            Cell left = cells[number];
            bool is_outside = false;
            for (std::size_t k = 1, digits = row; k < D; ++k, digits /= 3) {
                is_outside |= left[k] == 0 && digits % 3 == 0;
                left[k] += static_cast<std::uint32_t>(digits % 3) - 1;
            }
            if (is_outside) continue;
            const std::uint32_t x = left[0];
            left[0] -= x > 0;
            while (first < order.size() && comes_before(cells[order[first]], left)) ++first;
            for (std::size_t i = first; i < order.size(); ++i) {
                const Cell& cell = cells[order[i]];
                if (cell[0] > x + 1 || !std::equal(left.begin() + 1, left.end(), cell.begin() + 1)) break;
                around[3 * (rows * number + row) + cell[0] + 1 - x] = order[i];
            }
        }
    }
    return around;
}

}
