// Points on a device, sorted by the cells of a grid so that neighbours are found nearby. Runs
// kernels/point_grid.cl.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/cell_rows.hpp"
#include "kernels/common/grid_part.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace poissonlab {

using contract::grid_part::GridPart;

/// All cells of a grid.
GridPart whole_grid(std::uint32_t cells_per_axis, int dimension);

/// The layers `first` to `end` - 1 of a grid along the last axis, to be asked about, and so many around them on both
/// sides: the whole grid where these meet.
GridPart layers_of_grid(std::uint32_t cells_per_axis, int dimension, std::uint32_t first, std::uint32_t end,
                        std::uint32_t around);

/// All of so many listed cells of a grid.
GridPart listed_grid(std::uint32_t cells_per_axis, std::uint32_t listed);

class PointGrid
{
public:
    /// Room for so many points on a grid of cells_per_axis^dimension cells. `work_group_size` > 0.
    PointGrid(Device device, int dimension, std::size_t points, std::uint32_t cells_per_axis,
              std::size_t work_group_size)
        : PointGrid(std::move(device), dimension, points, whole_grid(cells_per_axis, dimension), work_group_size)
    {}

    /// Room for so many points on a part of a grid. `work_group_size` > 0.
    PointGrid(Device device, int dimension, std::size_t points, const GridPart& part, std::size_t work_group_size);

    /// Room for so many points, which never leave the listed cells of a grid. `work_group_size` > 0.
    PointGrid(Device device, int dimension, std::size_t points, std::uint32_t cells_per_axis, const CellRows& cells,
              std::size_t work_group_size);

    /// The memory that such a grid takes.
    static DeviceMemory memory(int dimension, std::size_t points, std::uint32_t cells_per_axis)
    {
        return memory(dimension, points, whole_grid(cells_per_axis, dimension));
    }
    static DeviceMemory memory(int dimension, std::size_t points, const GridPart& part)
    {
        return memory_of(Buffers{}.needed(dimension, points, part, 0));
    }
    static DeviceMemory memory_of_listed(int dimension, std::size_t points, std::uint32_t cells_per_axis,
                                         std::uint32_t listed)
    {
        const GridPart part = listed_grid(cells_per_axis, listed);
        return memory_of(Buffers{}.needed(dimension, points, part, rows_of(cells_per_axis, dimension)));
    }

    /// Replaces all points; ids count from 0. Not sorted yet.
    void load(const PointSet& points);

    /// Replaces all points by none, and the part of the grid by another one of it.
    void clear(const GridPart& part);

    /// Adds points that are in this part, dimension values and an id each, as far as there is room. Not sorted yet.
    void add(std::span<const double> coordinates, std::span<const std::uint32_t> ids);

    /// Enqueues sorting.
    void sort();

    /// The points in order of their ids, coordinates in [0, 1).
    PointSet points() const;

    std::size_t size() const { return size_; }
    std::size_t cells() const { return part_.held; }
    std::uint32_t cells_per_axis() const { return part_.grid_size; }
    const GridPart& part() const { return part_; }

    /// The first of the sorted points in cells that are asked about, and the end of these.
    std::pair<std::size_t, std::size_t> own_points() const;

    /// dimension values a point, in sorted order.
    Buffer<double>& positions() { return buffers_.positions; }
    const Buffer<std::uint32_t>& ids() const { return buffers_.ids; }
    /// The first point of each cell, and the end of the last.
    const Buffer<std::uint32_t>& starts() const { return buffers_.starts; }
    /// Coordinates in units of 2^-32, rounded down: an array of stride() words for each axis.
    const Buffer<std::uint32_t>& fixed_point() const { return buffers_.fixed_point; }
    std::uint32_t stride() const { return stride_; }

    /// The listed cells, as a CellRows has them.
    const Buffer<std::uint32_t>& row_starts() const { return buffers_.row_starts; }
    const Buffer<std::uint32_t>& columns() const { return buffers_.columns; }

private:
    struct Buffers
    {
        Buffer<double> positions, unsorted_positions;
        Buffer<std::uint32_t> ids, unsorted_ids;
        Buffer<std::uint32_t> counts, starts, totals, point_cells, places, order, fixed_point;
        Buffer<std::uint32_t> row_starts, columns;

        /// `listed_rows`: those of a grid whose cells are listed; 0: all are there.
        NeededBuffers needed(int dimension, std::size_t points, const GridPart& part, std::size_t listed_rows);
    };

    static std::size_t rows_of(std::uint32_t cells_per_axis, int dimension);
    PointGrid(Device device, int dimension, std::size_t points, const GridPart& part, const CellRows* cells,
              std::size_t work_group_size);

    Device device_;
    int dimension_;
    std::size_t size_;
    GridPart part_;
    bool is_listed_;
    std::size_t work_group_size_;
    std::uint32_t stride_; ///< with room for a vector read at the last point
    Buffers buffers_;
    Kernel count_, scan_, scan_totals_, add_totals_, place_, gather_, sort_few_;
};

}
