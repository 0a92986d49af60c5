#include "host/sampling/cells/point_grid.hpp"

#include "base/geometry/lattice.hpp"
#include "kernels/common/vectors.h"

#include <numeric>
#include <vector>

namespace poissonlab {
namespace {

/// Cells that are scanned by a single work-item: more launches cost more than that.
constexpr std::size_t max_single_chunk = 32768;
constexpr std::uint32_t chunk_of_many = 1024;

/// Points that one work-item of a processor sorts: more launches cost more than that.
constexpr std::size_t few_points = 1024;

/// Cells that one work-item scans.
std::uint32_t chunk_of(std::size_t cells)
{
    return cells <= max_single_chunk ? static_cast<std::uint32_t>(cells) : chunk_of_many;
}

std::size_t chunks_of(std::size_t cells) { return (cells + chunk_of(cells) - 1) / chunk_of(cells); }

}

GridPart whole_grid(std::uint32_t cells_per_axis, int dimension)
{
    return layers_of_grid(cells_per_axis, dimension, 0, cells_per_axis, 0);
}

GridPart layers_of_grid(std::uint32_t cells_per_axis, int dimension, std::uint32_t first, std::uint32_t end,
                        std::uint32_t around)
{
    const auto layer = static_cast<std::uint32_t>(lattice_cells(cells_per_axis, dimension - 1));
    const std::uint64_t held = end - first + std::uint64_t{2} * around;
    const bool is_whole = held >= cells_per_axis;
    const std::uint32_t first_held = is_whole ? 0 : (first >= around ? first : first + cells_per_axis) - around;
    return {.grid_size = cells_per_axis,
            .cells = layer * cells_per_axis,
            .first = layer * first_held,
            .held = layer * (is_whole ? cells_per_axis : static_cast<std::uint32_t>(held)),
            .own_first = layer * first,
            .own_end = layer * end};
}

GridPart listed_grid(std::uint32_t cells_per_axis, std::uint32_t listed)
{
    return {
        .grid_size = cells_per_axis, .cells = listed, .first = 0, .held = listed, .own_first = 0, .own_end = listed};
}

std::size_t PointGrid::rows_of(std::uint32_t cells_per_axis, int dimension)
{
    return static_cast<std::size_t>(lattice_cells(cells_per_axis, dimension - 1));
}

NeededBuffers PointGrid::Buffers::needed(int dimension, std::size_t points, const GridPart& part,
                                         std::size_t listed_rows)
{
    const auto axes = static_cast<std::size_t>(dimension);
    const std::size_t cells = part.held;
    NeededBuffers all{{positions, points * axes},
                      {unsorted_positions, points * axes},
                      {ids, points},
                      {unsorted_ids, points},
                      {counts, cells},
                      {starts, cells + 1},
                      {totals, chunks_of(cells)},
                      {point_cells, points},
                      {places, points},
                      {order, points},
                      {fixed_point, (points + contract::vectors::PADDING) * axes}};
    if (listed_rows > 0) {
        all.push_back({row_starts, listed_rows + 1});
        all.push_back({columns, cells});
    }
    return all;
}

PointGrid::PointGrid(Device device, int dimension, std::size_t points, const GridPart& part,
                     std::size_t work_group_size)
    : PointGrid(std::move(device), dimension, points, part, nullptr, work_group_size)
{}

PointGrid::PointGrid(Device device, int dimension, std::size_t points, std::uint32_t cells_per_axis,
                     const CellRows& cells, std::size_t work_group_size)
    : PointGrid(std::move(device), dimension, points,
                listed_grid(cells_per_axis, static_cast<std::uint32_t>(cells.columns.size())), &cells, work_group_size)
{}

PointGrid::PointGrid(Device device, int dimension, std::size_t points, const GridPart& part, const CellRows* cells,
                     std::size_t work_group_size)
    : device_(std::move(device)), dimension_(dimension), size_(points), part_(part), is_listed_(cells != nullptr),
      work_group_size_(work_group_size), stride_(static_cast<std::uint32_t>(points) + contract::vectors::PADDING)
{
    reserve(device_, buffers_.needed(dimension, points, part, is_listed_ ? rows_of(part.grid_size, dimension) : 0));
    if (is_listed_) {
        buffers_.row_starts.write(cells->row_starts);
        buffers_.columns.write(cells->columns);
    }
    buffers_.fixed_point.write(std::vector<std::uint32_t>(buffers_.fixed_point.size()));
    buffers_.counts.write(std::vector<std::uint32_t>(part.held));

    const KernelProgram program = kernel_program(
        "point_grid.cl", {{"DIMENSION", dimension}, doubles_of(device_), {"LISTED", is_listed_ ? 1 : 0}});
    count_ = device_.kernel(program, "count_points");
    scan_ = device_.kernel(program, "scan_counts");
    scan_totals_ = device_.kernel(program, "scan_totals");
    add_totals_ = device_.kernel(program, "add_totals");
    place_ = device_.kernel(program, "place_points");
    gather_ = device_.kernel(program, "gather_points");
    sort_few_ = device_.kernel(program, "sort_few");
}

void PointGrid::load(const PointSet& points)
{
    buffers_.positions.write(points.coordinates);
    std::vector<std::uint32_t> ids(size_);
    std::iota(ids.begin(), ids.end(), 0u);
    buffers_.ids.write(ids);
}

void PointGrid::clear(const GridPart& part)
{
    size_ = 0;
    part_ = part;
}

void PointGrid::add(std::span<const double> coordinates, std::span<const std::uint32_t> ids)
{
    buffers_.positions.write(coordinates, size_ * static_cast<std::size_t>(dimension_));
    buffers_.ids.write(ids, size_);
    size_ += ids.size();
}

std::pair<std::size_t, std::size_t> PointGrid::own_points() const
{
    const std::uint32_t own = part_.own_end - part_.own_first;
    if (own == part_.cells) return {0, size_};
    const std::uint32_t place = part_.own_first - part_.first + (part_.own_first < part_.first ? part_.cells : 0);
    return {buffers_.starts.read(place, 1)[0], buffers_.starts.read(place + own, 1)[0]};
}

void PointGrid::sort()
{
    Buffers& b = buffers_;
    std::swap(b.positions, b.unsorted_positions);
    std::swap(b.ids, b.unsorted_ids);
    const auto points = static_cast<std::uint32_t>(size_);
    const std::uint32_t cells = part_.held;
    const auto run_with_list = [&](Kernel& kernel, std::size_t items, std::size_t group, const auto&... arguments) {
        if (is_listed_)
            kernel.run(items, group, arguments..., b.row_starts, b.columns);
        else
            kernel.run(items, group, arguments...);
    };
    if (size_ <= few_points && cells <= few_points && device_.info().type == "CPU") {
        run_with_list(sort_few_, 1, 1, b.unsorted_positions, b.unsorted_ids, points, part_, b.counts, b.point_cells,
                      b.starts, b.order, b.positions, b.ids, b.fixed_point, stride_);
        return;
    }
    const std::uint32_t chunk = chunk_of(cells);
    const auto chunks = static_cast<std::uint32_t>(chunks_of(cells));
    run_with_list(count_, size_, work_group_size_, b.unsorted_positions, points, part_, b.counts, b.point_cells,
                  b.places);
    scan_.run(chunks, work_group_size_, b.counts, cells, chunk, b.starts, b.totals);
    if (chunks > 1) {
        scan_totals_.run(1, 1, b.totals, chunks);
        add_totals_.run(std::size_t{cells} + 1, work_group_size_, b.starts, cells, chunk, b.totals);
    }
    place_.run(size_, work_group_size_, b.point_cells, b.places, points, b.starts, b.order);
    gather_.run(cells, work_group_size_, b.unsorted_positions, b.unsorted_ids, cells, b.starts, b.order, b.positions,
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
