// Runs kernels/power_cells.cl.
#include "host/sampling/optimized/power_cells.hpp"

#include "host/device/kernel.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "kernels/common/optimized/power_cells.h"

#include <algorithm>
#include <cmath>

namespace poissonlab {

using contract::power_cells::MAX_NEIGHBORS;

namespace {

constexpr double points_per_power_cell = 1.5;

/// The number of values of largest_weights().
std::size_t largest_weight_count(std::uint32_t grid_size)
{
    std::size_t count = 0, blocks = grid_size;
    for (int level = 1; level == 1 || blocks >= 3; ++level) {
        blocks = std::max<std::size_t>(grid_size >> level, 1);
        count += blocks * blocks;
    }
    return count;
}

/// The largest value of each of count x count, and of those around it on the torus.
std::vector<double> largest_around(const std::vector<double>& values, std::size_t count)
{
    std::vector<double> in_rows(values.size()), largest(values.size());
    const auto before = [&](std::size_t i) { return i > 0 ? i - 1 : count - 1; };
    const auto after = [&](std::size_t i) { return i + 1 < count ? i + 1 : 0; };
    for (std::size_t y = 0; y < count; ++y)
        for (std::size_t x = 0; x < count; ++x)
            in_rows[y * count + x] =
                std::max({values[y * count + before(x)], values[y * count + x], values[y * count + after(x)]});
    for (std::size_t y = 0; y < count; ++y)
        for (std::size_t x = 0; x < count; ++x)
            largest[y * count + x] =
                std::max({in_rows[before(y) * count + x], in_rows[y * count + x], in_rows[after(y) * count + x]});
    return largest;
}

/// Lists the weights that the kernel's is_beyond_all() reads. Blocks at the end of a row have what is left of it.
std::vector<double> largest_weights(const PointSet& points, const std::vector<double>& weights, std::uint32_t grid_size)
{
    const auto cell = [&](double coordinate) {
        return std::min(static_cast<std::size_t>(coordinate * grid_size), std::size_t{grid_size} - 1);
    };
    std::size_t count = std::max(1u, grid_size / 2);
    const double least = std::ranges::min(weights);
    std::vector<double> blocks(count * count, least);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        double& largest =
            blocks[std::min(cell(points[i][1]) / 2, count - 1) * count + std::min(cell(points[i][0]) / 2, count - 1)];
        largest = std::max(largest, weights[i]);
    }
    std::vector<double> all = largest_around(blocks, count);
    while (count >= 3) {
        const std::size_t next = count / 2;
        std::vector<double> larger(next * next, least);
        for (std::size_t y = 0; y < count; ++y)
            for (std::size_t x = 0; x < count; ++x) {
                double& largest = larger[std::min(y / 2, next - 1) * next + std::min(x / 2, next - 1)];
                largest = std::max(largest, blocks[y * count + x]);
            }
        blocks = std::move(larger);
        count = next;
        const std::vector<double> around = largest_around(blocks, count);
        all.insert(all.end(), around.begin(), around.end());
    }
    return all;
}

struct PowerBuffers
{
    Buffer<double> largest_weights; ///< of blocks of cells
    Buffer<double> weights, areas, displacements, energies, exchanges;
    Buffer<std::uint32_t> neighbours;

    NeededBuffers needed(std::size_t points)
    {
        return {{largest_weights, largest_weight_count(power_grid(points))},
                {weights, points},
                {areas, points},
                {energies, points},
                {displacements, 2 * points},
                {exchanges, MAX_NEIGHBORS * points},
                {neighbours, MAX_NEIGHBORS * points}};
    }
};

}

struct PowerDiagramState
{
    PowerDiagramState(Device device, std::size_t points, std::size_t work_group_size)
        : group_size(work_group_size > 0 ? work_group_size : default_work_group_size),
          grid(device, 2, points, power_grid(points), group_size),
          measure(device.kernel(kernel_program("power_cells.cl", {}), "measure_power_cells"))
    {
        reserve(device, buffers.needed(points));
    }

    std::size_t group_size;
    PointGrid grid;
    PowerBuffers buffers;
    Kernel measure;
};

std::uint32_t power_grid(std::size_t points)
{
    return std::max(1u, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(points) / points_per_power_cell)));
}

PowerDiagram::PowerDiagram(Device device, std::size_t points, std::size_t work_group_size)
    : state_(std::make_shared<PowerDiagramState>(std::move(device), points, work_group_size))
{}

PowerCells PowerDiagram::cells(const PointSet& points, const std::vector<double>& weights)
{
    const std::size_t n = points.size();
    PointGrid& grid = state_->grid;
    PowerBuffers& b = state_->buffers;
    grid.load(points);
    grid.sort();
    b.weights.write(weights);
    b.largest_weights.write(largest_weights(points, weights, grid.cells_per_axis()));
    state_->measure.run(n, state_->group_size, grid.positions(), grid.ids(), b.weights, grid.starts(),
                        grid.cells_per_axis(), static_cast<std::uint32_t>(n), b.largest_weights, b.areas,
                        b.displacements, b.energies, b.neighbours, b.exchanges);
    return {b.areas.read(0, n), b.displacements.read(0, 2 * n), b.energies.read(0, n),
            b.neighbours.read(0, MAX_NEIGHBORS * n), b.exchanges.read(0, MAX_NEIGHBORS * n)};
}

DeviceMemory PowerDiagram::memory(std::size_t points)
{
    return PointGrid::memory(2, points, power_grid(points)) + memory_of(PowerBuffers{}.needed(points));
}

}
