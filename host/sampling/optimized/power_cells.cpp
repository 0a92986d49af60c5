// Runs kernels/power_cells.cl.
#include "host/sampling/optimized/power_cells.hpp"

#include "host/device/kernel.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "kernels/common/power_cells.h"

#include <algorithm>
#include <cmath>

namespace poissonlab {

using contract::power_cells::MAX_NEIGHBORS;

namespace {

constexpr double points_per_power_cell = 1.5;

struct PowerBuffers
{
    Buffer<double> weights, areas, displacements, energies, exchanges;
    Buffer<std::uint32_t> neighbours;

    NeededBuffers needed(std::size_t points)
    {
        return {{weights, points},
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
    const auto [least, most] = std::ranges::minmax(weights);
    state_->measure.run(n, state_->group_size, grid.positions(), grid.ids(), b.weights, grid.starts(),
                        grid.cells_per_axis(), static_cast<std::uint32_t>(n), most - least, b.areas, b.displacements,
                        b.energies, b.neighbours, b.exchanges);
    return {b.areas.read(0, n), b.displacements.read(0, 2 * n), b.energies.read(0, n),
            b.neighbours.read(0, MAX_NEIGHBORS * n), b.exchanges.read(0, MAX_NEIGHBORS * n)};
}

DeviceMemory PowerDiagram::memory(std::size_t points)
{
    return PointGrid::memory(2, points, power_grid(points)) + memory_of(PowerBuffers{}.needed(points));
}

}
