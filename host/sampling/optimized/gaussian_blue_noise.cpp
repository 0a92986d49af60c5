// Gaussian blue noise on a device: forces by gaussian_forces.cpp.
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include "base/geometry/relative_radius.hpp"
#include "host/sampling/cells/domain_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/optimized/gaussian_forces.hpp"
#include "host/sampling/point_summary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {

namespace {

using contract::gaussian_blue_noise::Gaussians;

/// The side of the torus in mean distances.
double side_of_torus(std::size_t points, int dimension)
{
    return dimension == 2 ? std::sqrt(static_cast<double>(points)) : std::cbrt(static_cast<double>(points));
}

PointGrid grid_for(const Device& device, const PointSet& points, const GaussianRequest& request, std::size_t group_size)
{
    const std::uint32_t size = gaussian_grid_size(request, points.size(), points.dimension);
    if (request.field && request.field->shape.listed > 0)
        return {device, points.dimension, points.size(), size, request.field->listed, group_size};
    return {device, points.dimension, points.size(), size, group_size};
}

class GaussianState
{
public:
    GaussianState(Device& device, const PointSet& points, const GaussianRequest& request, std::size_t group_size)
        : dimension_(points.dimension), sigma_(request.sigma), grid_(grid_for(device, points, request, group_size)),
          forces_(device, points.dimension, points.size(), request, points.size(), group_size),
          mover_(device, Domain{}, points.dimension, group_size),
          summary_(device, points.dimension, points.size(), iterations_of_batch(points.size(), points.dimension))
    {
        load(points);
    }

    void measure_later()
    {
        grid_.sort();
        forces_.find(grid_);
        summary_.add(forces_.energies(), forces_.squared_near());
    }

    std::vector<IterateMeasure> measures()
    {
        std::vector<IterateMeasure> measures = summary_.take();
        for (IterateMeasure& measure : measures)
            measure.energy = gaussian_energy(measure.energy, grid_.size(), sigma_, dimension_);
        return measures;
    }

    void move() { mover_.move(grid_, forces_.displacements(), false); }
    void load(const PointSet& points) { grid_.load(points); }
    PointSet points() const { return grid_.points(); }

private:
    int dimension_;
    double sigma_;
    PointGrid grid_;
    GaussianForces forces_;
    PointMover mover_;
    PointSummary summary_;
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

std::uint32_t gaussian_grid_size(const GaussianRequest& request, std::size_t points, int dimension)
{
    return request.field ? request.field->shape.grid_size : gaussian_grid(request.sigma, points, dimension);
}

Gaussians gaussians_for(const GaussianRequest& request, std::size_t points, int dimension)
{
    const double side = side_of_torus(points, dimension);
    const double squared_sigma = request.sigma * request.sigma;
    const std::uint32_t grid_size = gaussian_grid_size(request, points, dimension);
    return {.step = request.step / squared_sigma * 0x1p-32,
            .exponent = gaussian_exponent(squared_sigma / (side * side)),
            .near = static_cast<float>(1.001 * max_min_distance(points, dimension) * grid_size),
            .first = 0,
            .end = static_cast<std::uint32_t>(points),
            .stride = 0,
            .unused = 0};
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

std::vector<std::size_t> level_points(std::size_t points, int dimension, std::int64_t coarser)
{
    std::vector<std::size_t> counts{points};
    for (; coarser > 0; --coarser) counts.insert(counts.begin(), coarser_points(counts.front(), dimension));
    return counts;
}

std::array<double, 3> split_place(std::span<const double> place, std::size_t corner, std::size_t coarse)
{
    const double quarter = 0.25 / side_of_torus(coarse, static_cast<int>(place.size()));
    std::array<double, 3> part{};
    for (std::size_t k = 0; k < place.size(); ++k) {
        const double moved = place[k] + (corner >> k & 1 ? quarter : -quarter);
        const double wrapped = moved - std::floor(moved);
        part[k] = wrapped < 1 ? wrapped : 0; // of a coordinate just below 0
    }
    return part;
}

PointSet split_points(const PointSet& coarse, std::size_t points)
{
    const auto dimension = static_cast<std::size_t>(coarse.dimension);
    PointSet fine{coarse.dimension, {}};
    fine.coordinates.reserve(points * dimension);
    for (std::size_t corner = 0; corner >> dimension == 0; ++corner)
        for (std::size_t i = 0; i < coarse.size() && fine.size() < points; ++i) {
            const auto part = split_place(coarse[i], corner, coarse.size());
            fine.coordinates.insert(fine.coordinates.end(), part.begin(), part.begin() + coarse.dimension);
        }
    return fine;
}

GaussianBlueNoise::GaussianBlueNoise(Device device, std::size_t work_group_size)
    : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size)
{}

LloydResult GaussianBlueNoise::descend(const PointSet& points, const GaussianRequest& request)
{
    GaussianState state(device_, points, request, work_group_size_);
    // Each point has as many neighbours within its Gaussian as its volume says.
    const double work = static_cast<double>(points.size()) * std::max(1.0, std::pow(request.sigma, points.dimension));
    return run_batches(state, points.size(), static_cast<std::size_t>(work), points.dimension,
                       {.iterations = request.iterations});
}

DeviceMemory GaussianBlueNoise::memory(double sigma, std::size_t points, int dimension)
{
    return PointGrid::memory(dimension, points, gaussian_grid(sigma, points, dimension)) +
           GaussianForces::memory(dimension, points, nullptr) + DomainBuffers::memory_of_torus() +
           PointSummary::memory(points, iterations_of_batch(points, dimension));
}

DeviceMemory GaussianBlueNoise::memory(const GaussianFieldShape& shape, std::size_t points)
{
    return (shape.listed > 0 ? PointGrid::memory_of_listed(2, points, shape.grid_size, shape.listed)
                             : PointGrid::memory(2, points, shape.grid_size)) +
           GaussianForces::memory(2, points, &shape) + DomainBuffers::memory_of_torus() +
           PointSummary::memory(points, iterations_of_batch(points, 2));
}

}
