// Runs the kernels of Lloyd relaxation.
#include "host/sampling/lloyd_relaxation.hpp"

#include "host/sampling/cells/domain_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/point_summary.hpp"

namespace poissonlab {
namespace {

class DeviceState
{
public:
    DeviceState(Device& device, const PointSet& points, const Domain& domain, std::size_t group_size)
        : grid_(device, points.dimension, points.size(),
                VoronoiKernels::cells_per_axis(points.dimension, points.size()), group_size),
          voronoi_(device, points.dimension, points.size(), group_size),
          mover_(device, domain, points.dimension, group_size), summary_(device, points.dimension, points.size())
    {
        grid_.load(points);
    }

    IterateMeasure measure()
    {
        grid_.sort();
        voronoi_.find_cells(grid_);
        return summary_.summarize(voronoi_.energies(), voronoi_.squared_near());
    }

    void move() { mover_.move(grid_, voronoi_.displacements(), false); }
    void keep() { kept_ = grid_.points(); }
    PointSet kept() { return std::move(kept_); }

private:
    PointGrid grid_;
    VoronoiKernels voronoi_;
    PointMover mover_;
    PointSummary summary_;
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
    return voronoi_memory(dimension, points) + DomainBuffers::memory_of_torus() + PointSummary::memory(points);
}

}
