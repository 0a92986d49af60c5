#include "host/sampling/cells/point_grid.hpp"

#include "base/geometry/lattice.hpp"
#include "kernels/common/vectors.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace poissonlab {
namespace {

/// Cells that are scanned by a single work-item: more launches cost more than that.
constexpr std::size_t max_single_chunk = 32768;
constexpr std::uint32_t chunk_of_many = 1024;

/// Cells that one work-item scans.
std::uint32_t chunk_of(std::size_t cells)
{
    return cells <= max_single_chunk ? static_cast<std::uint32_t>(cells) : chunk_of_many;
}

}

NeededBuffers PointGrid::Buffers::needed(int dimension, std::size_t points, std::uint32_t cells_per_axis)
{
    const auto axes = static_cast<std::size_t>(dimension);
    const std::size_t cells = lattice_cells(cells_per_axis, dimension);
    return {{positions, points * axes},
            {unsorted_positions, points * axes},
            {ids, points},
            {unsorted_ids, points},
            {counts, cells},
            {starts, cells + 1},
            {totals, (cells + chunk_of(cells) - 1) / chunk_of(cells)},
            {point_cells, points},
            {places, points},
            {order, points},
            {fixed_point, (points + contract::vectors::PADDING) * axes}};
}

PointGrid::PointGrid(Device device, int dimension, std::size_t points, std::uint32_t cells_per_axis,
                     std::size_t work_group_size)
    : device_(std::move(device)), dimension_(dimension), size_(points), cells_per_axis_(cells_per_axis),
      cells_(lattice_cells(cells_per_axis, dimension)), work_group_size_(work_group_size), chunk_(chunk_of(cells_)),
      stride_(static_cast<std::uint32_t>(points) + contract::vectors::PADDING)
{
    reserve(device_, buffers_.needed(dimension, points, cells_per_axis));
    buffers_.fixed_point.write(std::vector<std::uint32_t>(buffers_.fixed_point.size()));
    buffers_.counts.write(std::vector<std::uint32_t>(cells_));

    const KernelProgram program = kernel_program("point_grid.cl", {{"DIMENSION", dimension}});
    count_ = device_.kernel(program, "count_points");
    scan_ = device_.kernel(program, "scan_counts");
    scan_totals_ = device_.kernel(program, "scan_totals");
    add_totals_ = device_.kernel(program, "add_totals");
    place_ = device_.kernel(program, "place_points");
    gather_ = device_.kernel(program, "gather_points");
}

void PointGrid::load(const PointSet& points)
{
    buffers_.positions.write(points.coordinates);
    std::vector<std::uint32_t> ids(size_);
    std::iota(ids.begin(), ids.end(), 0u);
    buffers_.ids.write(ids);
}

void PointGrid::sort()
{
    Buffers& b = buffers_;
    std::swap(b.positions, b.unsorted_positions);
    std::swap(b.ids, b.unsorted_ids);
    const auto points = static_cast<std::uint32_t>(size_);
    const auto cells = static_cast<std::uint32_t>(cells_);
    const auto chunks = static_cast<std::uint32_t>(b.totals.size());
    count_.run(size_, work_group_size_, b.unsorted_positions, points, cells_per_axis_, b.counts, b.point_cells,
               b.places);
    scan_.run(chunks, work_group_size_, b.counts, cells, chunk_, b.starts, b.totals);
    if (chunks > 1) {
        scan_totals_.run(1, 1, b.totals, chunks);
        add_totals_.run(cells_ + 1, work_group_size_, b.starts, cells, chunk_, b.totals);
    }
    place_.run(size_, work_group_size_, b.point_cells, b.places, points, b.starts, b.order);
    gather_.run(cells_, work_group_size_, b.unsorted_positions, b.unsorted_ids, cells, b.starts, b.order, b.positions,
                b.ids, b.fixed_point, stride_);
}

PointSet PointGrid::points() const
{
    const auto d = static_cast<std::size_t>(dimension_);
    const std::vector<double> sorted = buffers_.positions.read(0, size_ * d);
    const std::vector<std::uint32_t> ids = buffers_.ids.read(0, size_);
    PointSet set{dimension_, std::vector<double>(size_ * d)};
    for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t k = 0; k < d; ++k) set.coordinates[ids[i] * d + k] = sorted[i * d + k];
    }
    return set;
}

}
