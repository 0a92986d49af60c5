#include "host/sampling/slabs/slab_method.hpp"

#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/sampling/optimized/gaussian_forces.hpp"

#include <optional>

namespace poissonlab {
namespace {

class LloydInSlabs final : public SlabMethod
{
public:
    LloydInSlabs(int dimension, std::size_t points)
        : dimension_(dimension), cells_per_axis_(VoronoiKernels::cells_per_axis(dimension, points))
    {}

    std::uint32_t cells_per_axis() const override { return cells_per_axis_; }
    std::uint32_t layers_around() const override { return VoronoiKernels::least_around(dimension_); }
    DeviceMemory memory(std::size_t points) const override { return VoronoiKernels::memory(dimension_, points); }

    void make_room(Device& device, std::size_t points) override
    {
        voronoi_.reset(); // what it had makes room
        voronoi_.emplace(device, dimension_, points, default_work_group_size);
    }

    void find(PointGrid& grid) override { voronoi_->find_cells(grid); }
    bool is_known() const override { return voronoi_->are_known(); }
    const Buffer<double>& displacements() const override { return voronoi_->displacements(); }
    const Buffer<double>& squared_near() const override { return voronoi_->squared_near(); }

private:
    int dimension_;
    std::uint32_t cells_per_axis_;
    std::optional<VoronoiKernels> voronoi_;
};

class GaussiansInSlabs final : public SlabMethod
{
public:
    GaussiansInSlabs(const GaussianRequest& request, int dimension, std::size_t points)
        : request_(request), dimension_(dimension), points_(points)
    {}

    std::uint32_t cells_per_axis() const override { return gaussian_grid_size(request_, points_, dimension_); }
    std::uint32_t layers_around() const override
    {
        return GaussianForces::layers_around(request_, points_, dimension_);
    }
    DeviceMemory memory(std::size_t points) const override
    {
        return GaussianForces::memory(dimension_, points, nullptr);
    }

    void make_room(Device& device, std::size_t points) override
    {
        forces_.reset();
        forces_.emplace(device, dimension_, points, request_, points_, default_work_group_size);
    }

    void find(PointGrid& grid) override { forces_->find(grid); }
    const Buffer<double>& displacements() const override { return forces_->displacements(); }
    const Buffer<double>& squared_near() const override { return forces_->squared_near(); }

private:
    GaussianRequest request_;
    int dimension_;
    std::size_t points_;
    std::optional<GaussianForces> forces_;
};

}

std::unique_ptr<SlabMethod> lloyd_in_slabs(int dimension, std::size_t points)
{
    return std::make_unique<LloydInSlabs>(dimension, points);
}

std::unique_ptr<SlabMethod> gaussians_in_slabs(const GaussianRequest& request, int dimension, std::size_t points)
{
    return std::make_unique<GaussiansInSlabs>(request, dimension, points);
}

}
