// Gaussian blue noise: points that descend the sum of the Gaussians of all pairs.
//
// Ahmed, Ren, Wonka, Gaussian blue noise, ACM Transactions on Graphics 41(6), 2022. Every point moves by a step along
// the force that the others exert on it, all at once, again and again. Lengths are in mean distances s =
// N^(-1/dimension): the Gaussian of a pair is exp(-d^2 / (2 sigma^2)). Departures: pairs farther apart than 5.8 sigma
// are left out, each of which has a Gaussian below 5e-8, and each Gaussian errs by up to 3e-7, due to single precision
// and to a polynomial for the exponential. In even sets a force errs by less than 2e-6 sigma in 2D and 2.3e-5 sigma^2
// in 3D for what is left out, even if all of that pulled the same way: the integral of r exp(-r^2 / (2 sigma^2)) /
// sigma^2 beyond. The shortest of the vectors between two points counts, so that the torus must be as wide as two such
// distances. Where points follow a density, see host/sampling/optimized/gaussian_field.hpp.
#pragma once

#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/optimized/gaussian_field.hpp"
#include "kernels/common/optimized/gaussian_blue_noise.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace poissonlab {

struct GaussianRequest
{
    std::size_t iterations = 0;
    double sigma = 1; ///< mean distances
    double step = 0;  ///< mean distances for a unit of force
    /// The density that points follow, made for as many of them, in 2D; null: the same everywhere.
    std::shared_ptr<const GaussianField> field = nullptr;
};

/// The fewest points whose torus is as wide as it must be.
std::size_t least_gaussian_points(double sigma, int dimension);

/// The step of the paper, 0.25 in 2D, and as large a part, 0.58, of what makes waves in an even set grow otherwise:
/// exp(1) (2 pi)^(-dimension / 2) sigma^(2 - dimension), as the Gaussian resists waves of frequency k by at most
/// k^2 (2 pi sigma^2)^(dimension / 2) exp(-k^2 sigma^2 / 2).
double usual_gaussian_step(double sigma, int dimension);

/// The cells of the grid in which a point's neighbours are looked for, along each axis.
std::uint32_t gaussian_grid_size(const GaussianRequest& request, std::size_t points, int dimension);

/// Both engines are told these numbers, of all points.
contract::gaussian_blue_noise::Gaussians gaussians_for(const GaussianRequest& request, std::size_t points,
                                                       int dimension);

/// The energy of records: the mean over points of the Gaussians of all points, themselves among them, less that of
/// points spread evenly. Random points have 1 on average; it cannot be negative where there is no density.
double gaussian_energy(double sum_of_others, std::size_t points, double sigma, int dimension);

/// `points` has at least least_gaussian_points().
namespace reference {
LloydResult descend(const PointSet& points, const GaussianRequest& request);
}

/// Moves points by kernels/gaussian_blue_noise.cl: every device finds the bytes of the reference.
class GaussianBlueNoise
{
public:
    /// `work_group_size` 0: the default.
    explicit GaussianBlueNoise(Device device, std::size_t work_group_size = 0);

    LloydResult descend(const PointSet& points, const GaussianRequest& request);

    /// The memory that descend() takes, and gives back.
    static DeviceMemory memory(double sigma, std::size_t points, int dimension);

    /// The memory that descend() takes with a field of this shape, in 2D.
    static DeviceMemory memory(const GaussianFieldShape& shape, std::size_t points);

private:
    Device device_;
    std::size_t work_group_size_;
};

/// Coarse to fine: a set of `points` is made of one of as many as this, each of which becomes 2^dimension.
std::size_t coarser_points(std::size_t points, int dimension);

/// The numbers of points of all levels, the coarsest first and `points` last, where so many coarser ones come before.
std::vector<std::size_t> level_points(std::size_t points, int dimension, std::int64_t coarser);

/// Each point of a set becomes 2^dimension, a quarter of the set's mean distance away from it along each axis, so that
/// what the set has at low frequencies stays. The first `points` of the corners come first: what is too many is left
/// out of the last corner alone.
PointSet split_points(const PointSet& coarse, std::size_t points);

/// The place of a point's part at a corner, from 0 to 2^dimension - 1, in a set of `coarse` points. Parts of a corner
/// are numbered as the points are, after those of the corners before.
std::array<double, 3> split_place(std::span<const double> place, std::size_t corner, std::size_t coarse);

/// The request that the sampler's parameters make for each level, without the density.
GaussianRequest gaussian_request(const Parameters& parameters, int dimension);

/// The sampler "gaussian-blue-noise": iterations, sigma, step, levels, density, start.
SamplerSpec gaussian_blue_noise_sampler();

}
