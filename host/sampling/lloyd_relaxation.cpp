// Runs the kernels of Lloyd relaxation.
#include "host/sampling/lloyd_relaxation.hpp"

#include "host/sampling/domain_buffers.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/point_grid.hpp"
#include "host/sampling/voronoi_cells.hpp"

#include <algorithm>
#include <limits>

namespace poissonlab {
namespace {

/// Points that one work-item of summarize_points owns. Sums are taken in this order on every device.
constexpr std::uint32_t summary_run = 256;

std::size_t summaries_of(std::size_t points) { return (points + summary_run - 1) / summary_run; }

class DeviceState
{
public:
    DeviceState(Device& device, const PointSet& points, const Domain& domain, std::size_t group_size)
        : points_(points.size()), group_size_(group_size),
          grid_(device, points.dimension, points_, VoronoiKernels::cells_per_axis(points.dimension, points_),
                group_size),
          voronoi_(device, points.dimension, points_, group_size), mover_(device, domain, points.dimension, group_size),
          energy_sums_(device.buffer<double>(summaries())), smallest_(device.buffer<double>(summaries())),
          summarize_(
              device.kernel(kernel_program("relaxation.cl", {{"DIMENSION", points.dimension}}), "summarize_points"))
    {
        grid_.load(points);
    }

    IterateMeasure measure()
    {
        grid_.sort();
        voronoi_.find_cells(grid_);
        summarize_.run(summaries(), group_size_, voronoi_.energies(), voronoi_.squared_near(),
                       static_cast<std::uint32_t>(points_), summary_run, energy_sums_, smallest_);
        IterateMeasure measure{0, std::numeric_limits<double>::infinity()};
        for (const double sum : energy_sums_.read(0, summaries())) measure.energy += sum;
        for (const double near : smallest_.read(0, summaries()))
            measure.squared_near = std::min(measure.squared_near, near);
        return measure;
    }

    void move() { mover_.move(grid_, voronoi_.displacements(), false); }
    void keep() { kept_ = grid_.points(); }
    PointSet kept() { return std::move(kept_); }

private:
    std::size_t summaries() const { return summaries_of(points_); }

    std::size_t points_;
    std::size_t group_size_;
    PointGrid grid_;
    VoronoiKernels voronoi_;
    PointMover mover_;
    Buffer<double> energy_sums_, smallest_;
    Kernel summarize_;
    PointSet kept_;
};

}

LloydRelaxation::LloydRelaxation(Device device, std::size_t work_group_size)
    : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size)
{}

LloydResult LloydRelaxation::relax(const PointSet& points, const Domain& domain, const LloydRequest& request)
{
    DeviceState state(device_, points, domain, work_group_size_);
    return run_iterations(state, points.size(), points.dimension, request);
}

DeviceMemory LloydRelaxation::memory(int dimension, std::size_t points)
{
    DeviceMemory sums;
    sums.add_buffer<double>(summaries_of(points)).add_buffer<double>(summaries_of(points));
    return PointGrid::memory(dimension, points, VoronoiKernels::cells_per_axis(dimension, points)) +
           VoronoiKernels::memory(dimension, points) + DomainBuffers::memory_of_torus() + sums;
}

}
