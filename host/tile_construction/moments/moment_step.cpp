#include "host/tile_construction/moments/moment_step.hpp"

#include "kernels/common/tiles/tile_filling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using namespace contract::tile_filling;

std::size_t triangle_index(std::size_t row, std::size_t column) { return row * (row + 1) / 2 + column; }

}

std::int64_t slope_of(const Monomial& monomial, std::size_t axis, const FromMiddle& at)
{
    if (monomial[axis] == 0) return 0;
    Monomial lower = monomial;
    --lower[axis];
    return monomial[axis] * value_of(lower, at);
}

void factorize(std::span<double> triangle, std::size_t rows)
{
    for (std::size_t i = 0; i < rows; ++i) {
        const double own = triangle[triangle_index(i, i)];
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = triangle[triangle_index(i, j)];
            for (std::size_t k = 0; k < j; ++k) sum -= triangle[triangle_index(i, k)] * triangle[triangle_index(j, k)];
            double& entry = triangle[triangle_index(i, j)];
            if (j < i)
                entry = triangle[triangle_index(j, j)] > 0 ? sum / triangle[triangle_index(j, j)] : 0;
            else
                entry = sum > LEAST_PIVOT * own ? std::sqrt(sum) : 0;
        }
    }
}

void solve(std::span<const double> factor, std::span<double> values)
{
    const std::size_t rows = values.size();
    for (std::size_t i = 0; i < rows; ++i) {
        double sum = values[i];
        for (std::size_t k = 0; k < i; ++k) sum -= factor[triangle_index(i, k)] * values[k];
        values[i] = factor[triangle_index(i, i)] > 0 ? sum / factor[triangle_index(i, i)] : 0;
    }
    for (std::size_t i = rows; i-- > 0;) {
        double sum = values[i];
        for (std::size_t k = i + 1; k < rows; ++k) sum -= factor[triangle_index(k, i)] * values[k];
        values[i] = factor[triangle_index(i, i)] > 0 ? sum / factor[triangle_index(i, i)] : 0;
    }
}

namespace {

/// The numbers of all systems in the same place.
using Lanes = std::array<double, side_by_side>;

Lanes lanes_at(std::span<const double> numbers, std::size_t index)
{
    Lanes lanes;
    std::copy_n(&numbers[index * side_by_side], side_by_side, lanes.begin());
    return lanes;
}

void subtract_products(Lanes& sums, const double* a, const double* b)
{
    for (std::size_t lane = 0; lane < side_by_side; ++lane) sums[lane] -= a[lane] * b[lane];
}

void put_quotients(const Lanes& sums, const double* divisors, double* quotients)
{
    for (std::size_t lane = 0; lane < side_by_side; ++lane)
        quotients[lane] = divisors[lane] > 0 ? sums[lane] / divisors[lane] : 0;
}

}

void solve_side_by_side(std::span<const double> factors, std::span<double> values)
{
    const std::size_t rows = values.size() / side_by_side;
    const auto factor = [&](std::size_t row, std::size_t column) {
        return &factors[triangle_index(row, column) * side_by_side];
    };
    const auto value = [&](std::size_t row) { return &values[row * side_by_side]; };
    for (std::size_t i = 0; i < rows; ++i) {
        Lanes sums = lanes_at(values, i);
        for (std::size_t k = 0; k < i; ++k) subtract_products(sums, factor(i, k), value(k));
        put_quotients(sums, factor(i, i), value(i));
    }
    for (std::size_t i = rows; i-- > 0;) {
        Lanes sums = lanes_at(values, i);
        for (std::size_t k = i + 1; k < rows; ++k) subtract_products(sums, factor(k, i), value(k));
        put_quotients(sums, factor(i, i), value(i));
    }
}

std::int64_t near_enough(std::uint32_t order, std::uint32_t highest, std::size_t points)
{
    return (static_cast<std::int64_t>(points) + NEAR_POINTS) << (HALF_TILE_BITS * (order - 1)) >>
           (highest == 1 ? ALIKE_SHIFT : NEAR_SHIFT);
}

void MomentStep::measure(std::span<const FromMiddle> points)
{
    points_.assign(points.begin(), points.end());
    lacking_.assign(wanted_.begin(), wanted_.end());
    for (const FromMiddle& point : points)
        for (std::size_t m = 0; m < monomials_.size(); ++m) lacking_[m] -= value_of(monomials_[m], point);
}

bool MomentStep::is_near() const
{
    for (std::size_t m = 0; m < monomials_.size(); ++m)
        if (std::abs(lacking_[m]) > near_enough(order_of(monomials_[m]), order_of(monomials_.back()), points_.size()))
            return false;
    return true;
}

/// Slopes are those of coordinates with fewer bits, so that sums of their products are exact; the step need not be.
void MomentStep::find()
{
    std::vector<double> triangle;
    for (std::size_t m = 0; m < monomials_.size(); ++m)
        for (std::size_t n = 0; n <= m; ++n) {
            std::int64_t sum = 0;
            for (const FromMiddle& point : points_) {
                const FromMiddle coarse{point[0] >> COARSE_BITS, point[1] >> COARSE_BITS, point[2] >> COARSE_BITS};
                for (std::size_t k = 0; k < 3; ++k)
                    sum += slope_of(monomials_[m], k, coarse) * slope_of(monomials_[n], k, coarse);
            }
            const int bits = (HALF_TILE_BITS - COARSE_BITS) *
                             static_cast<int>(order_of(monomials_[m]) + order_of(monomials_[n]) - 2);
            triangle.push_back(std::ldexp(static_cast<double>(sum), -bits));
        }
    factorize(triangle, monomials_.size());
    multipliers_.clear();
    for (std::size_t m = 0; m < monomials_.size(); ++m)
        multipliers_.push_back(std::ldexp(static_cast<double>(lacking_[m]),
                                          -HALF_TILE_BITS * static_cast<int>(order_of(monomials_[m]) - 1)));
    solve(triangle, multipliers_);
}

std::array<double, 3> MomentStep::movement(const FromMiddle& at) const
{
    const FromMiddle coarse{at[0] >> COARSE_BITS, at[1] >> COARSE_BITS, at[2] >> COARSE_BITS};
    std::array<double, 3> sum{};
    for (std::size_t m = 0; m < monomials_.size(); ++m) {
        const int bits = (HALF_TILE_BITS - COARSE_BITS) * static_cast<int>(order_of(monomials_[m]) - 1);
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += multipliers_[m] * std::ldexp(static_cast<double>(slope_of(monomials_[m], k, coarse)), -bits);
    }
    return sum;
}

}
