// Runs kernels/farthest_point.cl.
#include "host/sampling/optimized/farthest_point.hpp"

#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/point_summary.hpp"
#include "kernels/common/optimized/farthest_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace poissonlab {

namespace {

using contract::farthest_point::COLORS;

constexpr double points_per_window_cell = 2.5;

/// Cells of a color are few, and take long: small groups keep all processors at work.
constexpr std::size_t cells_per_group = 8;

struct FarthestBuffers
{
    Buffer<std::uint32_t> last_sweeps; ///< in which each point moved last, by id

    NeededBuffers needed(std::size_t points) { return {{last_sweeps, points}}; }
};

class FarthestState
{
public:
    FarthestState(Device& device, const PointSet& points, std::size_t group_size)
        : group_size_(group_size), grid_(device, 2, points.size(), farthest_point_grid(points.size()), group_size),
          voronoi_(device, 2, points.size(), group_size), summary_(device, 2, points.size()),
          move_(device.kernel(kernel_program("farthest_point.cl", {}), "move_to_farthest"))
    {
        reserve(device, buffers_.needed(points.size()));
        buffers_.last_sweeps.write(std::vector<std::uint32_t>(points.size()));
        grid_.load(snapped_down(points));
    }

    IterateMeasure measure()
    {
        grid_.sort();
        voronoi_.find_cells(grid_);
        IterateMeasure measure = summary_.summarize(voronoi_.energies(), voronoi_.squared_near());
        measure.energy = lloyd_energy(measure.energy, grid_.size(), 2);
        return measure;
    }

    void move()
    {
        ++sweep_;
        const std::uint32_t axis = std::min<std::uint32_t>(COLORS, grid_.cells_per_axis()), colors = axis * axis;
        for (std::uint32_t color = 0; color < colors; ++color) {
            if (color > 0) grid_.sort();
            move_.run(grid_.cells() / colors, std::min(group_size_, cells_per_group), grid_.positions(), grid_.ids(),
                      grid_.starts(), grid_.cells_per_axis(), color, sweep_, buffers_.last_sweeps);
        }
    }

    void keep() { kept_ = grid_.points(); }
    PointSet kept() { return std::move(kept_); }

private:
    std::size_t group_size_;
    PointGrid grid_;
    VoronoiKernels voronoi_;
    PointSummary summary_;
    Kernel move_;
    FarthestBuffers buffers_;
    std::uint32_t sweep_ = 0;
    PointSet kept_;
};

}

std::uint32_t farthest_point_grid(std::size_t points)
{
    const double cells = std::sqrt(static_cast<double>(points) / points_per_window_cell);
    return cells < int{COLORS} ? 3 : COLORS * static_cast<std::uint32_t>(cells / int{COLORS} + 0.5);
}

PointSet snapped_down(PointSet points)
{
    for (double& c : points.coordinates) c = std::floor(c * 0x1p32) * 0x1p-32;
    return points;
}

FarthestPointOptimization::FarthestPointOptimization(Device device, std::size_t work_group_size)
    : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size)
{}

LloydResult FarthestPointOptimization::optimize(const PointSet& points, const LloydRequest& request)
{
    FarthestState state(device_, points, work_group_size_);
    return run_iterations(state, points.size(), 2, request);
}

DeviceMemory FarthestPointOptimization::memory(std::size_t points)
{
    return PointGrid::memory(2, points, farthest_point_grid(points)) + VoronoiKernels::memory(2, points) +
           PointSummary::memory(points) + memory_of(FarthestBuffers{}.needed(points));
}

}
