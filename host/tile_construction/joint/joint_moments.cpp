#include "host/tile_construction/joint/joint_moments.hpp"

#include "host/tile_construction/joint/tile_conditions.hpp"
#include "host/tile_construction/moments/moment_step.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// Iterations of conjugate gradients; movement of the iteration that they are part of changes more than they leave.
constexpr int most_iterations = 60;
constexpr double least_residual = 1e-3; ///< of what it was, squared

/// The unit of lengths is half a tile, so that all numbers are of order 1.
constexpr double half_tile = tile_units / 2.0;

class JointMoments
{
public:
    JointMoments(const std::vector<Displacement>& displacements, const StoredPoints& points,
                 const OwnPoints& own_points, const PoissonTileParameters& p)
        : p_(p), conditions_(p), count_(conditions_.count()),
          axes_(static_cast<std::size_t>(p.dimension)), first_entry_{0}
    {
        std::vector<std::vector<Place>> places(points.count());
        std::vector<std::vector<OwnPoint>> own(p.tiles);
        for (std::uint32_t tile = 0; tile < p.tiles; ++tile) {
            own[tile] = own_points(tile);
            for (const OwnPoint& point : own[tile]) {
                if (!points.mean_tile()[point.stored].moves) continue;
                places[point.stored].push_back({entries_.size(), tile});
                entries_.push_back(point.stored);
            }
            first_entry_.push_back(entries_.size());
        }
        for (const auto& of_point : places) {
            places_.insert(places_.end(), of_point.begin(), of_point.end());
            first_place_.push_back(places_.size());
        }
        lacking_.resize(p.tiles * count_);
        slopes_.resize(entries_.size() * axes_ * count_);
        tbb::parallel_for(std::size_t{0}, std::size_t{p.tiles},
                          [&](std::size_t tile) { measure(tile, own[tile], points, displacements); });
        subtract_mean();
        precondition();
    }

    /// The movements of stored points; units.
    std::vector<Displacement> run()
    {
        std::vector<double> multipliers(lacking_.size()), residual = lacking_, direction = preconditioned(residual);
        double product = dot(residual, direction);
        const double end = least_residual * product;
        for (int i = 0; i < most_iterations && product > end; ++i) {
            const std::vector<double> image = times_matrix(direction);
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
    /// The place of a stored point in a tile.
    struct Place
    {
        std::size_t entry;
        std::uint32_t tile;
    };

    /// Sums what points of a tile have after the movement; of waves it sums what the movement changes. Finds the slopes
    /// of those that move, where they are then.
    void measure(std::size_t tile, const std::vector<OwnPoint>& own, const StoredPoints& points,
                 const std::vector<Displacement>& displacements)
    {
        std::vector<double> before(count_), after(count_);
        std::size_t entry = first_entry_[tile];
        for (const OwnPoint& point : own) {
            const WeightedPoint& stored = points.mean_tile()[point.stored];
            const auto at = position(point, stored, stored.moves ? displacements[point.stored] : Displacement{});
            conditions_.values(position(point, stored, {}), before);
            conditions_.values(at, after);
            for (std::size_t c = 0; c < count_; ++c)
                lacking_[tile * count_ + c] -= conditions_.stays(c) ? after[c] - before[c] : after[c];
            if (stored.moves) conditions_.slopes(at, slopes_of(entry++));
        }
    }

    TileConditions::Position position(const OwnPoint& own, const WeightedPoint& point, const Displacement& by) const
    {
        TileConditions::Position at{};
        for (std::size_t k = 0; k < axes_; ++k)
            at[k] = (point.position[k] + own.base[k] * tile_units + by[k]) / half_tile - 1;
        return at;
    }

    /// Tiles are to have the mean, so it is subtracted from what each of them lacks.
    void subtract_mean()
    {
        std::vector<double> mean(count_);
        for (std::size_t i = 0; i < lacking_.size(); ++i) mean[i % count_] += lacking_[i] / p_.tiles;
        for (std::size_t i = 0; i < lacking_.size(); ++i) lacking_[i] -= mean[i % count_];
    }

    std::span<double> slopes_of(std::size_t entry)
    {
        return std::span(slopes_).subspan(entry * axes_ * count_, axes_ * count_);
    }

    /// The number of tiles that have a stored point; 0: it does not move.
    std::size_t owners(std::size_t point) const { return first_place_[point + 1] - first_place_[point]; }

    /// The movements of stored points for multipliers of the conditions.
    std::vector<Displacement> moved_by(const std::vector<double>& multipliers) const
    {
        std::vector<Displacement> movements(first_place_.size() - 1);
        for_each(movements.size(), [&](std::size_t point) {
            for (std::size_t i = first_place_[point]; i < first_place_[point + 1]; ++i)
                for (std::size_t k = 0; k < axes_; ++k)
                    movements[point][k] +=
                        product(slopes_along(places_[i].entry, k), &multipliers[places_[i].tile * count_]);
            for (double& x : movements[point]) x = owners(point) > 0 ? x / static_cast<double>(owners(point)) : 0;
        });
        return movements;
    }

    /// Finds how movements change what tiles have of the conditions.
    std::vector<double> times_slopes(const std::vector<Displacement>& movements) const
    {
        std::vector<double> changes(lacking_.size());
        for_each(p_.tiles, [&](std::size_t tile) {
            for (std::size_t e = first_entry_[tile]; e < first_entry_[tile + 1]; ++e)
                for (std::size_t k = 0; k < axes_; ++k) {
                    const double* slopes = slopes_along(e, k);
                    const double movement = movements[entries_[e]][k];
                    for (std::size_t c = 0; c < count_; ++c) changes[tile * count_ + c] += slopes[c] * movement;
                }
        });
        return changes;
    }

    const double* slopes_along(std::size_t entry, std::size_t axis) const
    {
        return &slopes_[(entry * axes_ + axis) * count_];
    }

    /// The inner product of two vectors, by four sums, so that none waits for the last addition.
    double product(const double* a, const double* b) const
    {
        std::array<double, 4> sums{};
        std::size_t c = 0;
        for (; c + sums.size() <= count_; c += sums.size())
            for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += a[c + i] * b[c + i];
        for (; c < count_; ++c) sums[0] += a[c] * b[c];
        return sums[0] + sums[1] + (sums[2] + sums[3]);
    }

    /// Side by side, where there is enough to do: the body's own numbers depend on no other's.
    template <class Body>
    static void for_each(std::size_t count, const Body& body)
    {
        constexpr std::size_t least_share = 16;
        const tbb::blocked_range<std::size_t> all(0, count, least_share);
        tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
        });
    }

    /// The system's matrix adds what the movements of multipliers change to the misses that soft conditions allow.
    std::vector<double> times_matrix(const std::vector<double>& multipliers) const
    {
        std::vector<double> image = times_slopes(moved_by(multipliers));
        for (std::size_t i = 0; i < image.size(); ++i) image[i] += softness_[i] * multipliers[i];
        return image;
    }

    /// The conditions of each tile by themselves, factorized.
    void precondition()
    {
        const std::size_t size = count_ * (count_ + 1) / 2;
        factors_.resize(groups() * side_by_side * size);
        softness_.resize(p_.tiles * count_);
        tbb::parallel_for(std::size_t{0}, std::size_t{p_.tiles}, [&](std::size_t tile) {
            std::vector<double> triangle(size);
            add_squares(tile, triangle);
            for (std::size_t c = 0, diagonal = 0; c < count_; ++c, diagonal += c + 1) {
                softness_[tile * count_ + c] = conditions_.softness(c) * triangle[diagonal];
                triangle[diagonal] += softness_[tile * count_ + c];
            }
            factorize(triangle, count_);
            double* const in_group = &factors_[tile / side_by_side * side_by_side * size + tile % side_by_side];
            for (std::size_t i = 0; i < size; ++i) in_group[i * side_by_side] = triangle[i];
        });
    }

    /// The number of groups of tiles whose systems are solved side by side; the last one may have places without tiles.
    std::size_t groups() const { return (p_.tiles + side_by_side - 1) / side_by_side; }

    /// Products of slopes of the points of a tile.
    void add_squares(std::size_t tile, std::span<double> triangle) const
    {
        for (std::size_t e = first_entry_[tile]; e < first_entry_[tile + 1]; ++e)
            for (std::size_t k = 0; k < axes_; ++k) {
                const double* slopes = &slopes_[(e * axes_ + k) * count_];
                for (std::size_t c = 0, at = 0; c < count_; ++c) {
                    const double part = slopes[c] / static_cast<double>(owners(entries_[e]));
                    for (std::size_t d = 0; d <= c; ++d, ++at) triangle[at] += part * slopes[d];
                }
            }
    }

    std::vector<double> preconditioned(const std::vector<double>& residual) const
    {
        const std::size_t size = count_ * (count_ + 1) / 2 * side_by_side;
        std::vector<double> result(residual.size());
        tbb::parallel_for(std::size_t{0}, groups(), [&](std::size_t group) {
            const std::size_t first = group * side_by_side;
            const std::size_t tiles = std::min<std::size_t>(side_by_side, p_.tiles - first);
            std::vector<double> values(count_ * side_by_side);
            for (std::size_t i = 0; i < tiles * count_; ++i)
                values[i % count_ * side_by_side + i / count_] = residual[first * count_ + i];
            solve_side_by_side(std::span(factors_).subspan(group * size, size), values);
            for (std::size_t i = 0; i < tiles * count_; ++i)
                result[first * count_ + i] = values[i % count_ * side_by_side + i / count_];
        });
        return result;
    }

    static double dot(const std::vector<double>& a, const std::vector<double>& b)
    {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
        return sum;
    }

    const PoissonTileParameters& p_;
    TileConditions conditions_;
    std::size_t count_, axes_;
    std::vector<Place> places_; ///< of stored points, point after point
    std::vector<std::size_t> first_place_{0};
    std::vector<std::uint32_t> entries_; ///< the stored points that move, tile after tile
    std::vector<std::size_t> first_entry_;
    std::vector<double> slopes_; ///< by entry, axis, condition
    std::vector<double> lacking_;
    std::vector<double> factors_;  ///< by group, entry and tile
    std::vector<double> softness_; ///< by tile, condition
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
