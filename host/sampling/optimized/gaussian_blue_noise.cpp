// Runs kernels/gaussian_blue_noise.cl.
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/cells/domain_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/point_summary.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab {

namespace {

using contract::gaussian_blue_noise::BLOCK_POINTS;
using contract::gaussian_blue_noise::DensityCell;
using contract::gaussian_blue_noise::Gaussians;

/// The side of the torus in mean distances.
double side_of_torus(std::size_t points, int dimension)
{
    return dimension == 2 ? std::sqrt(static_cast<double>(points)) : std::cbrt(static_cast<double>(points));
}

struct GaussianBuffers
{
    Buffer<double> displacements, energies, squared_near;
    Buffer<DensityCell> cells;

    /// `shape`: that of the field, if there is one.
    NeededBuffers needed(std::size_t points, int dimension, const GaussianFieldShape* shape)
    {
        NeededBuffers all{
            {displacements, points * static_cast<std::size_t>(dimension)}, {energies, points}, {squared_near, points}};
        if (shape == nullptr) return all;
        all.push_back({cells, std::size_t{shape->size} * shape->size});
        return all;
    }
};

class GaussianState
{
public:
    GaussianState(Device& device, const PointSet& points, const GaussianRequest& request, std::size_t group_size)
        : dimension_(points.dimension), sigma_(request.sigma), group_size_(group_size), field_(request.field),
          gaussians_(gaussians_for(request, points.size(), points.dimension)),
          grid_(device, points.dimension, points.size(), gaussians_.grid_size, group_size),
          mover_(device, Domain{}, points.dimension, group_size), summary_(device, points.dimension, points.size()),
          sum_(device.kernel(
              kernel_program("gaussian_blue_noise.cl", {{"DIMENSION", points.dimension}, {"ADAPTIVE", field_ ? 1 : 0}}),
              "sum_gaussians"))
    {
        gaussians_.stride = grid_.stride();
        reserve(device, buffers_.needed(points.size(), points.dimension, field_ ? &field_->shape : nullptr));
        if (field_) buffers_.cells.write(field_->cells);
        grid_.load(points);
    }

    IterateMeasure measure()
    {
        grid_.sort();
        const std::size_t blocks = (grid_.size() + BLOCK_POINTS - 1) / BLOCK_POINTS;
        if (field_)
            sum_.run(blocks, group_size_, gaussians_, grid_.positions(), grid_.fixed_point(), grid_.starts(),
                     buffers_.displacements, buffers_.energies, buffers_.squared_near, buffers_.cells,
                     field_->shape.size);
        else
            sum_.run(blocks, group_size_, gaussians_, grid_.positions(), grid_.fixed_point(), grid_.starts(),
                     buffers_.displacements, buffers_.energies, buffers_.squared_near);
        IterateMeasure measure = summary_.summarize(buffers_.energies, buffers_.squared_near);
        measure.energy = gaussian_energy(measure.energy, grid_.size(), sigma_, dimension_);
        return measure;
    }

    void move() { mover_.move(grid_, buffers_.displacements, false); }
    void keep() { kept_ = grid_.points(); }
    PointSet kept() { return std::move(kept_); }

private:
    int dimension_;
    double sigma_;
    std::size_t group_size_;
    std::shared_ptr<const GaussianField> field_;
    Gaussians gaussians_;
    PointGrid grid_;
    PointMover mover_;
    PointSummary summary_;
    Kernel sum_;
    GaussianBuffers buffers_;
    PointSet kept_;
};

}

std::size_t least_gaussian_points(double sigma, int dimension)
{
    return static_cast<std::size_t>(std::ceil(std::pow(2 * gaussian_cut_off * sigma, dimension)));
}

double usual_gaussian_step(double sigma, int dimension)
{
    return dimension == 2 ? 0.25 : 0.25 / std::sqrt(2 * std::numbers::pi) / sigma;
}

Gaussians gaussians_for(const GaussianRequest& request, std::size_t points, int dimension)
{
    const double side = side_of_torus(points, dimension);
    const double squared_sigma = request.sigma * request.sigma;
    const std::uint32_t grid_size =
        request.field ? request.field->shape.grid_size : gaussian_grid(request.sigma, points, dimension);
    return {.step = request.step / squared_sigma * 0x1p-32,
            .exponent = gaussian_exponent(squared_sigma / (side * side)),
            .near = static_cast<float>(1.001 * max_min_distance(points, dimension) * grid_size),
            .points = static_cast<std::uint32_t>(points),
            .grid_size = grid_size,
            .stride = 0};
}

double gaussian_energy(double sum_of_others, std::size_t points, double sigma, int dimension)
{
    const double spread_evenly = std::pow(2 * std::numbers::pi * sigma * sigma, 0.5 * dimension);
    return sum_of_others / static_cast<double>(points) + 1 - spread_evenly;
}

std::size_t coarser_points(std::size_t points, int dimension)
{
    const std::size_t children = std::size_t{1} << dimension;
    return (points + children - 1) / children;
}

PointSet split_points(const PointSet& coarse, std::size_t points)
{
    const auto dimension = static_cast<std::size_t>(coarse.dimension);
    const double quarter = 0.25 / side_of_torus(coarse.size(), coarse.dimension);
    PointSet fine{coarse.dimension, {}};
    fine.coordinates.reserve(points * dimension);
    for (std::size_t corner = 0; corner >> dimension == 0; ++corner)
        for (std::size_t i = 0; i < coarse.size() && fine.size() < points; ++i)
            for (std::size_t k = 0; k < dimension; ++k) {
                const double moved = coarse[i][k] + (corner >> k & 1 ? quarter : -quarter);
                fine.coordinates.push_back(moved - std::floor(moved));
            }
    for (double& c : fine.coordinates)
        if (c >= 1) c = 0; // of a coordinate just below 0
    return fine;
}

GaussianBlueNoise::GaussianBlueNoise(Device device, std::size_t work_group_size)
    : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size)
{}

LloydResult GaussianBlueNoise::descend(const PointSet& points, const GaussianRequest& request)
{
    GaussianState state(device_, points, request, work_group_size_);
    return run_iterations(state, points.size(), points.dimension, {.iterations = request.iterations});
}

DeviceMemory GaussianBlueNoise::memory(double sigma, std::size_t points, int dimension)
{
    return PointGrid::memory(dimension, points, gaussian_grid(sigma, points, dimension)) +
           memory_of(GaussianBuffers{}.needed(points, dimension, nullptr)) + DomainBuffers::memory_of_torus() +
           PointSummary::memory(points);
}

DeviceMemory GaussianBlueNoise::memory(const GaussianFieldShape& shape, std::size_t points)
{
    return PointGrid::memory(2, points, shape.grid_size) + memory_of(GaussianBuffers{}.needed(points, 2, &shape)) +
           DomainBuffers::memory_of_torus() + PointSummary::memory(points);
}

}
