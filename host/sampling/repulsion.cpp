#include "host/sampling/repulsion.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/domain_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/point_summary.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace poissonlab {

RepulsionPass repulsion_pass(const RepulsionRequest& request, std::size_t points, int dimension)
{
    const double distance = request.min_distance * 1.0005;
    // A little wider, for the rounding of coordinates to cells.
    const double width = std::max(distance, max_min_distance(points, dimension)) * (1 + 0x1p-20);
    const auto cells = std::max(1u, static_cast<std::uint32_t>(std::min(1 / width, 65535.0)));
    return {distance, std::min(distance, 1.0), cells, distance < 1 ? 1 : 2};
}

struct RepulsionBuffers
{
    Buffer<double> displacements, squared_near, best;

    NeededBuffers needed(int dimension, std::size_t points)
    {
        const std::size_t values = points * static_cast<std::size_t>(dimension);
        return {{displacements, values}, {squared_near, points}, {best, values}};
    }
};

struct RepulsionState
{
    RepulsionState(Device& device, int dimension_, std::size_t points, std::uint32_t cells_per_axis,
                   std::size_t work_group_size)
        : dimension(dimension_), grid(device, dimension, points, cells_per_axis, work_group_size),
          summary(device, dimension, points)
    {
        reserve(device, buffers.needed(dimension, points));
        const KernelProgram program = kernel_program("repulsion.cl", {{"DIMENSION", dimension}, doubles_of(device)});
        push = device.kernel(program, "push_points");
        keep = device.kernel(program, "keep_points");
    }

    int dimension;
    PointGrid grid;
    PointSummary summary;
    RepulsionBuffers buffers;
    Kernel push, keep;
};

Repulsion::Repulsion(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, nullptr)
{}

RepulsionResult Repulsion::repel(const PointSet& points, const Domain& domain, const RepulsionRequest& request)
{
    const std::size_t n = points.size();
    const auto count = static_cast<std::uint32_t>(n);
    const RepulsionPass pass = repulsion_pass(request, n, points.dimension);
    if (!buffers_ || buffers_->dimension != points.dimension || buffers_->grid.size() != n ||
        buffers_->grid.cells_per_axis() != pass.cells_per_axis) {
        buffers_ =
            std::make_shared<RepulsionState>(device_, points.dimension, n, pass.cells_per_axis, work_group_size_);
    }
    RepulsionBuffers& b = buffers_->buffers;
    PointGrid& grid = buffers_->grid;
    PointMover mover(device_, domain, points.dimension, work_group_size_);
    const DomainBuffers& held = mover.domain();

    grid.load(points);
    RepulsionResult result{{points.dimension, std::vector<double>(points.coordinates.size())}, 0, -1};
    for (;; ++result.passes) {
        grid.sort();
        buffers_->push.run(n, work_group_size_, grid.positions(), grid.ids(), count, grid.starts(), pass.cells_per_axis,
                           pass.reach, pass.distance, pass.limit, held.is_fixed, held.has_fixed, b.displacements,
                           b.squared_near);
        const double reached = std::sqrt(buffers_->summary.summarize(b.squared_near, b.squared_near).squared_near);
        if (reached > result.min_distance) {
            result.min_distance = reached;
            buffers_->keep.run(n, work_group_size_, grid.positions(), grid.ids(), count, b.best);
        }
        if (reached >= request.min_distance || result.passes == request.passes) break;
        mover.move(grid, b.displacements, true);
    }
    b.best.read(result.points.coordinates);
    return result;
}

DeviceMemory Repulsion::memory(int dimension, std::size_t points, const RepulsionRequest& request)
{
    return PointGrid::memory(dimension, points, repulsion_pass(request, points, dimension).cells_per_axis) +
           memory_of(RepulsionBuffers{}.needed(dimension, points)) + PointSummary::memory(points) +
           DomainBuffers::memory_of_torus();
}

}
