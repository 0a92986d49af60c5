#include "host/tile_construction/moments/exact_moments.hpp"

#include "host/tile_construction/moments/ways_to_move.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <tuple>

namespace poissonlab {
namespace {

/// A reach is how far a point may move along an axis: in rough steps, and along y in the search that follows.
constexpr int rough_reach = 1, upright_reach = 1;

/// The size of a search. Points move along y by a unit at most, and some of them along x. The ways to move those that
/// are listed are in a table; it should fit into a fast memory, and ways of the others are looked up in it.
struct SearchSize
{
    std::size_t listed, others, level_others;
    int level_reach;

    std::size_t points() const { return listed + others; }
};

/// Quick searches come before long ones.
constexpr std::array<SearchSize, 3> search_sizes{{{9, 9, 9, 1}, {7, 9, 7, 2}, {7, 9, 9, 2}}};
static_assert(std::ranges::all_of(search_sizes, [](const SearchSize& size) {
    return rough_reach + size.level_reach <= exact_reach && rough_reach + upright_reach <= exact_reach;
}));
constexpr std::size_t rough_points = 32; ///< that are moved by pairs
constexpr int most_rough_steps = 200;

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

/// Settles first moments by single units and brings second moments near, then finds movements of a few points by which
/// all are right. The ways that make the sums of y and of its squares right, and those that make those of x right, are
/// each found once, by a table of half of the points; one of each has to be found whose sum of products is right, where
/// what they change together is small: those along x are sorted by theirs.
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
        std::vector<UprightWay> upright; // depends on the points that are searched alone
        std::optional<std::array<Half, 2>> before;
        return std::ranges::any_of(search_sizes, [&](const SearchSize& size) {
            choose_points(size);
            if (before != halves_) upright = upright_ways();
            before = halves_;
            return search(upright, level_ways());
        });
    }

private:
    using Ways = std::array<std::size_t, 2>; ///< of both halves

    /// Movements along y after which the sums of y and of its squares are right.
    struct UprightWay
    {
        std::int64_t left; ///< of the sum of products
        Ways ways;
    };

    /// Movements along x after which the sums of x and of its squares are right.
    struct LevelWay
    {
        std::int64_t product; ///< what they change of the sum of products where nothing moves along y
        Ways ways;
    };

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

    /// Measures how far second moments are off, as a sum of squares.
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

    /// Makes first moments exact by steps of one unit, each of the point that helps second moments most.
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

    /// Chooses the points nearest to the middle: they change second moments by the smallest numbers.
    void choose_points(const SearchSize& size)
    {
        std::vector<std::size_t> order(points_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {},
                                 [&](std::size_t i) { return std::abs(points_[i][0]) + std::abs(points_[i][1]); });
        order.resize(std::min(order.size(), size.points()));
        halves_ = {};
        for (std::size_t i = 0; i < order.size(); ++i)
            halves_[halves_[0].points.size() == size.listed ? 1 : i % 2].points.push_back(order[i]);
        level_ = halves_;
        level_[1].points.resize(std::min(size.level_others, level_[1].points.size()));
        level_reach_ = size.level_reach;
    }

    /// Finds the ways along y, those first that leave least of the sum of products.
    std::vector<UprightWay> upright_ways() const
    {
        const auto change = [&](std::size_t i, std::int64_t by) { return mixture(by, (2 * points_[i][1] + by) * by); };
        const auto product = [&](std::size_t i, std::int64_t by) {
            return static_cast<std::uint64_t>(points_[i][0] * by);
        };
        const std::uint64_t wanted = mixture(lacking_[in_y], lacking_[in_yy]);
        std::vector<UprightWay> found;
        for_each_way(halves_, upright_reach, change, product, wanted, [&](const Ways& ways, std::int64_t changed) {
            found.push_back({lacking_[in_xy] - changed, ways});
        });
        std::ranges::sort(found, {}, [](const UprightWay& way) { return std::tuple(std::abs(way.left), way.ways); });
        return found;
    }

    /// Finds the ways along x, sorted by their product.
    std::vector<LevelWay> level_ways() const
    {
        const auto change = [&](std::size_t i, std::int64_t by) { return mixture(by, (2 * points_[i][0] + by) * by); };
        const auto product = [&](std::size_t i, std::int64_t by) {
            return static_cast<std::uint64_t>(points_[i][1] * by);
        };
        const std::uint64_t wanted = mixture(lacking_[in_x], lacking_[in_xx]);
        std::vector<LevelWay> found;
        for_each_way(level_, level_reach_, change, product, wanted, [&](const Ways& ways, std::int64_t changed) {
            found.push_back({changed, ways});
        });
        std::ranges::sort(found, {}, [](const LevelWay& way) { return std::tuple(way.product, way.ways); });
        return found;
    }

    /// Visits the ways of two halves whose changes together are those that are wanted, with the sum of their products.
    template <class Change, class Product, class Visit>
    static void for_each_way(const std::array<Half, 2>& halves, int reach, const Change& change, const Product& product,
                             std::uint64_t wanted, const Visit& visit)
    {
        static thread_local WayTable table; // of megabytes, for many tiles
        table.fill(halves[0].changes(reach, change));
        const Sums first = halves[0].changes(reach, product), second = halves[1].changes(reach, product);
        halves[1].changes(reach, change).for_each([&](std::size_t way, std::uint64_t changed) {
            table.for_each(wanted - changed, [&](std::size_t other) {
                visit(Ways{other, way}, static_cast<std::int64_t>(first[other] + second[way]));
            });
        });
    }

    /// Moves points by the first ways that make the sum of products right as well; false: there are none.
    bool search(const std::vector<UprightWay>& upright, const std::vector<LevelWay>& level)
    {
        for (const UprightWay& up : upright) {
            // Both ways together change the sum by at most this.
            const auto most = static_cast<std::int64_t>(points_.size()) * upright_reach * level_reach_;
            auto across = std::ranges::lower_bound(level, up.left - most, {}, &LevelWay::product);
            for (; across != level.end() && across->product <= up.left + most; ++across)
                if (across->product + common_product(up.ways, across->ways) == up.left) {
                    move_all(halves_, up.ways, 1, upright_reach);
                    move_all(level_, across->ways, 0, level_reach_);
                    return true;
                }
        }
        return false;
    }

    /// The sum of products of movements along both axes.
    std::int64_t common_product(Ways upright, Ways across) const
    {
        const auto base = [](int reach) { return static_cast<std::size_t>(2 * reach + 1); };
        const std::size_t upright_base = base(upright_reach), level_base = base(level_reach_);
        std::int64_t sum = 0;
        for (std::size_t h = 0; h < 2; ++h)
            for (std::size_t i = 0; i < level_[h].points.size(); ++i) {
                sum += (static_cast<std::int64_t>(upright[h] % upright_base) - upright_reach) *
                       (static_cast<std::int64_t>(across[h] % level_base) - level_reach_);
                upright[h] /= upright_base;
                across[h] /= level_base;
            }
        return sum;
    }

    void move_all(const std::array<Half, 2>& halves, const Ways& ways, std::size_t axis, int reach)
    {
        for (std::size_t h = 0; h < 2; ++h)
            for (std::size_t i = 0; i < halves[h].points.size(); ++i)
                move(halves[h].points[i], axis, Half::movement(i, ways[h], reach));
    }

    std::vector<StoredFromMiddle>& points_;
    std::vector<StoredFromMiddle> moved_; ///< by rough steps
    std::array<Half, 2> halves_, level_;  ///< of all searched points, and of those that move along x
    int level_reach_ = 0;
    Conditions lacking_{}; ///< wanted less found
};

/// Makes sums exact by steps of one unit, which move each point at most by the reach.
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
