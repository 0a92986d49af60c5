// The nodes of tapers: a grid over a region's box, of which only the nodes inside the region are stored.
#pragma once

#include "analysis/regions/framed_region.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// A node that is not there.
inline constexpr std::size_t no_node = static_cast<std::size_t>(-1);

class TaperGrid
{
public:
    /// Divides the box into so many columns and rows. A node is stored if no edge crosses the cells around it and all
    /// of them are inside. The cost grows with the rows, the cells that the boundary crosses, and the nodes.
    TaperGrid(const FramedRegion& region, const std::array<std::size_t, 2>& cells);

    const std::array<std::size_t, 2>& cells() const { return cells_; }

    /// The sides of a cell, in the frame.
    const std::array<double, 2>& step() const { return step_; }

    /// Nodes are numbered row by row.
    std::size_t size() const { return columns_.size(); }
    std::size_t rows() const { return cells_[1] + 1; } ///< the first and the last one have no nodes
    std::size_t row_begin(std::size_t row) const { return row_begins_[row]; }
    std::uint32_t column(std::size_t node) const { return columns_[node]; }

    /// The number of the node at a crossing of lines, or no_node.
    std::size_t number(std::size_t column, std::size_t row) const;

private:
    std::array<std::size_t, 2> cells_{};
    std::array<double, 2> step_{};
    std::vector<std::uint32_t> columns_;
    std::vector<std::size_t> row_begins_;
};

}
