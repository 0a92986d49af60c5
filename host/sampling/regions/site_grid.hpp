// Sites in a region and the edges of its boundary, by the cells of a grid.
//
// Where the box of a region would be nearly empty, only those cells are listed that the region is in.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "host/sampling/cells/cell_rows.hpp"
#include "kernels/common/regions/region_lloyd.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

class SiteGrid
{
public:
    /// Makes a grid for so many sites, of all cells in the box or of listed ones. The region must outlive this.
    SiteGrid(const FixedRegion& region, std::size_t sites, bool is_listed = false);

    /// Sorts sites by cells, and in each by their numbers. They lie in the region's box.
    void sort(std::span<const TorusPoint<2>> sites);

    const contract::region_lloyd::SiteGrid& grid() const { return grid_; }

    /// Sorted sites have positions, numbers, and a mark that says whether they lie in the region when they are moved by
    /// (e^2, e).
    std::span<const TorusPoint<2>> sites() const { return sites_; }
    std::span<const std::uint32_t> numbers() const { return numbers_; }
    std::span<const std::uint8_t> is_inside() const { return is_inside_; }
    /// The number of the first cell of a row that is not before a column, up to the end of the row.
    std::size_t number_of_cell(std::uint32_t row, std::uint32_t column) const;
    std::uint32_t column_of(std::size_t cell, std::uint32_t row) const
    {
        return grid_.is_listed != 0 ? list_.columns[cell] : static_cast<std::uint32_t>(cell - first_of_row(row));
    }

    /// Listed cells of a row begin there, with their columns; without a list there is one value.
    std::span<const std::uint32_t> row_starts() const { return list_.row_starts; }
    std::span<const std::uint32_t> listed_columns() const { return list_.columns; }

    std::span<const std::uint32_t> starts() const { return starts_; } ///< the first site of each cell, and the end

    /// The boundary, with the region on the left; positions count from the grid's lowest one.
    std::span<const FixedEdge> edges() const { return edges_; }
    std::span<const std::uint32_t> edge_starts() const { return edge_starts_; }
    std::span<const std::uint32_t> edge_numbers() const { return edge_numbers_; }

    /// MAX_CLIPS words for each listed cell: the numbers of the edges beyond which the Voronoi cells of its sites are
    /// cut, then NO_CLIP.
    std::span<const std::uint32_t> clips() const { return clips_; }
    std::size_t clip_words() const { return grid_.is_listed != 0 ? cells() * contract::region_lloyd::MAX_CLIPS : 1; }
    /// The clips of the cell that has this position, which counts from the grid's lowest one.
    std::span<const std::uint32_t> clips_around(const TorusPoint<2>& position) const;

private:
    template <typename Body>
    void for_each_cell_of_edges(const Body& body) const;
    void list_cells();
    void list_edges();
    void find_filled();
    void find_clips();
    void find_clips_of(std::uint32_t row, std::size_t cell);
    bool ends_region(const FixedEdge& edge, std::span<const FixedEdge> edges, const std::array<double, 2>& low,
                     const std::array<double, 2>& high) const;
    double half_box() const;
    double half_box_of_listed() const;
    std::size_t cells() const
    {
        return grid_.is_listed != 0 ? list_.columns.size() : std::size_t{grid_.columns} * grid_.rows;
    }
    std::size_t first_of_row(std::uint32_t row) const { return std::size_t{row} * grid_.columns; }

    const FixedRegion& region_;
    contract::region_lloyd::SiteGrid grid_{};
    std::vector<TorusPoint<2>> sites_;
    std::vector<std::uint32_t> numbers_, starts_;
    std::vector<std::uint8_t> is_inside_;
    std::vector<FixedEdge> edges_;
    std::vector<std::uint32_t> edge_starts_, edge_numbers_;
    std::vector<std::uint8_t> is_filled_; ///< cells that are not outside
    CellRows list_{{0}, {0}};
    std::vector<std::uint32_t> clips_{contract::region_lloyd::NO_CLIP};
    double clip_reach_ = 0; ///< clips are valid in the square that reaches this far beyond a grid cell on each side
};

/// The grid's columns that an edge is in, and a little more, within a row.
std::array<std::uint32_t, 2> columns_of(const contract::region_lloyd::SiteGrid& grid, const FixedEdge& edge,
                                        std::uint32_t row);

}
