#include "host/tile_construction/joint/stored_points.hpp"

#include "host/tile_construction/filling/tile_filling.hpp"
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

void StoredPoints::add(std::span<const WeightedPoint> points)
{
    mean_tile_.insert(mean_tile_.end(), points.begin(), points.end());
    first_.push_back(mean_tile_.size());
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

/// The stored points of one class, in as many pieces.
struct PointsOfClass
{
    StoredPoints points;
    std::vector<std::size_t> numbers; ///< of its points among all
    std::vector<std::uint32_t> own;   ///< of all points among its points, if they are of the class
};

PointsOfClass points_of_class(const StoredPoints& all, std::uint32_t of, const PoissonTileParameters& p)
{
    PointsOfClass result;
    result.own.resize(all.count());
    for (std::size_t piece = 0; piece < all.pieces(); ++piece) {
        std::vector<WeightedPoint> own;
        for (std::size_t i = all.first(piece); i < all.end(piece); ++i) {
            if (class_of(all.mean_tile()[i].position, p) != of) continue;
            result.own[i] = static_cast<std::uint32_t>(result.numbers.size());
            result.numbers.push_back(i);
            own.push_back(all.mean_tile()[i]);
        }
        result.points.add(own);
    }
    return result;
}

/// The parameters of a set of one class alone, or of all points without their classes.
PoissonTileParameters without_classes(PoissonTileParameters p, std::uint32_t points_per_tile)
{
    p.points_per_tile = points_per_tile;
    p.classes = {};
    return p;
}

/// A point goes half of the way to where all points would have it, and half to where those of its class would: blue
/// noise of the class and of all. Nulling is for the mean tile of all points and for those of classes; moments are
/// those of each class.
std::vector<Displacement> class_displacements(JointEngine& engine, const StoredPoints& points,
                                              const OwnPieces& own_pieces, const OwnPoints& own_points,
                                              const PoissonTileParameters& p, const std::vector<std::uint32_t>& tiles)
{
    constexpr double share_of_all = 0.5;
    const auto centred = [&](const StoredPoints& of) {
        return engine.mean_displacements(of.torus(p.dimension, joint_side(p), tiles, own_pieces), of.count());
    };
    std::vector<Displacement> displacements = centred(points);
    std::vector<PointsOfClass> classes;
    for (std::uint32_t of = 0; of < p.classes.count(); ++of) {
        classes.push_back(points_of_class(points, of, p));
        if (p.classes.count() == 1) break;
        const std::vector<Displacement> alone = centred(classes.back().points);
        for (std::size_t i = 0; i < alone.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                double& x = displacements[classes.back().numbers[i]][k];
                x = share_of_all * x + (1 - share_of_all) * alone[i][k];
            }
    }
    if (p.null_peaks && p.classes.count() > 1)
        add_nulling(displacements, engine, moved(points.mean_tile(), displacements),
                    without_classes(p, p.points_per_tile), nulling_reach);
    for (std::uint32_t of = 0; of < p.classes.count(); ++of) {
        const PointsOfClass& own = classes[of];
        std::vector<Displacement> parts;
        for (const std::size_t number : own.numbers) parts.push_back(displacements[number]);
        const auto own_points_of_class = [&](std::uint32_t tile) {
            std::vector<OwnPoint> kept;
            for (OwnPoint point : own_points(tile)) {
                if (class_of(points.mean_tile()[point.stored].position, p) != of) continue;
                point.stored = own.own[point.stored];
                kept.push_back(point);
            }
            return kept;
        };
        add_evening(parts, engine, own.points, own_points_of_class, without_classes(p, p.classes.points[of]));
        for (std::size_t i = 0; i < parts.size(); ++i) displacements[own.numbers[i]] = parts[i];
    }
    return displacements;
}

}

std::vector<Displacement> joint_displacements(JointEngine& engine, const StoredPoints& points,
                                              const OwnPieces& own_pieces, const OwnPoints& own_points,
                                              const PoissonTileParameters& p, std::uint32_t iteration)
{
    const std::vector<std::uint32_t> tiles = joint_tiling(p, iteration);
    if (!p.classes.is_empty()) return class_displacements(engine, points, own_pieces, own_points, p, tiles);
    const JointTorus torus = points.torus(p.dimension, joint_side(p), tiles, own_pieces);
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
