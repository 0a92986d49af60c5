#include "host/tile_construction/moments/exact_moments.hpp"

#include "host/tile_construction/moments/ways_to_move.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>

namespace poissonlab {
namespace {

/// What the parts of the search may move a point by: rough steps, then along y, then along x.
constexpr int rough_reach = 1, upright_reach = 1, level_reach = 2;
static_assert(rough_reach + level_reach <= exact_reach && rough_reach + upright_reach <= exact_reach);

constexpr std::size_t searched_points = 16;
constexpr std::ptrdiff_t listed_points = 7; ///< of them, all ways of which are listed at once
constexpr std::size_t rough_points = 32;    ///< that are moved by pairs
constexpr int most_rough_steps = 200;
constexpr std::size_t most_searches = 12;

/// The indices of monomials_up_to(2, 2): x, y, xx, xy, yy.
enum Condition : std::size_t
{
    in_x,
    in_y,
    in_xx,
    in_xy,
    in_yy
};
using Conditions = std::array<std::int64_t, 5>;

class ExactSearch
{
public:
    ExactSearch(std::vector<StoredFromMiddle>& points, const std::vector<std::int64_t>& wanted)
        : points_(points), moved_(points.size())
    {
        std::copy_n(wanted.begin(), lacking_.size(), lacking_.begin());
        for (const StoredFromMiddle& at : points) {
            lacking_[in_x] -= at[0];
            lacking_[in_y] -= at[1];
            lacking_[in_xx] -= at[0] * at[0];
            lacking_[in_xy] -= at[0] * at[1];
            lacking_[in_yy] -= at[1] * at[1];
        }
    }

    bool run()
    {
        if (!settle_first_moments()) return false;
        approach();
        choose_points();
        const Conditions rough = lacking_;
        const std::vector<StoredFromMiddle> start = points_;
        for (const auto& ways : upright_ways()) {
            move_all(ways, 1, upright_reach);
            if (search_level() && lacking_ == Conditions{}) return true;
            lacking_ = rough;
            points_ = start;
        }
        return false;
    }

private:
    using Ways = std::array<std::size_t, 2>; ///< of both halves

    void move(std::size_t point, std::size_t axis, std::int64_t by)
    {
        lacking_ = after(lacking_, point, axis, by);
        points_[point][axis] += by;
    }

    Conditions after(Conditions lacking, std::size_t point, std::size_t axis, std::int64_t by) const
    {
        const StoredFromMiddle& at = points_[point];
        lacking[in_x + axis] -= by;
        lacking[axis == 0 ? in_xx : in_yy] -= (2 * at[axis] + by) * by;
        lacking[in_xy] -= at[1 - axis] * by;
        return lacking;
    }

    /// How far second moments are off.
    static double cost(const Conditions& lacking)
    {
        double sum = 0;
        for (const Condition c : {in_xx, in_xy, in_yy}) {
            const auto part = static_cast<double>(lacking[c]) / (c == in_xy ? 1 : 2);
            sum += part * part;
        }
        return sum;
    }

    bool may_move(std::size_t point, std::size_t axis, std::int64_t by) const
    {
        return std::abs(moved_[point][axis] + by) <= rough_reach;
    }

    void move_roughly(std::size_t point, std::size_t axis, std::int64_t by)
    {
        move(point, axis, by);
        moved_[point][axis] += by;
    }

    /// By single units, each of the point that helps second moments most.
    bool settle_first_moments()
    {
        for (std::size_t axis = 0; axis < 2; ++axis)
            while (lacking_[axis] != 0) {
                const std::int64_t by = lacking_[axis] > 0 ? 1 : -1;
                std::size_t best = points_.size();
                double least = HUGE_VAL;
                for (std::size_t i = 0; i < points_.size(); ++i) {
                    if (!may_move(i, axis, by)) continue;
                    const double found = cost(after(lacking_, i, axis, by));
                    if (found < least) least = found, best = i;
                }
                if (best == points_.size()) return false;
                move_roughly(best, axis, by);
            }
        return true;
    }

    /// Moves pairs of points towards or away from each other along an axis, while second moments get nearer.
    void approach()
    {
        for (int step = 0; step < most_rough_steps; ++step) {
            double least = cost(lacking_);
            std::array<std::size_t, 3> best{points_.size(), 0, 0};
            const std::size_t count = std::min(rough_points, points_.size());
            for (std::size_t axis = 0; axis < 2; ++axis)
                for (std::size_t i = 0; i < count; ++i) {
                    if (!may_move(i, axis, 1)) continue;
                    const Conditions first = after(lacking_, i, axis, 1);
                    for (std::size_t j = 0; j < count; ++j) {
                        if (i == j || !may_move(j, axis, -1)) continue;
                        const double found = cost(after(first, j, axis, -1));
                        if (found < least) least = found, best = {i, j, axis};
                    }
                }
            if (best[0] == points_.size()) return;
            move_roughly(best[0], best[2], 1);
            move_roughly(best[1], best[2], -1);
        }
    }

    /// Those nearest to the middle: they change second moments by the smallest numbers.
    void choose_points()
    {
        std::vector<std::size_t> order(points_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {},
                                 [&](std::size_t i) { return std::abs(points_[i][0]) + std::abs(points_[i][1]); });
        order.resize(std::min(order.size(), searched_points));
        for (std::size_t i = 0; i < order.size(); ++i) halves_[i % 2].points.push_back(order[i]);
        // Few ways fit into a fast memory, and those of the others are looked at until one is found.
        auto& first = halves_[0].points;
        auto& second = halves_[1].points;
        if (std::ssize(first) > listed_points) {
            second.insert(second.end(), first.begin() + listed_points, first.end());
            first.resize(listed_points);
        }
    }

    /// Movements along y that make the sums of y and of its squares right, those first that leave least of the third
    /// condition.
    std::vector<Ways> upright_ways()
    {
        const auto change = [&](std::size_t i, std::int64_t by) { return mixture(by, (2 * points_[i][1] + by) * by); };
        const auto mixed = [&](std::size_t i, std::int64_t by) {
            return static_cast<std::uint64_t>(points_[i][0] * by);
        };
        const auto first = halves_[0].changes(upright_reach, change),
                   second = halves_[1].changes(upright_reach, change);
        const auto first_mixed = halves_[0].changes(upright_reach, mixed);
        const auto second_mixed = halves_[1].changes(upright_reach, mixed);
        std::multimap<std::uint64_t, std::size_t> by_change;
        for (std::size_t way = 0; way < first.size(); ++way) by_change.emplace(first[way], way);
        const std::uint64_t wanted = mixture(0, lacking_[in_yy]);
        std::vector<std::pair<std::int64_t, Ways>> found;
        for (std::size_t way = 0; way < second.size(); ++way) {
            const auto [from, to] = by_change.equal_range(wanted - second[way]);
            for (auto it = from; it != to; ++it) {
                const auto left = lacking_[in_xy] - static_cast<std::int64_t>(first_mixed[it->second]) -
                                  static_cast<std::int64_t>(second_mixed[way]);
                found.push_back({std::abs(left), {it->second, way}});
            }
        }
        const auto count = static_cast<std::ptrdiff_t>(std::min(found.size(), most_searches));
        std::partial_sort(found.begin(), found.begin() + count, found.end());
        std::vector<Ways> ways;
        for (std::ptrdiff_t i = 0; i < count; ++i) ways.push_back(found[static_cast<std::size_t>(i)].second);
        return ways;
    }

    void move_all(const Ways& ways, std::size_t axis, int reach)
    {
        for (std::size_t h = 0; h < 2; ++h)
            for (std::size_t i = 0; i < halves_[h].points.size(); ++i)
                move(halves_[h].points[i], axis, Half::movement(i, ways[h], reach));
    }

    /// Movements along x that make all that is left right: each way of one part, with one of the other from a table.
    bool search_level()
    {
        const auto change = [&](std::size_t i, std::int64_t by) {
            return mixture(by, (2 * points_[i][0] + by) * by, points_[i][1] * by);
        };
        Half inner = halves_[1], outer;
        if (std::ssize(inner.points) > listed_points) {
            outer.points.assign(inner.points.begin() + listed_points, inner.points.end());
            inner.points.resize(listed_points);
        }
        const WayTable table(halves_[0].changes(level_reach, change));
        const auto inner_changes = inner.changes(level_reach, change),
                   outer_changes = outer.changes(level_reach, change);
        const std::uint64_t wanted = mixture(lacking_[in_x], lacking_[in_xx], lacking_[in_xy]);
        for (std::size_t o = 0; o < outer_changes.size(); ++o)
            for (std::size_t i = 0; i < inner_changes.size(); ++i)
                if (const auto way = table.find(wanted - outer_changes[o] - inner_changes[i])) {
                    move_all({*way, o * inner_changes.size() + i}, 0, level_reach);
                    return true;
                }
        return false;
    }

    std::vector<StoredFromMiddle>& points_;
    std::vector<StoredFromMiddle> moved_; ///< by rough steps
    std::array<Half, 2> halves_;
    Conditions lacking_{}; ///< wanted less found
};

/// By single units, each point at most by the reach.
bool settle_sums(std::vector<StoredFromMiddle>& points, const std::vector<std::int64_t>& wanted, int dimension)
{
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
        std::int64_t lacking = wanted[axis];
        for (const StoredFromMiddle& at : points) lacking -= at[axis];
        const auto most = exact_reach * static_cast<std::int64_t>(points.size());
        if (std::abs(lacking) > most) return false;
        for (std::size_t i = 0; lacking != 0; i = (i + 1) % points.size()) {
            const std::int64_t by = lacking > 0 ? 1 : -1;
            points[i][axis] += by;
            lacking -= by;
        }
    }
    return true;
}

}

bool make_moments_exact(std::vector<StoredFromMiddle>& points, const std::vector<std::int64_t>& wanted,
                        std::uint32_t order, int dimension)
{
    if (order < 2 || dimension == 3) return settle_sums(points, wanted, dimension);
    return ExactSearch(points, wanted).run();
}

}
