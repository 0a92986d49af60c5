// Fills tori with points of several classes one after the other: the plain twin of kernels/class_tiles.cl.
#include "host/tile_construction/classes/class_filling.hpp"
#include "host/tile_construction/reference/filling_steps.hpp"

#include "kernels/common/tiles/class_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab::reference {
namespace {

/// A torus while it is filled.
class ClassFilling
{
public:
    ClassFilling(const ClassFillSettings& settings, const FillStage& stage, const ClassFillProblem& problem)
        : settings_(settings), zone_{stage.regions, stage.active.cells}
    {
        for (std::uint32_t i = 0; i < settings.classes(); ++i)
            for (const TilePosition& point : problem.held[i]) add(point, i);
        active_begin_ = points_.size();
    }

    /// Returns whether all points fit.
    bool throw_darts(const FillStage& stage, const ClassFillProblem& problem, std::uint32_t attempt)
    {
        std::size_t level = 0;
        std::uint32_t failures = 0, dart = 0;
        for (const std::uint32_t own : settings_.order) {
            for (std::uint32_t placed = 0; placed < problem.active[own];) {
                if (level == settings_.parts.size() || dart == contract::tile_filling::MAX_DARTS) return false;
                const TilePosition position = dart_at(
                    stage.active, dimension(), {dart++, problem.stream, attempt, stage.number}, settings_.stream);
                if (!is_allowed(zone_, position)) continue;
                if (part_kept(position, own, points_.size()) >= settings_.parts[level]) {
                    add(position, own);
                    ++placed;
                    failures = 0;
                } else if (++failures == settings_.attempts) {
                    failures = 0;
                    ++level;
                }
            }
        }
        return true;
    }

    /// Pushes points apart until they keep all distances, or else takes the best of all passes. Returns the part of the
    /// squared distances kept.
    std::uint32_t push()
    {
        std::uint32_t best = 0;
        std::vector<TilePosition> kept;
        for (std::uint32_t pass = 0;; ++pass) {
            std::uint32_t part = contract::class_tiles::MOST_PART;
            for (std::size_t i = active_begin_; i < points_.size(); ++i)
                part = std::min(part, part_kept(points_[i], classes_[i], i));
            if (pass == 0 || part > best) {
                best = part;
                kept = points_;
            }
            if (part >= whole_part || pass == settings_.passes) break;
            std::vector<TilePosition> moved = points_;
            for (std::size_t i = active_begin_; i < points_.size(); ++i)
                moved[i] = allowed_end(zone_, points_[i], movement(i), true);
            points_ = moved;
        }
        points_ = kept;
        return best;
    }

    ClassedPositions active() const
    {
        ClassedPositions active(settings_.classes());
        for (std::size_t i = active_begin_; i < points_.size(); ++i) active[classes_[i]].push_back(points_[i]);
        return active;
    }

private:
    int dimension() const { return zone_.regions.dimension; }

    void add(const TilePosition& position, std::uint32_t of)
    {
        points_.push_back(position);
        classes_.push_back(of);
    }

    /// The part of the squared distances that a point of a class keeps from all points but the one numbered `self`.
    std::uint32_t part_kept(const TilePosition& position, std::uint32_t own, std::size_t self) const
    {
        std::uint64_t least = contract::class_tiles::MOST_PART;
        for (std::size_t j = 0; j < points_.size(); ++j) {
            if (j == self) continue;
            const std::uint64_t squared = squared_between(position, points_[j], dimension());
            const std::uint64_t wanted = settings_.wanted[own * settings_.classes() + classes_[j]];
            least = std::min(least, (squared << contract::class_tiles::PART_BITS) / wanted);
        }
        return static_cast<std::uint32_t>(least);
    }

    /// Away from all points that are too near, by what they lack of the distance, half of it where the other one moves.
    TilePosition movement(std::size_t i) const
    {
        std::array<double, 3> sum{};
        double limit = 0; // the largest distance of those that push
        for (std::size_t j = 0; j < points_.size(); ++j) {
            if (i == j) continue;
            const double distance = settings_.pushed[classes_[i] * settings_.classes() + classes_[j]];
            const std::uint32_t squared = squared_between(points_[i], points_[j], dimension());
            if (squared > static_cast<std::uint32_t>(distance * distance)) continue;
            limit = std::max(limit, distance);
            const double length = std::sqrt(static_cast<double>(squared));
            const double push = (j >= active_begin_ ? 0.5 : 1) * (distance - length);
            if (squared == 0) {
                sum[0] += i < j ? -push : push;
                continue;
            }
            for (std::size_t k = 0; k < static_cast<std::size_t>(dimension()); ++k)
                sum[k] -= shortest(points_[j][k] - points_[i][k]) / length * push;
        }
        return limited_movement(sum, limit, dimension());
    }

    const ClassFillSettings& settings_;
    Zone zone_;
    std::vector<TilePosition> points_; ///< held ones first
    std::vector<std::uint32_t> classes_;
    std::size_t active_begin_ = 0;
};

class ReferenceClassFiller final : public ClassTileFiller
{
public:
    explicit ReferenceClassFiller(const ClassFillSettings& settings) : settings_(settings) {}

    std::vector<ClassFilledTorus> fill(const FillStage& stage, std::span<const ClassFillProblem> problems,
                                       std::uint32_t attempt) override
    {
        std::vector<ClassFilledTorus> results;
        for (const ClassFillProblem& problem : problems) {
            ClassFilling filling(settings_, stage, problem);
            ClassFilledTorus result;
            if (filling.throw_darts(stage, problem, attempt)) {
                result.part = filling.push();
                result.active = filling.active();
            }
            results.push_back(std::move(result));
        }
        return results;
    }

private:
    ClassFillSettings settings_;
};

}

std::unique_ptr<ClassTileFiller> make_class_tile_filler(const ClassFillSettings& settings)
{
    return std::make_unique<ReferenceClassFiller>(settings);
}

}
