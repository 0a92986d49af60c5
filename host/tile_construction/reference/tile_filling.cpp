// Fills tori one after the other: the plain twin of kernels/tile_darts.cl and tile_relaxation.cl.
#include "host/tile_construction/filling/tile_filling.hpp"
#include "base/geometry/point_set.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/tile_construction/moments/moment_step.hpp"
#include "host/tile_construction/reference/filling_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab::reference {
namespace {

/// A torus while it is filled.
class Filling
{
public:
    Filling(const FillSettings& settings, const FillStage& stage, const FillProblem& problem)
        : settings_(settings), stage_(stage), points_(problem.held), active_begin_(problem.held.size()),
          monomials_(monomials_up_to(stage.equal_moments, settings.dimension)),
          moment_step_(monomials_, problem.moments)
    {
        points_.insert(points_.end(), problem.given.begin(), problem.given.end());
        if (stage.in_polygon) polygon_ = problem.held;
    }

    /// Throws darts until there are `count` points that are not held; false when they do not fit.
    bool throw_darts(const DartZone& darts, std::size_t count, std::uint32_t attempts, std::uint32_t stream,
                     std::uint32_t attempt, std::uint32_t zone_number)
    {
        const std::size_t target = active_begin_ + count;
        const Zone zone = zone_of(darts.cells);
        std::size_t level = 0;
        std::uint32_t failures = 0;
        for (std::uint32_t dart = 0; points_.size() < target && dart < contract::tile_filling::MAX_DARTS; ++dart) {
            const TilePosition position =
                dart_at(darts, settings_.dimension, {dart, stream, attempt, zone_number}, settings_.stream);
            if (!is_allowed(zone, position)) continue;
            if (squared_nearest(position, points_.size()) >= settings_.squared_distances[level]) {
                points_.push_back(position);
                failures = 0;
            } else if (++failures == attempts) {
                failures = 0;
                if (++level == settings_.squared_distances.size()) break;
            }
        }
        return points_.size() == target;
    }

    void mark_active_end() { active_end_ = points_.size(); }

    std::vector<TilePosition> active() const
    {
        return {points_.begin() + static_cast<std::ptrdiff_t>(active_begin_),
                points_.begin() + static_cast<std::ptrdiff_t>(active_end_)};
    }

    std::vector<TilePosition> surroundings() const
    {
        return {points_.begin() + static_cast<std::ptrdiff_t>(active_end_), points_.end()};
    }

    /// The smallest squared distance of an active point from any other.
    std::uint32_t squared_min_distance() const
    {
        std::uint32_t smallest = std::numeric_limits<std::uint32_t>::max();
        for (std::size_t i = active_begin_; i < active_end_; ++i)
            smallest = std::min(smallest, squared_nearest(points_[i], i));
        return smallest;
    }

    /// Keeps the last iterate where repulsion follows; else the last that has the wanted distance, or the
    /// best one.
    void relax()
    {
        const bool keeps_last = settings_.repulsion_passes > 0;
        std::uint32_t best = 0;
        std::vector<TilePosition> kept;
        for (std::uint32_t iteration = 0;; ++iteration) {
            const std::uint32_t nearest = squared_min_distance();
            const bool is_last = iteration == settings_.lloyd_iterations;
            if (keeps_last ? is_last : nearest >= settings_.wanted || nearest > best || iteration == 0) {
                best = std::min(nearest, settings_.wanted);
                kept = points_;
            }
            if (is_last) break;
            const VoronoiCells cells = voronoi_cells(on_unit_torus());
            const std::size_t images = image_count();
            std::vector<TilePosition> movements(points_.size());
            for (std::size_t i = active_begin_; i < moving_end(); ++i) {
                for (std::size_t k = 0; k < dimension(); ++k) {
                    const double displacement = cells.displacements[i * images * dimension() + k];
                    movements[i][k] = static_cast<std::int32_t>(std::nearbyint(displacement * torus_units));
                }
            }
            move(movements, moving_end(), false);
        }
        points_ = kept;
    }

    /// Until the wanted distance and the wanted moments are there, or keeps the best that has the moments. Returns the
    /// squared distance of what is kept; 0: without the moments.
    std::uint32_t repel()
    {
        std::uint32_t best = 0;
        std::vector<TilePosition> kept;
        for (std::uint32_t pass = 0;; ++pass) {
            const std::uint32_t nearest = has_moments() ? squared_min_distance() : 0;
            if (pass == 0 || nearest > best) {
                best = nearest;
                kept = points_;
            }
            if (nearest >= settings_.wanted || pass == settings_.repulsion_passes) break;
            std::vector<TilePosition> movements(points_.size());
            for (std::size_t i = active_begin_; i < active_end_; ++i) movements[i] = repelled(i);
            move(movements, active_end_, true);
            if (!monomials_.empty()) correct_moments();
        }
        points_ = kept;
        return best;
    }

private:
    std::size_t dimension() const { return static_cast<std::size_t>(settings_.dimension); }
    std::size_t moving_end() const { return stage_.surroundings_move ? points_.size() : active_end_; }
    Zone zone_of(CellSet cells) const { return {stage_.regions, cells, polygon_, stage_.keep_tiles}; }
    std::size_t image_count() const { return stage_.is_one_tile ? std::size_t{1} << settings_.dimension : 1; }

    TilePosition image_of(const TilePosition& position, std::size_t image) const
    {
        TilePosition result = position;
        for (std::size_t k = 0; k < dimension(); ++k)
            result[k] = wrapped(position[k] + static_cast<std::int32_t>(image >> k & 1) * tile_units);
        return result;
    }

    /// The squared distance from the nearest image of any point; `self`: the point at that position, or the number of
    /// points.
    std::uint32_t squared_nearest(const TilePosition& position, std::size_t self) const
    {
        std::uint32_t smallest = std::numeric_limits<std::uint32_t>::max();
        for (std::size_t i = 0; i < points_.size(); ++i) {
            for (std::size_t image = 0; image < image_count(); ++image) {
                if (i == self && image == 0) continue;
                smallest =
                    std::min(smallest, squared_between(position, image_of(points_[i], image), settings_.dimension));
            }
        }
        return smallest;
    }

    PointSet on_unit_torus() const
    {
        PointSet set{settings_.dimension, {}};
        for (const TilePosition& point : points_) {
            for (std::size_t image = 0; image < image_count(); ++image) {
                const TilePosition position = image_of(point, image);
                for (std::size_t k = 0; k < dimension(); ++k)
                    set.coordinates.push_back(static_cast<double>(position[k]) / torus_units);
            }
        }
        return set;
    }

    std::vector<FromMiddle> active_from_middle() const
    {
        std::vector<FromMiddle> from_middle;
        for (std::size_t i = active_begin_; i < active_end_; ++i) from_middle.push_back(from_middle_of(points_[i]));
        return from_middle;
    }

    FromMiddle from_middle_of(const TilePosition& position) const
    {
        FromMiddle at{};
        for (std::size_t k = 0; k < dimension(); ++k) at[k] = shortest(position[k] - tile_units / 2);
        return at;
    }

    bool has_moments()
    {
        moment_step_.measure(active_from_middle());
        return moment_step_.is_near();
    }

    void correct_moments()
    {
        moment_step_.measure(active_from_middle());
        moment_step_.find();
        std::vector<TilePosition> movements(points_.size());
        for (std::size_t i = active_begin_; i < active_end_; ++i)
            movements[i] = limited(moment_step_.movement(from_middle_of(points_[i])));
        move(movements, active_end_, true);
    }

    /// All points up to `end` at once.
    void move(const std::vector<TilePosition>& movements, std::size_t end, bool slides)
    {
        const Zone zone = zone_of(stage_.active.cells), around = zone_of(stage_.surroundings.cells);
        for (std::size_t i = active_begin_; i < end; ++i)
            points_[i] = allowed_end(i < active_end_ ? zone : around, points_[i], movements[i], slides);
    }

    TilePosition repelled(std::size_t i) const
    {
        const double distance = settings_.repulsion_distance;
        const auto limit = static_cast<std::uint32_t>(distance * distance);
        std::array<double, 3> sum{};
        for (std::size_t j = 0; j < points_.size(); ++j) {
            for (std::size_t image = 0; image < image_count(); ++image) {
                if (i == j && image == 0) continue;
                const TilePosition other = image_of(points_[j], image);
                const std::uint32_t squared = squared_between(points_[i], other, settings_.dimension);
                if (squared > limit) continue;
                const double length = std::sqrt(static_cast<double>(squared));
                const bool moves = j >= active_begin_ && j < active_end_;
                const double push = (moves ? 0.5 : 1) * (distance - length);
                if (squared == 0) {
                    sum[0] += i < j ? -push : push;
                    continue;
                }
                for (std::size_t k = 0; k < dimension(); ++k)
                    sum[k] -= shortest(other[k] - points_[i][k]) / length * push;
            }
        }
        return limited(sum);
    }

    /// Shortens a movement to the distance that points are pushed to, at most.
    TilePosition limited(const std::array<double, 3>& sum) const
    {
        return limited_movement(sum, settings_.repulsion_distance, settings_.dimension);
    }

    const FillSettings& settings_;
    const FillStage& stage_;
    std::vector<TilePosition> points_;
    std::vector<TilePosition> polygon_; ///< none: points lie in cells
    std::size_t active_begin_;
    std::size_t active_end_ = 0;
    std::vector<Monomial> monomials_; ///< whose sums are wanted
    MomentStep moment_step_;
};

class ReferenceFiller final : public TileFiller
{
public:
    explicit ReferenceFiller(const FillSettings& settings) : settings_(settings) {}

    std::vector<FilledTorus> fill(const FillStage& stage, std::span<const FillProblem> problems,
                                  std::uint32_t attempt) override
    {
        std::vector<FilledTorus> results;
        for (const FillProblem& problem : problems) results.push_back(fill(stage, problem, attempt));
        return results;
    }

private:
    FilledTorus fill(const FillStage& stage, const FillProblem& problem, std::uint32_t attempt) const
    {
        Filling filling(settings_, stage, problem);
        FilledTorus result;
        const bool is_filled = filling.throw_darts(stage.active, problem.active, settings_.attempts, problem.stream,
                                                   attempt, 2 * stage.number);
        filling.mark_active_end();
        result.thrown = filling.active();
        if (!is_filled) return result;
        filling.throw_darts(stage.surroundings, problem.active + problem.surroundings, settings_.surrounding_attempts,
                            problem.stream, attempt, 2 * stage.number + 1);
        result.thrown_surroundings = filling.surroundings();
        filling.relax();
        const bool repels = settings_.repulsion_passes > 0;
        const std::uint32_t reached = repels ? filling.repel() : filling.squared_min_distance();
        result.active = filling.active();
        result.surroundings = filling.surroundings();
        result.squared_min_distance = reached;
        return result;
    }

    FillSettings settings_;
};

}

std::unique_ptr<TileFiller> make_tile_filler(const FillSettings& settings)
{
    return std::make_unique<ReferenceFiller>(settings);
}

}
