#include "host/tile_construction/joint/stored_points.hpp"

#include "host/tile_construction/joint/joint_moments.hpp"
#include "host/tile_construction/joint/joint_tiling.hpp"

#include <cmath>

namespace poissonlab {

std::size_t StoredPoints::add(std::span<const UnitPosition> points, double weight, bool moves)
{
    for (const UnitPosition& point : points) mean_tile_.push_back({point, weight, moves});
    first_.push_back(mean_tile_.size());
    return first_.size() - 2;
}

JointTorus StoredPoints::torus(int dimension, std::uint32_t side, std::span<const std::uint32_t> tiles,
                               const OwnPieces& own_pieces) const
{
    JointTorus result{dimension, side, {}};
    const auto size = static_cast<std::int32_t>(side) * tile_units;
    for (std::uint32_t place = 0; place < tiles.size(); ++place) {
        const std::array<std::uint32_t, 3> at{place % side, place / side % side, place / side / side};
        for (const std::size_t piece : own_pieces(tiles[place])) {
            for (std::size_t i = first_[piece]; i < first_[piece + 1]; ++i) {
                PointCopy copy{static_cast<std::uint32_t>(i), mean_tile_[i].position};
                for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
                    const std::int32_t x = copy.position[k] + static_cast<std::int32_t>(at[k]) * tile_units;
                    copy.position[k] = (x % size + size) % size;
                }
                result.copies.push_back(copy);
            }
        }
    }
    return result;
}

double longest_joint_move(const PoissonTileParameters& p)
{
    constexpr double longest_in_spacings = 0.05;
    return longest_in_spacings * tile_units / std::pow(p.points_per_tile, 1.0 / p.dimension);
}

namespace {

/// Tiles with equal moments are nulled once more up to here, around the first ring of the spectrum, where peaks show.
constexpr double ring_reach = 1.3;

/// Steps of nulling alone go so much farther than those beside relaxation, which are many: nearly all the way down the
/// gradient, with a gain of 0.9 where more than 1 overshoots.
constexpr double long_stride = 3;

/// The mean tile after points have moved.
std::vector<WeightedPoint> moved(std::vector<WeightedPoint> points, const std::vector<Displacement>& displacements)
{
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < 3 && points[i].moves; ++k)
            points[i].position[k] += static_cast<std::int32_t>(std::nearbyint(displacements[i][k]));
    return points;
}

/// Adds a step of nulling from these points, so many times as long as it is by itself.
void add_nulling(std::vector<Displacement>& displacements, JointEngine& engine,
                 const std::vector<WeightedPoint>& points, const PoissonTileParameters& p, double reach,
                 double stride = 1)
{
    const auto frequencies = nulled_frequencies(p.points_per_tile, p.dimension, reach);
    const auto nulling = engine.nulling_displacements(points, frequencies, longest_joint_move(p));
    for (std::size_t i = 0; i < displacements.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) displacements[i][k] += stride * nulling[i][k];
}

/// Adds steps of nulling and then one to equal moments, as far as they are asked for.
void add_evening(std::vector<Displacement>& displacements, JointEngine& engine, const StoredPoints& points,
                 const OwnPoints& own_points, const PoissonTileParameters& p)
{
    if (p.null_peaks && p.equal_moments == 0) add_nulling(displacements, engine, points.mean_tile(), p, nulling_reach);
    if (p.null_peaks && p.equal_moments > 0)
        for (const double reach : {nulling_reach, ring_reach})
            add_nulling(displacements, engine, moved(points.mean_tile(), displacements), p, reach);
    if (p.equal_moments > 0) add_moment_step(displacements, points, own_points, p);
}

}

std::vector<Displacement> joint_displacements(JointEngine& engine, const StoredPoints& points,
                                              const OwnPieces& own_pieces, const OwnPoints& own_points,
                                              const PoissonTileParameters& p, std::uint32_t iteration)
{
    const JointTorus torus = points.torus(p.dimension, joint_side(p), joint_tiling(p, iteration), own_pieces);
    std::vector<Displacement> displacements = engine.mean_displacements(torus, points.count());
    add_evening(displacements, engine, points, own_points, p);
    return displacements;
}

std::vector<Displacement> evening_displacements(JointEngine& engine, const StoredPoints& points,
                                                const OwnPoints& own_points, const PoissonTileParameters& p)
{
    std::vector<Displacement> displacements(points.count());
    add_nulling(displacements, engine, points.mean_tile(), p, nulling_reach, long_stride);
    add_moment_step(displacements, points, own_points, p);
    return displacements;
}

}
