#include "host/sampling/cells/voronoi_cells.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Work-items that share the sites of the slow way. There are few such sites in few points, and each work-item costs
/// something even where it has none.
std::size_t slow_items(std::size_t points) { return points < 8192 ? 16 : 256; }

/// Grid cells in a row whose sites a work-item of the 2D kernel takes together: enough to fill batches of sites, and
/// few enough for all threads to have some. Elsewhere than on CPUs, threads are worth more than full batches.
constexpr std::uint32_t cells_a_run_on_cpus = 64;

/// The cells of a run on a processor: no more than it takes for all threads to have work.
std::uint32_t cells_a_run(std::uint32_t cells, std::uint32_t threads)
{
    constexpr std::uint32_t least = 8; // else batches are never full
    return std::clamp((cells + threads - 1) / threads, least, cells_a_run_on_cpus);
}

/// Work-items of a group are then few, or groups would be.
constexpr std::size_t most_runs_a_group_on_cpus = 1;
constexpr std::size_t most_runs_a_group_elsewhere = 8;

/// Mean number of points in a cell of the grid: more mean more points to look at, fewer more cells that do
/// not hold all Voronoi neighbours among their surroundings.
double points_per_cell(int dimension) { return dimension == 2 ? 2.6 : 1.0; }

}

std::uint32_t VoronoiKernels::cells_per_axis(int dimension, std::size_t points)
{
    const double cells = static_cast<double>(points) / points_per_cell(dimension);
    return std::max(1u, static_cast<std::uint32_t>(dimension == 2 ? std::sqrt(cells) : std::cbrt(cells)));
}

NeededBuffers VoronoiKernels::Buffers::needed(int dimension, std::size_t points)
{
    return {{volumes, points},  {displacements, points * static_cast<std::size_t>(dimension)},
            {energies, points}, {squared_near, points},
            {slow, points},     {slow_count, 1},
            {unknown, 1}};
}

VoronoiKernels::VoronoiKernels(Device device, int dimension, std::size_t points, std::size_t work_group_size)
    : dimension_(dimension), threads_(device.info().type == "CPU" ? device.info().compute_units : 0),
      runs_a_group_(std::min(work_group_size,
                             device.info().type == "CPU" ? most_runs_a_group_on_cpus : most_runs_a_group_elsewhere)),
      work_group_size_(work_group_size)
{
    reserve(device, buffers_.needed(dimension, points));
    const KernelProgram in_plane = kernel_program("voronoi_2d.cl", {doubles_of(device)});
    const KernelProgram fast = dimension == 2 ? in_plane : kernel_program("voronoi_3d_fast.cl", {});
    const KernelProgram slow = dimension == 2 ? in_plane : kernel_program("voronoi_3d_slow.cl", {});
    forget_slow_ = device.kernel(slow, "forget_slow");
    find_fast_ = device.kernel(fast, "find_centroids_fast");
    find_slow_ = device.kernel(slow, "find_centroids");
}

void VoronoiKernels::find_cells(PointGrid& grid)
{
    const GridPart& part = grid.part();
    const std::uint32_t own = part.own_end - part.own_first;
    const float margin = std::nextafter(static_cast<float>(0x1p32 / part.grid_size), 0.0f);
    const Buffers& b = buffers_;
    forget_slow_.run(1, 1, b.slow_count, b.unknown);
    if (dimension_ == 2) {
        const std::uint32_t run = threads_ > 0 ? cells_a_run(own, threads_) : 1;
        const std::size_t runs = (own + run - 1) / run;
        find_fast_.run(runs, runs_a_group_, grid.positions(), grid.fixed_point(), grid.stride(), grid.starts(), part,
                       margin, run, b.volumes, b.displacements, b.energies, b.squared_near, b.slow, b.slow_count);
    } else {
        find_fast_.run(own, work_group_size_, grid.positions(), grid.fixed_point(), grid.stride(), grid.starts(), part,
                       margin, b.volumes, b.displacements, b.energies, b.squared_near, b.slow, b.slow_count);
    }
    find_slow_.run(slow_items(grid.size()), 1, grid.positions(), grid.ids(), grid.starts(), part, b.slow, b.slow_count,
                   b.volumes, b.displacements, b.energies, b.squared_near, b.unknown);
}

DeviceMemory voronoi_memory(int dimension, std::size_t points)
{
    return PointGrid::memory(dimension, points, VoronoiKernels::cells_per_axis(dimension, points)) +
           VoronoiKernels::memory(dimension, points);
}

VoronoiCells voronoi_cells(Device device, const PointSet& points, std::size_t work_group_size)
{
    const std::size_t n = points.size();
    const auto d = static_cast<std::size_t>(points.dimension);
    PointGrid grid(device, points.dimension, n, VoronoiKernels::cells_per_axis(points.dimension, n), work_group_size);
    VoronoiKernels kernels(device, points.dimension, n, work_group_size);
    grid.load(points);
    grid.sort();
    kernels.find_cells(grid);

    const std::vector<std::uint32_t> ids = grid.ids().read(0, n);
    const auto by_id = [&](const Buffer<double>& sorted, std::size_t values) {
        const std::vector<double> read = sorted.read(0, n * values);
        std::vector<double> result(n * values);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < values; ++k) result[ids[i] * values + k] = read[i * values + k];
        }
        return result;
    };
    return {points.dimension, by_id(kernels.volumes(), 1), by_id(kernels.displacements(), d),
            by_id(kernels.energies(), 1), by_id(kernels.squared_near(), 1)};
}

}
