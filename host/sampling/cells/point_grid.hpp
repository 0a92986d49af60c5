// Points on a device, sorted by the cells of a grid so that neighbours are found nearby. Runs
// kernels/point_grid.cl.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/device/needed_buffers.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace poissonlab {

class PointGrid
{
public:
    /// Room for so many points on a grid of cells_per_axis^dimension cells. `work_group_size` > 0.
    PointGrid(Device device, int dimension, std::size_t points, std::uint32_t cells_per_axis,
              std::size_t work_group_size);

    /// The memory that such a grid takes.
    static DeviceMemory memory(int dimension, std::size_t points, std::uint32_t cells_per_axis)
    {
        return memory_of(Buffers{}.needed(dimension, points, cells_per_axis));
    }

    /// Replaces all points; ids count from 0. Not sorted yet.
    void load(const PointSet& points);

    /// Enqueues sorting.
    void sort();

    /// The points in order of their ids, coordinates in [0, 1).
    PointSet points() const;

    std::size_t size() const { return size_; }
    std::size_t cells() const { return cells_; }
    std::uint32_t cells_per_axis() const { return cells_per_axis_; }

    /// dimension values a point, in sorted order.
    Buffer<double>& positions() { return buffers_.positions; }
    const Buffer<std::uint32_t>& ids() const { return buffers_.ids; }
    /// The first point of each cell, and the end of the last.
    const Buffer<std::uint32_t>& starts() const { return buffers_.starts; }
    /// Coordinates in units of 2^-32, rounded down: an array of stride() words for each axis.
    const Buffer<std::uint32_t>& fixed_point() const { return buffers_.fixed_point; }
    std::uint32_t stride() const { return stride_; }

private:
    struct Buffers
    {
        Buffer<double> positions, unsorted_positions;
        Buffer<std::uint32_t> ids, unsorted_ids;
        Buffer<std::uint32_t> counts, starts, totals, point_cells, places, order, fixed_point;

        NeededBuffers needed(int dimension, std::size_t points, std::uint32_t cells_per_axis);
    };

    Device device_;
    int dimension_;
    std::size_t size_;
    std::uint32_t cells_per_axis_;
    std::size_t cells_;
    std::size_t work_group_size_;
    std::uint32_t chunk_;  ///< cells that one work-item of scan_counts owns
    std::uint32_t stride_; ///< with room for a vector read at the last point
    Buffers buffers_;
    Kernel count_, scan_, scan_totals_, add_totals_, place_, gather_;
};

}
