// The closest pair on the torus, by a hashed grid whose cells follow the smallest distance seen so far.
//
// Points enter one by one and are compared with those in the 3^d cells around them. Cells are at least as
// wide as the smallest distance so far, so no closer pair is missed; when they are more than twice as wide,
// the grid is rebuilt. Hence a cell holds a bounded number of points however clustered the set is, every
// rebuild halves the cells, and the whole costs O(N) for well-spread points (no rebuild: the cells start at
// the width of the densest packing) and O(N log(1/distance)) for any others. Compare Khuller and Matias, A
// simple randomized sieve algorithm for the closest-pair problem (1995).
#include "analysis/measures/distance_statistics.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "base/geometry/window.hpp"
#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace poissonlab {

namespace {

/// Cells along an axis, at most 2^40 so that rounding coordinate * cells stays far below the slack.
constexpr double max_cells = 0x1p40;
/// Cells are wider than the distance that they must cover by this factor, far more than rounding takes away.
constexpr double slack = 1.0 + 0x1p-10;

/// Points in grid cells, chained by a hash of the cell. Chains may mix cells: that costs time, never a pair.
template <int D>
class HashedGrid
{
    using Cell = std::array<std::uint64_t, D>;

public:
    HashedGrid(std::size_t capacity, const PeriodicBox& box)
        : sides_(box.sides), heads_(std::bit_ceil(2 * capacity), none), next_(capacity)
    {}

    /// Empties the grid; from now on all pairs within `reach` lie in cells that touch.
    void reset(double reach)
    {
        std::fill(heads_.begin(), heads_.end(), none);
        for (int k = 0; k < D; ++k) {
            const double cells = reach > 0.0 ? sides_[k] / (reach * slack) : max_cells;
            cells_[k] = static_cast<std::uint64_t>(std::clamp(cells, 1.0, max_cells));
        }
    }

    /// The longest side of a cell.
    double cell_width() const
    {
        double width = 0;
        for (int k = 0; k < D; ++k) width = std::max(width, sides_[k] / static_cast<double>(cells_[k]));
        return width;
    }

    bool at_finest() const
    {
        return std::ranges::all_of(cells_, [](std::uint64_t cells) { return static_cast<double>(cells) == max_cells; });
    }

    void insert(std::uint32_t i, std::span<const double> x)
    {
        std::uint32_t& head = heads_[slot(cell_of(x))];
        next_[i] = head;
        head = i;
    }

    /// Calls visit(j) for every point j in the cells around x (and perhaps some others, and some twice).
    template <class Visit>
    void for_each_near(std::span<const double> x, const Visit& visit) const
    {
        const Cell cell = cell_of(x);
        for (int offset = 0; offset < (D == 2 ? 9 : 27); ++offset) {
            Cell near;
            for (int k = 0, rest = offset; k < D; ++k, rest /= 3) near[k] = wrapped(cell[k], rest % 3, cells_[k]);
            for (std::uint32_t j = heads_[slot(near)]; j != none; j = next_[j]) visit(j);
        }
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    Cell cell_of(std::span<const double> x) const
    {
        Cell cell;
        for (int k = 0; k < D; ++k) {
            cell[k] = std::min(static_cast<std::uint64_t>(x[k] * static_cast<double>(cells_[k])), cells_[k] - 1);
        }
        return cell;
    }

    /// Cell c - 1, c or c + 1 of those around the torus, for step 0, 1, 2.
    static std::uint64_t wrapped(std::uint64_t c, int step, std::uint64_t cells)
    {
        if (step == 0) return c == 0 ? cells - 1 : c - 1;
        if (step == 2) return c == cells - 1 ? 0 : c + 1;
        return c;
    }

    /// Rows of cells lie behind each other in memory; odd multipliers spread the rows and slices.
    std::size_t slot(const Cell& cell) const
    {
        std::uint64_t hash = cell[0] + cell[1] * 0x9e3779b97f4a7c15u;
        if constexpr (D == 3) hash += cell[2] * 0xc2b2ae3d27d4eb4fu;
        return (hash ^ (hash >> 32)) & (heads_.size() - 1);
    }

    std::array<double, 3> sides_; ///< of the torus
    Cell cells_{};                ///< along each axis
    std::vector<std::uint32_t> heads_;
    std::vector<std::uint32_t> next_;
};

/// Squared distances as exact integers, for coordinates that are multiples of 2^-32.
template <int D>
struct FixedPointMetric
{
    std::vector<TorusPoint<D>> points;

    static bool suits(const PointSet& set)
    {
        return std::ranges::all_of(set.coordinates, [](double x) { return x * 0x1p32 == std::floor(x * 0x1p32); });
    }

    explicit FixedPointMetric(const PointSet& set) : points(set.size())
    {
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (int k = 0; k < D; ++k) points[i][k] = static_cast<std::uint32_t>(set[i][k] * 0x1p32);
        }
    }

    std::uint64_t operator()(std::size_t i, std::size_t j) const { return squared_distance<D>(points[i], points[j]); }

    /// A long double holds every 64-bit integer: one rounding in the root, one in the conversion.
    static double distance(std::uint64_t squared)
    {
        return static_cast<double>(std::sqrt(static_cast<long double>(squared)) * 0x1p-32L);
    }
};

/// Squared distances in double, for any other coordinates.
template <int D>
struct FloatingMetric
{
    const PointSet& set;

    double operator()(std::size_t i, std::size_t j) const
    {
        double sum = 0.0;
        for (int k = 0; k < D; ++k) {
            // 1 - high is exact where it matters (high >= 1/2): each way round is rounded once.
            const auto [low, high] = std::minmax(set[i][k], set[j][k]);
            const double shortest = std::min(high - low, (1.0 - high) + low);
            sum += shortest * shortest;
        }
        return sum;
    }

    static double distance(double squared) { return std::sqrt(squared); }
};

/// Squared distances in a box that is no square.
template <int D>
struct BoxMetric
{
    const PointSet& set;
    PeriodicBox box;

    double operator()(std::size_t i, std::size_t j) const
    {
        double sum = 0.0;
        for (int k = 0; k < D; ++k) {
            const auto [low, high] = std::minmax(set[i][k], set[j][k]);
            const double shortest = box.sides[k] * std::min(high - low, (1.0 - high) + low);
            sum += shortest * shortest;
        }
        return sum;
    }

    static double distance(double squared) { return std::sqrt(squared); }
};

/// No set of so many points in a box has a larger smallest distance. Balls of the densest packing's diameter fill more
/// than a box has if they are larger, unless they meet their own copies across a shorter side. In such a box two points
/// that follow each other along the longest side are at most 1 / n of it apart, and at most half of each other side.
template <int D>
double largest_least_distance(std::size_t points, const PeriodicBox& box)
{
    const double packed = max_min_distance(points, D);
    if (box.shortest() >= packed) return packed;
    const double half = box.longest() / 2, gap = box.longest() / static_cast<double>(points);
    double squared = gap * gap - half * half;
    for (int k = 0; k < D; ++k) squared += box.sides[k] * box.sides[k] / 4;
    return std::max(packed, std::sqrt(squared));
}

template <int D, class Metric>
double closest_pair(const PointSet& set, const Metric& squared, const PeriodicBox& box = {})
{
    HashedGrid<D> grid(set.size(), box);
    grid.reset(largest_least_distance<D>(set.size(), box));
    auto least = std::numeric_limits<decltype(squared(0, 0))>::max();
    double distance = std::numeric_limits<double>::infinity();

    for (std::uint32_t i = 0; i < set.size(); ++i) {
        const auto before = least;
        grid.for_each_near(set[i], [&](std::uint32_t j) { least = std::min(least, squared(i, j)); });
        if (least < before) {
            distance = Metric::distance(least);
            if (distance == 0.0) return 0.0;
            if (2.0 * distance < grid.cell_width() && !grid.at_finest()) {
                grid.reset(distance);
                for (std::uint32_t j = 0; j < i; ++j) grid.insert(j, set[j]);
            }
        }
        grid.insert(i, set[i]);
    }
    return distance;
}

/// Cells get twice as wide from round to round, beginning with the smallest distance of all, and a round settles the
/// points whose nearest one is as near as its cells are wide: no cell of a point that is left holds many.
template <int D, class Metric>
double mean_distance(const PointSet& set, const Metric& squared, const PeriodicBox& box)
{
    HashedGrid<D> grid(set.size(), box);
    std::vector<std::uint32_t> open(set.size());
    std::iota(open.begin(), open.end(), 0u);
    double sum = 0;
    for (double reach = std::max(closest_pair<D>(set, squared, box), 0x1p-32); !open.empty(); reach *= 2) {
        grid.reset(reach);
        for (std::uint32_t j = 0; j < set.size(); ++j) grid.insert(j, set[j]);
        std::erase_if(open, [&](std::uint32_t i) {
            auto least = std::numeric_limits<decltype(squared(0, 0))>::max();
            grid.for_each_near(set[i], [&](std::uint32_t j) {
                if (j != i) least = std::min(least, squared(i, j));
            });
            const double distance = Metric::distance(least);
            const bool is_settled = distance <= reach || reach > box.longest();
            if (is_settled) sum += distance;
            return is_settled;
        });
    }
    return sum / static_cast<double>(set.size());
}

/// Distances of the first `own` points of a set to their nearest ones. Empty where one of them has none within `reach`,
/// so that a nearer one may be missing from the set.
template <int D, class Metric>
std::vector<double> nearest_of_first(const PointSet& set, std::size_t own, double reach, const Metric& squared)
{
    HashedGrid<D> grid(set.size(), {});
    std::vector<double> distances(own);
    std::vector<std::uint32_t> open(own);
    std::iota(open.begin(), open.end(), 0u);
    for (double width = std::max(closest_pair<D>(set, squared), 0x1p-32); !open.empty(); width *= 2) {
        grid.reset(width);
        for (std::uint32_t j = 0; j < set.size(); ++j) grid.insert(j, set[j]);
        bool is_too_far = false;
        std::erase_if(open, [&](std::uint32_t i) {
            auto least = std::numeric_limits<decltype(squared(0, 0))>::max();
            grid.for_each_near(set[i], [&](std::uint32_t j) {
                if (j != i) least = std::min(least, squared(i, j));
            });
            distances[i] = Metric::distance(least);
            const bool is_settled = distances[i] <= width || width > 1;
            is_too_far = is_too_far || (is_settled ? distances[i] > reach : width > reach);
            return is_settled;
        });
        if (is_too_far) return {};
    }
    return distances;
}

/// A function of a set and its metric, with the metric that suits the set.
template <int D, class Measure>
auto with_metric(const PointSet& set, const Measure& measure)
{
    if (FixedPointMetric<D>::suits(set)) return measure(FixedPointMetric<D>(set));
    return measure(FloatingMetric<D>{set});
}

template <int D>
double min_distance(const PointSet& set, const PeriodicBox& box)
{
    if (!box.is_unit()) return closest_pair<D>(set, BoxMetric<D>{set, box}, box);
    return with_metric<D>(set, [&](const auto& metric) { return closest_pair<D>(set, metric); });
}

template <int D>
double mean_nearest(const PointSet& set, const PeriodicBox& box)
{
    if (!box.is_unit()) return mean_distance<D>(set, BoxMetric<D>{set, box}, box);
    return with_metric<D>(set, [&](const auto& metric) { return mean_distance<D>(set, metric, box); });
}

/// Distances of the points of a strip to their nearest ones, as soon as enough is known of what is around it.
template <int D>
std::vector<double> nearest_in_strip(const PointStrips& points, std::size_t strip, bool is_window)
{
    const double spacing = std::pow(static_cast<double>(points.size()), -1.0 / D);
    for (double reach = 4 * spacing;; reach *= 4) {
        const double around = std::min(1.0, reach * slack);
        PointSet part = points.strip(strip);
        const std::size_t own = part.size();
        points.append_around(strip, around, around, is_window, part);
        if (own == 0) return {};
        const double known = around < 1 ? reach : std::numeric_limits<double>::infinity();
        // A window is half as large on its torus.
        if (is_window) part = halved(std::move(part));
        std::vector<double> distances = with_metric<D>(part, [&](const auto& metric) {
            return nearest_of_first<D>(part, own, is_window ? known / 2 : known, metric);
        });
        if (is_window)
            for (double& distance : distances) distance *= 2;
        if (!distances.empty()) return distances;
    }
}

}

NearestDistances nearest_distances(const PointStrips& points, bool is_window)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (points.size() < 2) return {infinity, infinity};
    NearestDistances result{infinity, 0};
    for (std::size_t strip = 0; strip < points.count(); ++strip) {
        stop_if_interrupted();
        const std::vector<double> distances = points.dimension() == 2 ? nearest_in_strip<2>(points, strip, is_window)
                                                                      : nearest_in_strip<3>(points, strip, is_window);
        result.mean += std::accumulate(distances.begin(), distances.end(), 0.0);
        for (const double distance : distances) result.least = std::min(result.least, distance);
    }
    result.mean /= static_cast<double>(points.size());
    return result;
}

double min_toroidal_distance(const PointSet& points, const PeriodicBox& box)
{
    if (points.size() < 2) return std::numeric_limits<double>::infinity();
    return points.dimension == 2 ? min_distance<2>(points, box) : min_distance<3>(points, box);
}

double mean_nearest_distance(const PointSet& points, const PeriodicBox& box)
{
    if (points.size() < 2) return std::numeric_limits<double>::infinity();
    return points.dimension == 2 ? mean_nearest<2>(points, box) : mean_nearest<3>(points, box);
}

double min_distance_in_window(const PointSet& points, const PeriodicBox& box)
{
    return 2 * min_toroidal_distance(halved(points), box);
}

double mean_nearest_distance_in_window(const PointSet& points, const PeriodicBox& box)
{
    return 2 * mean_nearest_distance(halved(points), box);
}

}
