#include "tiles/isohedral/tile_search.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "tiles/isohedral/tile_fit.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace poissonlab {
namespace {

constexpr std::size_t coarse_steps = 36; // a multiple of 12, as the most symmetric tiles need
constexpr std::size_t finer = 4;         // steps of refined tiles for each of these
constexpr std::size_t refined = 16;      // tiles of a type
constexpr std::size_t compared = 2;      // each of so many of their steps: directions
constexpr double farthest = 2;           // distances over the least one, of what is looked at further

/// A cut of the goal's outline into edges: the step at which the first begins, and pieces of the edges of each curve.
struct Cut
{
    double likeness = 0;
    std::size_t start = 0;
    std::vector<std::size_t> pieces;
};

/// The best cut of each start into equal steps, most alike first.
std::vector<Cut> coarse_cuts(const TileFit& fit, const GoalOutline& goal, std::uint64_t& candidates)
{
    const std::vector<PlanePoint> points = goal.places(coarse_steps);
    std::vector<PlaneStep> steps; // twice around
    double all = 0;
    for (std::size_t i = 0; i < 2 * coarse_steps; ++i) {
        const PlanePoint &a = points[i % coarse_steps], &b = points[(i + 1) % coarse_steps];
        steps.emplace_back(b[0] - a[0], b[1] - a[1]);
        if (i < coarse_steps) all += std::norm(steps.back());
    }
    const std::vector<std::size_t>& edges = fit.edges_of_curves();
    const std::vector<double> weights(fit.type().shape.base.size(), 1 / all);
    std::vector<Cut> best(coarse_steps);
    GoalSteps goal_steps{std::vector<std::size_t>(edges.size()), weights, nullptr};
    const auto cut = [&](const auto& self, std::size_t curve, std::size_t left) -> void {
        if (curve + 1 == edges.size()) {
            if (left == 0 || left % edges[curve] != 0) return;
            goal_steps.pieces[curve] = left / edges[curve];
            candidates += coarse_steps;
            for (std::size_t start = 0; start < coarse_steps; ++start) {
                goal_steps.steps = &steps[start];
                const double likeness = fit.likeness(goal_steps);
                if (likeness > best[start].likeness) best[start] = {likeness, start, goal_steps.pieces};
            }
            return;
        }
        stop_if_interrupted();
        for (std::size_t pieces = 1; pieces * edges[curve] < left; ++pieces) {
            goal_steps.pieces[curve] = pieces;
            self(self, curve + 1, left - pieces * edges[curve]);
        }
    };
    cut(cut, 0, coarse_steps);
    std::ranges::stable_sort(best, std::ranges::greater(), &Cut::likeness);
    return best;
}

/// Moves the corners of a cut along the outline.
class CornerDescent
{
public:
    CornerDescent(const TileFit& fit, const GoalOutline& goal, const Cut& cut) : fit_(fit), goal_(goal)
    {
        std::size_t at = cut.start;
        for (const EdgeCurve& edge : fit.type().shape.edge_curves) {
            corners_.push_back(static_cast<double>(at) / coarse_steps);
            at += cut.pieces[edge.curve];
        }
        for (const std::size_t pieces : cut.pieces) goal_steps_.pieces.push_back(finer * pieces);
        goal_steps_.weights.resize(corners_.size());
    }

    /// The nearest tile; likeness 1 is a goal that is one.
    TileFit::Nearest run()
    {
        likeness_ = likeness();
        constexpr double least = 1e-6;
        bool has_moved = true;
        for (double step = 0.5 / coarse_steps; step > least; step = has_moved ? step : step / 2)
            has_moved = moves(step);
        likeness();
        TileFit::Nearest nearest = fit_.nearest(goal_steps_);
        nearest.likeness = likeness_;
        return nearest;
    }

    /// Places of the goal where the tile's outline has points.
    const std::vector<PlanePoint>& places() const { return places_; }

private:
    /// Cuts the goal anew.
    double likeness()
    {
        const std::size_t n = corners_.size();
        places_.clear();
        steps_.clear();
        double all = 0;
        for (std::size_t e = 0; e < n; ++e) {
            const double from = corners_[e], to = e + 1 < n ? corners_[e + 1] : corners_[0] + 1;
            const std::size_t pieces = goal_steps_.pieces[fit_.type().shape.edge_curves[e].curve];
            goal_.append_places(from, to, pieces, places_);
            goal_steps_.weights[e] = static_cast<double>(pieces) / (to - from);
        }
        std::size_t at = 0;
        for (std::size_t e = 0; e < n; ++e)
            for (std::size_t i = goal_steps_.pieces[fit_.type().shape.edge_curves[e].curve]; i > 0; --i, ++at) {
                const PlanePoint &a = places_[at], &b = places_[(at + 1) % places_.size()];
                steps_.emplace_back(b[0] - a[0], b[1] - a[1]);
                all += goal_steps_.weights[e] * std::norm(steps_.back());
            }
        goal_steps_.steps = steps_.data();
        return fit_.likeness(goal_steps_) / all;
    }

    bool is_apart() const
    {
        constexpr double shortest = 0.25 / coarse_steps;
        for (std::size_t e = 0; e < corners_.size(); ++e)
            if ((e + 1 < corners_.size() ? corners_[e + 1] : corners_[0] + 1) - corners_[e] < shortest) return false;
        return true;
    }

    /// Moves each run of corners once. Returns true if some move helped.
    bool moves(double step)
    {
        bool has_moved = false;
        for (std::size_t length = 1; length <= corners_.size(); ++length)
            for (std::size_t first = 0; first < (length < corners_.size() ? corners_.size() : 1); ++first)
                for (const double by : {step, -step}) {
                    const std::vector<double> before = corners_;
                    for (std::size_t i = 0; i < length; ++i) corners_[(first + i) % corners_.size()] += by;
                    const double now = is_apart() ? likeness() : 0;
                    if (now > likeness_ + 1e-12) {
                        likeness_ = now;
                        has_moved = true;
                    } else
                        corners_ = before;
                }
        return has_moved;
    }

    const TileFit& fit_;
    const GoalOutline& goal_;
    std::vector<double> corners_;
    std::vector<PlanePoint> places_;
    std::vector<PlaneStep> steps_;
    GoalSteps goal_steps_;
    double likeness_ = 0;
};

/// The map of the goal that brings its places nearest to those of the tile.
void align(GoalTile& tile, const std::vector<PlanePoint>& places, const std::vector<PlanePoint>& outline)
{
    const auto step = [](const PlanePoint& p) { return PlaneStep(p[0], p[1]); };
    const auto middle_of = [&](const std::vector<PlanePoint>& all) {
        PlaneStep sum{};
        for (const PlanePoint& p : all) sum += step(p);
        return sum / static_cast<double>(all.size());
    };
    const PlaneStep from = middle_of(places), to = middle_of(outline);
    PlaneStep product{};
    double square = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        product += (step(outline[i]) - to) * std::conj(step(places[i]) - from);
        square += std::norm(step(places[i]) - from);
    }
    const PlaneStep scale = product / square, shift = to - scale * from;
    tile.scale = {scale.real(), scale.imag()};
    tile.shift = {shift.real(), shift.imag()};
}

/// True where places of the tile that are no neighbours come much nearer than they are in the goal: slivers and slits.
bool is_narrow(const GoalTile& tile, const std::vector<PlanePoint>& places, const std::vector<PlanePoint>& outline)
{
    constexpr double least_share = 0.3; // of their distance in the goal
    const std::size_t n = places.size(), beside = n / 16;
    const auto square = [](const PlanePoint& a, const PlanePoint& b) {
        return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
    };
    const double share = least_share * least_share * square(tile.scale, {0, 0});
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + beside; j < std::min(n, i + n - beside); ++j)
            if (square(outline[i], outline[j]) < share * square(places[i], places[j])) return true;
    return false;
}

/// Cuts of one type.
struct TypeCuts
{
    TileFit fit;
    std::vector<Cut> cuts{};
    std::uint64_t candidates = 0;
};

/// A tile with places of the goal and of its outline that belong together.
struct RefinedTile
{
    GoalTile tile;
    std::vector<PlanePoint> places{}, outline{};
};

/// The tile that corners find from a cut on; none if its outline crosses itself.
std::optional<RefinedTile> refined_tile(const TileFit& fit, const GoalOutline& goal, const Cut& cut)
{
    stop_if_interrupted();
    CornerDescent descent(fit, goal, cut);
    const TileFit::Nearest nearest = descent.run();
    const int type = fit.type().number;
    RefinedTile found{
        {type, &fit.type() == mirrored_type(type), nearest.parameters, std::sqrt(std::max(0.0, 1 - nearest.likeness))}};
    try {
        const IsohedralTile tile(fit.type(), nearest.parameters);
    } catch (const InputError&) {
        return {}; // its outline crosses itself, or an edge has no length
    }
    align(found.tile, descent.places(), nearest.outline);
    found.tile.is_narrow = is_narrow(found.tile, descent.places(), nearest.outline);
    for (std::size_t i = 0; i < nearest.outline.size(); i += compared) {
        found.places.push_back(descent.places()[i]);
        found.outline.push_back(nearest.outline[i]);
    }
    return found;
}

/// Leaves out tiles far from the best one, and those that several cuts have become.
void keep_different(std::vector<RefinedTile>& tiles)
{
    constexpr double equal = 1e-6;
    constexpr int most = 4; // of a type
    std::ranges::stable_sort(tiles, {}, [](const RefinedTile& t) { return std::pair(t.tile.type, t.tile.distance); });
    const auto same = std::ranges::unique(tiles, [&](const RefinedTile& a, const RefinedTile& b) {
        return a.tile.type == b.tile.type && std::abs(a.tile.distance - b.tile.distance) < equal;
    });
    tiles.erase(same.begin(), same.end());
    double least = 1;
    for (const RefinedTile& t : tiles) least = std::min(least, t.tile.distance);
    int type = 0, count = 0;
    std::erase_if(tiles, [&](const RefinedTile& t) {
        count = t.tile.type == type ? count + 1 : 1;
        type = t.tile.type;
        return count > most || t.tile.distance > farthest * least + equal;
    });
}

/// Cuts of all types that may become the best tile.
std::vector<std::pair<const TileFit*, const Cut*>> best_cuts(const std::vector<TypeCuts>& types)
{
    double most = 0;
    for (const TypeCuts& type : types) most = std::max(most, type.cuts[0].likeness);
    const double most_lost = farthest * farthest * std::max(0.0, 1 - most) + 1e-12; // exact cuts lose by rounding
    std::vector<std::pair<const TileFit*, const Cut*>> best;
    for (const TypeCuts& type : types)
        for (std::size_t i = 0; i < refined && type.cuts[i].likeness > 0; ++i)
            if (1 - type.cuts[i].likeness <= most_lost) best.emplace_back(&type.fit, &type.cuts[i]);
    return best;
}

}

const IsohedralType& type_of(const GoalTile& tile)
{
    return tile.is_mirrored ? *mirrored_type(tile.type) : isohedral_types()[static_cast<std::size_t>(tile.type - 1)];
}

GoalSearch tiles_like(const GoalOutline& goal, const std::vector<int>& types)
{
    std::vector<TypeCuts> all;
    for (const int type : types) {
        all.push_back({TileFit(isohedral_types()[static_cast<std::size_t>(type - 1)])});
        if (const IsohedralType* const mirrored = mirrored_type(type)) all.push_back({TileFit(*mirrored)});
    }
    tbb::parallel_for(std::size_t{0}, all.size(),
                      [&](std::size_t i) { all[i].cuts = coarse_cuts(all[i].fit, goal, all[i].candidates); });
    const auto cuts = best_cuts(all);
    std::vector<std::optional<RefinedTile>> found(cuts.size());
    tbb::parallel_for(std::size_t{0}, cuts.size(),
                      [&](std::size_t i) { found[i] = refined_tile(*cuts[i].first, goal, *cuts[i].second); });
    std::vector<RefinedTile> tiles;
    for (auto& tile : found)
        if (tile) tiles.push_back(std::move(*tile));
    keep_different(tiles);
    tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
        tiles[i].tile.turning = turning_distance(tiles[i].outline, tiles[i].places);
    });
    std::ranges::stable_sort(tiles, {},
                             [](const RefinedTile& t) { return std::pair(t.tile.is_narrow, t.tile.turning); });
    GoalSearch search{{}, cuts.size()};
    for (const TypeCuts& type : all) search.candidates += type.candidates;
    for (RefinedTile& refined_one : tiles)
        if (std::ranges::find(search.tiles, refined_one.tile.type, &GoalTile::type) == search.tiles.end())
            search.tiles.push_back(std::move(refined_one.tile));
    return search;
}

}
