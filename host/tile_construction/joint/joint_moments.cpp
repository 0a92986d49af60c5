#include "host/tile_construction/joint/joint_moments.hpp"

#include "host/tile_construction/moments/moment_step.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Iterations of conjugate gradients; movement of the iteration that they are part of changes more than they leave.
constexpr int most_iterations = 60;
constexpr double least_residual = 1e-9; ///< of what it was, squared

/// The unit of lengths is half a tile, so that all numbers are of order 1.
constexpr double half_tile = tile_units / 2.0;

class JointMoments
{
public:
    JointMoments(const std::vector<Displacement>& displacements, const StoredPoints& points,
                 const OwnPoints& own_points, const PoissonTileParameters& p)
        : p_(p), monomials_(monomials_up_to(p.equal_moments, p.dimension)), conditions_(monomials_.size()),
          axes_(static_cast<std::size_t>(p.dimension)), owners_(points.count()), first_entry_{0}
    {
        for (std::uint32_t tile = 0; tile < p.tiles; ++tile) {
            for (const OwnPoint& own : own_points(tile)) {
                const WeightedPoint& point = points.mean_tile()[own.stored];
                add_entry(own, point, displacements[own.stored]);
                if (point.moves) ++owners_[own.stored];
            }
            first_entry_.push_back(entries_.size());
        }
        measure();
        precondition();
    }

    /// The movements of stored points; units.
    std::vector<Displacement> run()
    {
        std::vector<double> multipliers(lacking_.size()), residual = lacking_, direction = preconditioned(residual);
        double product = dot(residual, direction);
        const double end = least_residual * product;
        for (int i = 0; i < most_iterations && product > end; ++i) {
            const std::vector<double> image = times_slopes(moved_by(direction));
            const double step = product / dot(direction, image);
            for (std::size_t c = 0; c < residual.size(); ++c) {
                multipliers[c] += step * direction[c];
                residual[c] -= step * image[c];
            }
            const std::vector<double> next = preconditioned(residual);
            const double next_product = dot(residual, next);
            for (std::size_t c = 0; c < residual.size(); ++c)
                direction[c] = next[c] + next_product / product * direction[c];
            product = next_product;
        }
        std::vector<Displacement> movements = moved_by(multipliers);
        for (Displacement& movement : movements)
            for (double& x : movement) x *= half_tile;
        return movements;
    }

private:
    /// A point of a tile.
    struct Entry
    {
        std::uint32_t stored;
        std::array<double, 3> at; ///< from the middle of the tile
    };

    void add_entry(const OwnPoint& own, const WeightedPoint& point, const Displacement& by)
    {
        Entry entry{own.stored, {}};
        for (std::size_t k = 0; k < axes_; ++k)
            entry.at[k] = (point.position[k] + own.base[k] * tile_units + (point.moves ? by[k] : 0)) / half_tile - 1;
        entries_.push_back(entry);
        for (const Monomial& monomial : monomials_)
            for (std::size_t k = 0; k < axes_; ++k) slopes_.push_back(slope_at(monomial, k, entry.at));
    }

    static double power(double x, unsigned exponent)
    {
        double result = 1;
        for (unsigned i = 0; i < exponent; ++i) result *= x;
        return result;
    }

    static double value_at(const Monomial& m, const std::array<double, 3>& at)
    {
        return power(at[0], m[0]) * power(at[1], m[1]) * power(at[2], m[2]);
    }

    static double slope_at(Monomial m, std::size_t axis, const std::array<double, 3>& at)
    {
        const std::uint8_t exponent = m[axis];
        if (exponent == 0) return 0;
        --m[axis];
        return exponent * value_at(m, at);
    }

    /// What tiles lack of the mean.
    void measure()
    {
        lacking_.assign(p_.tiles * conditions_, 0);
        std::vector<double> mean(conditions_);
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
            for (std::size_t e = first_entry_[tile]; e < first_entry_[tile + 1]; ++e)
                for (std::size_t c = 0; c < conditions_; ++c)
                    lacking_[tile * conditions_ + c] -= value_at(monomials_[c], entries_[e].at);
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
            for (std::size_t c = 0; c < conditions_; ++c) mean[c] += lacking_[tile * conditions_ + c] / p_.tiles;
        for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
            for (std::size_t c = 0; c < conditions_; ++c) lacking_[tile * conditions_ + c] -= mean[c];
    }

    /// The movements of stored points for multipliers of the conditions.
    std::vector<Displacement> moved_by(const std::vector<double>& multipliers) const
    {
        std::vector<Displacement> movements(owners_.size());
        for_each_slope([&](std::size_t condition, std::size_t entry, std::size_t axis, double slope) {
            movements[entries_[entry].stored][axis] += multipliers[condition] * slope;
        });
        for (std::size_t i = 0; i < movements.size(); ++i)
            for (double& x : movements[i]) x = owners_[i] > 0 ? x / owners_[i] : 0;
        return movements;
    }

    /// How movements change the moments of tiles.
    std::vector<double> times_slopes(const std::vector<Displacement>& movements) const
    {
        std::vector<double> changes(lacking_.size());
        for_each_slope([&](std::size_t condition, std::size_t entry, std::size_t axis, double slope) {
            changes[condition] += slope * movements[entries_[entry].stored][axis];
        });
        return changes;
    }

    template <class Visit>
    void for_each_slope(const Visit& visit) const
    {
        std::size_t next = 0;
        for (std::size_t tile = 0; tile < p_.tiles; ++tile)
            for (std::size_t e = first_entry_[tile]; e < first_entry_[tile + 1]; ++e)
                for (std::size_t c = 0; c < conditions_; ++c)
                    for (std::size_t k = 0; k < axes_; ++k) visit(tile * conditions_ + c, e, k, slopes_[next++]);
    }

    /// The conditions of each tile by themselves, factorized.
    void precondition()
    {
        const std::size_t size = conditions_ * (conditions_ + 1) / 2;
        for (std::size_t tile = 0; tile < p_.tiles; ++tile) {
            std::vector<double> triangle(size);
            for (std::size_t e = first_entry_[tile]; e < first_entry_[tile + 1]; ++e) {
                const std::uint32_t owners = owners_[entries_[e].stored];
                if (owners == 0) continue;
                const double* slopes = &slopes_[e * conditions_ * axes_];
                for (std::size_t c = 0, at = 0; c < conditions_; ++c)
                    for (std::size_t d = 0; d <= c; ++d, ++at)
                        for (std::size_t k = 0; k < axes_; ++k)
                            triangle[at] += slopes[c * axes_ + k] * slopes[d * axes_ + k] / owners;
            }
            factorize(triangle, conditions_);
            factors_.insert(factors_.end(), triangle.begin(), triangle.end());
        }
    }

    std::vector<double> preconditioned(const std::vector<double>& residual) const
    {
        const std::size_t size = conditions_ * (conditions_ + 1) / 2;
        std::vector<double> result = residual;
        for (std::size_t tile = 0; tile < p_.tiles; ++tile)
            solve(std::span(factors_).subspan(tile * size, size),
                  std::span(result).subspan(tile * conditions_, conditions_));
        return result;
    }

    static double dot(const std::vector<double>& a, const std::vector<double>& b)
    {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
        return sum;
    }

    const PoissonTileParameters& p_;
    std::vector<Monomial> monomials_;
    std::size_t conditions_, axes_;
    std::vector<std::uint32_t> owners_; ///< tiles that have a stored point; 0: it does not move
    std::vector<Entry> entries_;        ///< tile after tile
    std::vector<std::size_t> first_entry_;
    std::vector<double> slopes_; ///< by entry, condition, axis
    std::vector<double> lacking_, factors_;
};

}

void add_moment_step(std::vector<Displacement>& displacements, const StoredPoints& points, const OwnPoints& own_points,
                     const PoissonTileParameters& parameters)
{
    const std::vector<Displacement> movements = JointMoments(displacements, points, own_points, parameters).run();
    for (std::size_t i = 0; i < displacements.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) displacements[i][k] += movements[i][k];
}

}
