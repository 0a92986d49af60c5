#include "host/sampling/repulsion.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/domain_buffers.hpp"
#include "host/sampling/point_grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace poissonlab {
namespace {

/// Points that one work-item of summarize_points looks at.
constexpr std::uint32_t run_of_points = 256;

std::size_t runs_of(std::size_t points) { return (points + run_of_points - 1) / run_of_points; }

}

RepulsionPass repulsion_pass(const RepulsionRequest& request, std::size_t points, int dimension)
{
    const double distance = request.min_distance * 1.0005;
    // A little wider, for the rounding of coordinates to cells.
    const double width = std::max(distance, max_min_distance(points, dimension)) * (1 + 0x1p-20);
    const auto cells = std::max(1u, static_cast<std::uint32_t>(std::min(1 / width, 65535.0)));
    return {distance, std::min(distance, 1.0), cells, distance < 1 ? 1 : 2};
}

struct Repulsion::Buffers
{
    Buffers(Device& device, int dimension_, std::size_t points, std::uint32_t cells_per_axis,
            std::size_t work_group_size)
        : dimension(dimension_), grid(device, dimension, points, cells_per_axis, work_group_size)
    {
        const std::size_t values = points * static_cast<std::size_t>(dimension);
        runs = runs_of(points);
        displacements = device.buffer<double>(values);
        squared_near = device.buffer<double>(points);
        best = device.buffer<double>(values);
        sums = device.buffer<double>(runs);
        smallest = device.buffer<double>(runs);
        const KernelProgram program = kernel_program("repulsion.cl", {{"DIMENSION", dimension}});
        push = device.kernel(program, "push_points");
        keep = device.kernel(program, "keep_points");
        summarize = device.kernel(kernel_program("relaxation.cl", {{"DIMENSION", dimension}}), "summarize_points");
    }

    int dimension;
    std::size_t runs;
    PointGrid grid;
    Buffer<double> displacements, squared_near, best, sums, smallest;
    Kernel push, keep, summarize;
};

Repulsion::Repulsion(Device device, std::size_t work_group_size)
    : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size)
{}

Repulsion::~Repulsion() = default;

RepulsionResult Repulsion::repel(const PointSet& points, const Domain& domain, const RepulsionRequest& request)
{
    const std::size_t n = points.size();
    const auto count = static_cast<std::uint32_t>(n);
    const RepulsionPass pass = repulsion_pass(request, n, points.dimension);
    if (!buffers_ || buffers_->dimension != points.dimension || buffers_->grid.size() != n ||
        buffers_->grid.cells_per_axis() != pass.cells_per_axis) {
        buffers_ = std::make_unique<Buffers>(device_, points.dimension, n, pass.cells_per_axis, work_group_size_);
    }
    Buffers& b = *buffers_;
    PointGrid& grid = b.grid;
    PointMover mover(device_, domain, points.dimension, work_group_size_);
    const DomainBuffers& held = mover.domain();

    grid.load(points);
    RepulsionResult result{{points.dimension, std::vector<double>(points.coordinates.size())}, 0, -1};
    for (;; ++result.passes) {
        grid.sort();
        b.push.run(n, work_group_size_, grid.positions(), grid.ids(), count, grid.starts(), pass.cells_per_axis,
                   pass.reach, pass.distance, pass.limit, held.is_fixed, held.has_fixed, b.displacements,
                   b.squared_near);
        b.summarize.run(b.runs, 1, b.squared_near, b.squared_near, count, run_of_points, b.sums, b.smallest);
        const std::vector<double> smallest = b.smallest.read(0, b.runs);
        const double reached = std::sqrt(*std::min_element(smallest.begin(), smallest.end()));
        if (reached > result.min_distance) {
            result.min_distance = reached;
            b.keep.run(n, work_group_size_, grid.positions(), grid.ids(), count, b.best);
        }
        if (reached >= request.min_distance || result.passes == request.passes) break;
        mover.move(grid, b.displacements, true);
    }
    b.best.read(result.points.coordinates);
    return result;
}

DeviceMemory Repulsion::memory(int dimension, std::size_t points, const RepulsionRequest& request)
{
    const std::uint64_t values = points * static_cast<std::uint64_t>(dimension);
    DeviceMemory buffers;
    buffers.add_buffer<double>(values).add_buffer<double>(values).add_buffer<double>(points);
    buffers.add_buffer<double>(runs_of(points)).add_buffer<double>(runs_of(points));
    return PointGrid::memory(dimension, points, repulsion_pass(request, points, dimension).cells_per_axis) + buffers +
           DomainBuffers::memory_of_torus();
}

}
