// Gaussian blue noise, plain and sequential: what the kernels must reproduce.
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/reference/plain_cells.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace poissonlab::reference {
namespace {

using namespace contract::gaussian_blue_noise;

double part_way(double a, double b, double part) { return a * (1 - part) + b * part; }

/// The density of a place, linear between the middles of cells: displacement along x and y, and excess energy.
std::array<double, 3> density_around(const GaussianField& field, std::span<const double> place)
{
    const auto n = static_cast<int>(field.shape.size);
    std::array<int, 2> low{};
    std::array<double, 2> part{};
    for (std::size_t k = 0; k < 2; ++k) {
        const double cells = place[k] * n - 0.5;
        low[k] = static_cast<int>(std::floor(cells));
        part[k] = cells - std::floor(cells);
    }
    const auto row_values = [&](int row) {
        const auto cell = [&](int column) -> const DensityCell& { return field.cell((column + n) % n, (row + n) % n); };
        const DensityCell &a = cell(low[0]), &b = cell(low[0] + 1);
        return std::array{part_way(double{a.x}, double{b.x}, part[0]), part_way(double{a.y}, double{b.y}, part[0]),
                          part_way(double{a.excess}, double{b.excess}, part[0])};
    };
    const auto below = row_values(low[1]), above = row_values(low[1] + 1);
    std::array<double, 3> values{};
    for (std::size_t k = 0; k < 3; ++k) values[k] = part_way(below[k], above[k], part[1]);
    return values;
}

/// 2^t for t <= 0: its power of two, and a polynomial for the rest.
float power_of_two(float t)
{
    const float whole = std::nearbyint(t);
    const float x = t - whole;
    float sum = 0.00132647273F;
    for (const float coefficient : {0.00967151299F, 0.0555073358F, 0.240222424F, 0.693147004F, 1.0F})
        sum = std::fma(sum, x, coefficient);
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(sum) + static_cast<std::int32_t>(whole) * (1 << 23));
}

/// The cells of an axis up to `reach` away from one, on the torus: each of them once, in rising order.
std::vector<int> cells_around(int cell, int reach, int grid_size)
{
    std::vector<int> cells;
    const int count = std::min(2 * reach + 1, grid_size);
    for (int i = 0; i < count; ++i) cells.push_back(((cell - reach + i) % grid_size + grid_size) % grid_size);
    std::ranges::sort(cells);
    return cells;
}

class PlainGaussianState
{
public:
    PlainGaussianState(const PointSet& points, const GaussianRequest& request)
        : points_(points), sigma_(request.sigma), field_(request.field),
          axes_(static_cast<std::size_t>(points.dimension)),
          grid_size_(static_cast<int>(gaussian_grid_size(request, points.size(), points.dimension))),
          gaussians_(gaussians_for(request, points.size(), points.dimension)), displacements_(points.coordinates.size())
    {}

    IterateMeasure measure()
    {
        const PlainCells cells(points_, grid_size_);
        std::vector<double> energies;
        double squared_near = std::numeric_limits<double>::infinity();
        for (std::size_t id = 0; id < points_.size(); ++id) {
            const Sums sums = sums_of(id, cells);
            for (std::size_t k = 0; k < axes_; ++k)
                displacements_[id * axes_ + k] = double{sums.force[k]} * gaussians_.step;
            energies.push_back(sums.energy);
            if (field_) {
                const auto [x, y, excess] = density_around(*field_, points_[id]);
                displacements_[id * axes_] += x;
                displacements_[id * axes_ + 1] += y;
                if (enters_nothing(id)) displacements_[id * axes_] = displacements_[id * axes_ + 1] = 0;
                energies.back() -= excess;
            }
            squared_near = std::min(squared_near, double{sums.squared_near} * 0x1p-64);
        }
        double energy = 0;
        for (const double e : energies) energy += e;
        return {gaussian_energy(energy, points_.size(), sigma_, points_.dimension), squared_near};
    }

    void move()
    {
        for (std::size_t i = 0; i < points_.coordinates.size(); ++i) {
            const double moved = points_.coordinates[i] + displacements_[i];
            const double wrapped = moved - std::floor(moved);
            points_.coordinates[i] = wrapped < 1 ? wrapped : 0; // just below 0, the sum rounds to 1
        }
    }

    void keep() { kept_ = points_; }
    PointSet kept() { return std::move(kept_); }

private:
    struct Sums
    {
        std::array<float, 3> force{};
        float energy = 0;
        float squared_near = std::numeric_limits<float>::infinity();
    };

    const DensityCell& cell_at(double x, double y) const
    {
        const auto n = static_cast<int>(field_->shape.size);
        const auto cell = [&](double place) { return std::min(static_cast<int>(place * n), n - 1); };
        return field_->cell(cell(x), cell(y));
    }

    float exponent_of(std::size_t id) const
    {
        return field_ ? cell_at(points_[id][0], points_[id][1]).exponent : gaussians_.exponent;
    }

    /// True where its displacement leads a point into a place without density.
    bool enters_nothing(std::size_t id) const
    {
        const auto moved = [&](std::size_t k) {
            const double to = points_[id][k] + displacements_[id * axes_ + k];
            return to - std::floor(to);
        };
        return cell_at(moved(0), moved(1)).is_empty != 0;
    }

    Sums sums_of(std::size_t id, const PlainCells& cells) const
    {
        Sums sums;
        const float exponent = exponent_of(id);
        const int n = grid_size_;
        const int reach = 1 + static_cast<int>(std::sqrt(CUT_EXPONENT / double{exponent}) * 0x1p-32 * n * 1.000001);
        const auto cell = cells.cell_of(points_[id]);
        const std::vector<int> columns = cells_around(cell[0], reach, n), rows = cells_around(cell[1], reach, n);
        const std::vector<int> planes = axes_ == 3 ? cells_around(cell[2], reach, n) : std::vector{0};
        for (const int z : planes)
            for (const int y : rows) {
                Sums row;
                for (const int x : columns)
                    cells.for_each_in({x, y, z}, [&](std::size_t other, const auto&) {
                        if (other != id) add(id, other, exponent, row);
                    });
                for (std::size_t k = 0; k < axes_; ++k) sums.force[k] += row.force[k];
                sums.energy += row.energy;
                sums.squared_near = std::min(sums.squared_near, row.squared_near);
            }
        return sums;
    }

    void add(std::size_t id, std::size_t other, float exponent, Sums& sums) const
    {
        std::array<float, 3> difference{};
        float squared = 0;
        for (std::size_t k = 0; k < axes_; ++k) {
            const auto fixed = [&](std::size_t point) {
                return static_cast<std::uint32_t>(points_.coordinates[point * axes_ + k] * 0x1p32);
            };
            difference[k] = static_cast<float>(static_cast<std::int32_t>(fixed(id) - fixed(other)));
            squared = std::fma(difference[k], difference[k], squared);
        }
        sums.squared_near = std::min(sums.squared_near, squared);
        const float t = squared * exponent;
        if (!(t > static_cast<float>(CUT_EXPONENT))) return;
        const float gaussian = power_of_two(t);
        for (std::size_t k = 0; k < axes_; ++k) sums.force[k] = std::fma(difference[k], gaussian, sums.force[k]);
        sums.energy += gaussian;
    }

    PointSet points_;
    double sigma_;
    std::shared_ptr<const GaussianField> field_;
    std::size_t axes_;
    int grid_size_;
    Gaussians gaussians_;
    std::vector<double> displacements_;
    PointSet kept_;
};

}

LloydResult descend(const PointSet& points, const GaussianRequest& request)
{
    PlainGaussianState state(points, request);
    return run_iterations(state, points.size(), points.dimension, {.iterations = request.iterations});
}

}
