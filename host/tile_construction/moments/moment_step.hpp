// The least movement of points that gives them the moments that they should have: docs/chain-tiles.md.
//
// The plain twin of kernels/common/tiles/moment_step.clh. Sums are of whole numbers, so that their order does not
// matter; what is computed from them in floating point is computed by both in the same order.
#pragma once

#include "tiles/poisson/tile_moments.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// A position in units, from the middle of its tile.
using FromMiddle = std::array<std::int64_t, 3>;

/// The derivative of a monomial along an axis.
std::int64_t slope_of(const Monomial& monomial, std::size_t axis, const FromMiddle& at);

/// The lower triangle of a symmetric matrix, row after row; replaced by that of its Cholesky factor. Rows that depend
/// on those before get none.
void factorize(std::span<double> triangle, std::size_t rows);

/// Replaces a right-hand side by the solution, for the factor that factorize() leaves.
void solve(std::span<const double> factor, std::span<double> values);

/// The number of systems that solve_side_by_side() solves.
inline constexpr std::size_t side_by_side = 8;

/// Solves several systems as solve() does each, to the same bits, so that none waits for its own last subtraction.
/// `factors` and `values` have each entry of all systems one after the other.
void solve_side_by_side(std::span<const double> factors, std::span<double> values);

class MomentStep
{
public:
    /// `wanted`: the moments, one for each monomial; units.
    MomentStep(const std::vector<Monomial>& monomials, std::span<const std::int64_t> wanted)
        : monomials_(monomials), wanted_(wanted)
    {}

    /// Takes the points as they are.
    void measure(std::span<const FromMiddle> points);

    /// Are moments what they should be, but for what rounding of so many positions to whole units does?
    bool is_near() const;

    /// Finds the step from the points that were measured last.
    void find();

    /// The movement of a point; units.
    std::array<double, 3> movement(const FromMiddle& at) const;

private:
    const std::vector<Monomial>& monomials_;
    std::span<const std::int64_t> wanted_;
    std::vector<FromMiddle> points_;
    std::vector<std::int64_t> lacking_;
    std::vector<double> multipliers_;
};

/// The difference of moments of an order from those that are wanted, of so many points, that counts as rounding, where
/// moments up to a highest order are wanted.
std::int64_t near_enough(std::uint32_t order, std::uint32_t highest, std::size_t points);

}
