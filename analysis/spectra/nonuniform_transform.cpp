#include "analysis/spectra/nonuniform_transform.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace poissonlab {
namespace {

constexpr int spread_width = 8;

/// A power of two, at least twice as fine as the frequencies need, and wider than the kernel.
int transform_grid(int reach)
{
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(4 * reach, 2 * spread_width))));
}

}

/// Transforms are made in place: rows of the grid have room for their frequencies.
struct NonuniformTransform::Plans
{
    explicit Plans(int size)
        : columns(static_cast<std::size_t>(size) / 2 + 1), spectrum(static_cast<std::size_t>(size) * columns),
          grid(reinterpret_cast<double*>(spectrum.data())),
          forward(make_fftw_plan(fftw_plan_dft_r2c_2d, size, size, grid, fftw(spectrum.data()), FFTW_ESTIMATE)),
          backward(make_fftw_plan(fftw_plan_dft_c2r_2d, size, size, fftw(spectrum.data()), grid, FFTW_ESTIMATE))
    {}

    std::size_t columns;
    std::vector<std::complex<double>> spectrum;
    double* grid; ///< the same memory: rows of 2 * columns values
    FftwPlan forward, backward;
};

NonuniformTransform::NonuniformTransform(int reach)
    : reach_(reach), grid_(transform_grid(reach)),
      kernel_(spread_width, static_cast<double>(grid_) / (2.0 * reach + 1)), plans_(std::make_unique<Plans>(grid_))
{
    for (int u = 0; u <= reach; ++u) corrections_.push_back(1 / kernel_.transform(static_cast<double>(u) / grid_));
}

NonuniformTransform::~NonuniformTransform() = default;
NonuniformTransform::NonuniformTransform(NonuniformTransform&&) noexcept = default;

int NonuniformTransform::weights_at(double coordinate, double* weights) const
{
    const double begin = coordinate * grid_ - 0.5 * spread_width;
    const double first = std::ceil(begin);
    kernel_.values(first - begin, weights);
    return static_cast<int>(first);
}

/// Calls what(grid point, weight) for all under the kernel of a point.
template <typename What>
void NonuniformTransform::for_each_weight(const PointSet& points, std::size_t point, What&& what) const
{
    std::array<double, SpreadingKernel::max_width> along_x, along_y;
    const int x = weights_at(points[point][0], along_x.data());
    const int y = weights_at(points[point][1], along_y.data());
    const auto wrapped = [&](int i) { return static_cast<std::size_t>(i) & static_cast<std::size_t>(grid_ - 1); };
    for (int j = 0; j < spread_width; ++j) {
        const std::size_t row = wrapped(y + j) * 2 * plans_->columns;
        for (int i = 0; i < spread_width; ++i)
            what(row + wrapped(x + i), along_y[static_cast<std::size_t>(j)] * along_x[static_cast<std::size_t>(i)]);
    }
}

HalfPlane NonuniformTransform::forward(const PointSet& points, std::span<const double> weights)
{
    std::ranges::fill(plans_->spectrum, 0.0);
    for (std::size_t j = 0; j < points.size(); ++j) {
        const double times = weights.empty() ? 1 : weights[j];
        for_each_weight(points, j, [&](std::size_t place, double weight) { plans_->grid[place] += times * weight; });
    }
    fftw_execute(plans_->forward.get());
    HalfPlane result(reach_);
    for (int v = -reach_; v <= reach_; ++v)
        for (int u = 0; u <= reach_; ++u)
            result.at(u, v) =
                plans_->spectrum[static_cast<std::size_t>((v + grid_) % grid_) * plans_->columns +
                                 static_cast<std::size_t>(u)] *
                (corrections_[static_cast<std::size_t>(u)] * corrections_[static_cast<std::size_t>(std::abs(v))]);
    return result;
}

std::vector<double> NonuniformTransform::adjoint(const HalfPlane& coefficients, const PointSet& points)
{
    std::ranges::fill(plans_->spectrum, 0.0);
    for (int v = -reach_; v <= reach_; ++v)
        for (int u = 0; u <= reach_; ++u)
            plans_->spectrum[static_cast<std::size_t>((v + grid_) % grid_) * plans_->columns +
                             static_cast<std::size_t>(u)] =
                coefficients.at(u, v) *
                (corrections_[static_cast<std::size_t>(u)] * corrections_[static_cast<std::size_t>(std::abs(v))]);
    fftw_execute(plans_->backward.get());
    std::vector<double> result(points.size());
    for (std::size_t j = 0; j < points.size(); ++j)
        for_each_weight(points, j,
                        [&](std::size_t place, double weight) { result[j] += weight * plans_->grid[place]; });
    return result;
}

}
