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
        : dimension_(points.dimension),
          grid_(device, points.dimension, points.size(),
                VoronoiKernels::cells_per_axis(points.dimension, points.size()), group_size),
          voronoi_(device, points.dimension, points.size(), group_size),
          mover_(device, domain, points.dimension, group_size),
          summary_(device, points.dimension, points.size(), iterations_of_batch(points.size(), points.dimension))
    {
        load(points);
    }

    void measure_later()
    {
        grid_.sort();
        voronoi_.find_cells(grid_);
        summary_.add(voronoi_.energies(), voronoi_.squared_near());
    }

    std::vector<IterateMeasure> measures()
    {
        std::vector<IterateMeasure> measures = summary_.take();
        for (IterateMeasure& measure : measures)
            measure.energy = lloyd_energy(measure.energy, grid_.size(), dimension_);
        return measures;
    }

    void move() { mover_.move(grid_, voronoi_.displacements(), false); }
    void load(const PointSet& points) { grid_.load(points); }
    PointSet points() const { return grid_.points(); }

private:
    int dimension_;
    PointGrid grid_;
    VoronoiKernels voronoi_;
    PointMover mover_;
    PointSummary summary_;
};

}

LloydRelaxation::LloydRelaxation(Device device, std::size_t work_group_size)
    : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size)
{}

LloydResult LloydRelaxation::relax(const PointSet& points, const Domain& domain, const LloydRequest& request)
{
    DeviceState state(device_, points, domain, work_group_size_);
    return run_batches(state, points.size(), points.size(), points.dimension, request);
}

DeviceMemory LloydRelaxation::memory(int dimension, std::size_t points)
{
    return voronoi_memory(dimension, points) + DomainBuffers::memory_of_torus() +
           PointSummary::memory(points, iterations_of_batch(points, dimension));
}

}
