// The cells of a grid of which only some are there: those where a long region is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

struct CellRows
{
    std::vector<std::uint32_t> row_starts; ///< the number of the first cell of each row, and the end
    std::vector<std::uint32_t> columns;    ///< of each cell; those of a row ascend

    /// The number of the first cell of a row that is not before a column, up to the end of the row.
    std::size_t number_of(std::size_t row, std::uint32_t column) const
    {
        const auto begin = columns.begin() + row_starts[row], end = columns.begin() + row_starts[row + 1];
        return static_cast<std::size_t>(std::lower_bound(begin, end, column) - columns.begin());
    }
};

/// Lists cells that have their rows in the upper halves and columns in the lower ones. They may come several times, in
/// any order.
inline CellRows cell_rows(std::vector<std::uint64_t> cells, std::size_t rows)
{
    std::ranges::sort(cells);
    cells.erase(std::ranges::unique(cells).begin(), cells.end());
    CellRows list{std::vector<std::uint32_t>(rows + 1), {}};
    for (const std::uint64_t cell : cells) {
        list.columns.push_back(static_cast<std::uint32_t>(cell));
        ++list.row_starts[(cell >> 32) + 1];
    }
    for (std::size_t row = 0; row < rows; ++row) list.row_starts[row + 1] += list.row_starts[row];
    return list;
}

}
