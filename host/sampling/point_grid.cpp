#include "host/sampling/point_grid.hpp"

#include "base/geometry/lattice.hpp"

#include <cmath>
#include <numeric>
#include <vector>

namespace poissonlab {
namespace {

/// Cells that are scanned by a single work-item: more launches cost more than that.
constexpr std::size_t max_single_chunk = 32768;
constexpr std::uint32_t chunk_of_many = 1024;

/// Kernels read whole vectors.
constexpr std::uint32_t padding = 16;

/// Cells that one work-item scans.
std::uint32_t chunk_of(std::size_t cells)
{
    return cells <= max_single_chunk ? static_cast<std::uint32_t>(cells) : chunk_of_many;
}

}

DeviceMemory PointGrid::memory(int dimension, std::size_t points, std::uint32_t cells_per_axis)
{
    const auto axes = static_cast<std::uint64_t>(dimension);
    const std::uint64_t cells = lattice_cells(cells_per_axis, dimension);
    DeviceMemory memory;
    for (int i = 0; i < 2; ++i) { // before and after sorting
        memory.add_buffer<double>(points * axes);
        memory.add_buffer<std::uint32_t>(points);
    }
    memory.add_buffer<std::uint32_t>(cells).add_buffer<std::uint32_t>(cells + 1);
    memory.add_buffer<std::uint32_t>((cells + chunk_of(cells) - 1) / chunk_of(cells));
    for (int i = 0; i < 3; ++i) memory.add_buffer<std::uint32_t>(points); // cells, places, order
    return memory.add_buffer<std::uint32_t>((points + padding) * axes);
}

PointGrid::PointGrid(Device device, int dimension, std::size_t points, std::uint32_t cells_per_axis,
                     std::size_t work_group_size)
    : device_(std::move(device)), dimension_(dimension), size_(points), cells_per_axis_(cells_per_axis),
      cells_(lattice_cells(cells_per_axis, dimension)), work_group_size_(work_group_size), chunk_(chunk_of(cells_)),
      stride_(static_cast<std::uint32_t>(points) + padding)
{
    const std::size_t values = points * static_cast<std::size_t>(dimension);
    positions_ = device_.buffer<double>(values);
    unsorted_positions_ = device_.buffer<double>(values);
    ids_ = device_.buffer<std::uint32_t>(points);
    unsorted_ids_ = device_.buffer<std::uint32_t>(points);
    counts_ = device_.buffer<std::uint32_t>(cells_);
    starts_ = device_.buffer<std::uint32_t>(cells_ + 1);
    totals_ = device_.buffer<std::uint32_t>((cells_ + chunk_ - 1) / chunk_);
    point_cells_ = device_.buffer<std::uint32_t>(points);
    places_ = device_.buffer<std::uint32_t>(points);
    order_ = device_.buffer<std::uint32_t>(points);
    fixed_point_ = device_.buffer<std::uint32_t>(stride_ * static_cast<std::size_t>(dimension));
    fixed_point_.write(std::vector<std::uint32_t>(fixed_point_.size()));
    counts_.write(std::vector<std::uint32_t>(cells_));

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
    positions_.write(points.coordinates);
    std::vector<std::uint32_t> ids(size_);
    std::iota(ids.begin(), ids.end(), 0u);
    ids_.write(ids);
}

void PointGrid::sort()
{
    std::swap(positions_, unsorted_positions_);
    std::swap(ids_, unsorted_ids_);
    const auto points = static_cast<std::uint32_t>(size_);
    const auto cells = static_cast<std::uint32_t>(cells_);
    const auto chunks = static_cast<std::uint32_t>(totals_.size());
    count_.run(size_, work_group_size_, unsorted_positions_, points, cells_per_axis_, counts_, point_cells_, places_);
    scan_.run(chunks, work_group_size_, counts_, cells, chunk_, starts_, totals_);
    if (chunks > 1) {
        scan_totals_.run(1, 1, totals_, chunks);
        add_totals_.run(cells_ + 1, work_group_size_, starts_, cells, chunk_, totals_);
    }
    place_.run(size_, work_group_size_, point_cells_, places_, points, starts_, order_);
    gather_.run(cells_, work_group_size_, unsorted_positions_, unsorted_ids_, cells, starts_, order_, positions_, ids_,
                fixed_point_, stride_);
}

PointSet PointGrid::points() const
{
    const auto d = static_cast<std::size_t>(dimension_);
    const std::vector<double> sorted = positions_.read(0, size_ * d);
    const std::vector<std::uint32_t> ids = ids_.read(0, size_);
    PointSet set{dimension_, std::vector<double>(size_ * d)};
    for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t k = 0; k < d; ++k) set.coordinates[ids[i] * d + k] = sorted[i * d + k];
    }
    return set;
}

}
