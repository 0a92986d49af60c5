#include "analysis/borders/border_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace poissonlab {
namespace {

/// Files round coordinates, and the spacings of a lattice are no longer the same then.
constexpr double beyond_rounding = 0.98;

/// Appends the points that are nearer to the border than `reach`.
void append_near_border(const PointSet& points, double reach, const PeriodicBox& box, PointSet& near)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto x = points[i];
        bool is_near = false;
        for (std::size_t k = 0; k < x.size(); ++k) is_near = is_near || std::min(x[k], 1 - x[k]) * box.sides[k] < reach;
        if (is_near) near.coordinates.insert(near.coordinates.end(), x.begin(), x.end());
    }
}

/// Points by the cells of a grid on the torus, few of which hold any.
class SparseGrid
{
public:
    SparseGrid(const PointSet& points, double reach, const PeriodicBox& box) : points_(points)
    {
        for (std::size_t k = 0; k < cells_.size(); ++k)
            cells_[k] = static_cast<std::int64_t>(std::clamp(std::floor(box.sides[k] / reach), 1.0, 0x1p20));
        for (std::size_t i = 0; i < points.size(); ++i) in_cell_[key_of(cell_of(i))].push_back(i);
    }

    /// Calls visit(j) once for each point j of the cells around that of point i.
    template <class Visit>
    void for_each_around(std::size_t i, const Visit& visit) const
    {
        const Cell own = cell_of(i);
        const int dimension = points_.dimension;
        std::vector<std::uint64_t> keys;
        for (int step = 0; step < (dimension == 2 ? 9 : 27); ++step) {
            Cell near{};
            for (int k = 0, rest = step; k < dimension; ++k, rest /= 3) {
                const auto axis = static_cast<std::size_t>(k);
                near[axis] = (own[axis] + rest % 3 - 1 + cells_[axis]) % cells_[axis];
            }
            keys.push_back(key_of(near));
        }
        std::ranges::sort(keys); // on grids of one or two cells, several steps lead to the same one
        keys.erase(std::ranges::unique(keys).begin(), keys.end());
        for (const std::uint64_t key : keys)
            if (const auto found = in_cell_.find(key); found != in_cell_.end())
                for (const std::size_t j : found->second) visit(j);
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cell_of(std::size_t i) const
    {
        Cell cell{};
        for (std::size_t k = 0; k < points_[i].size(); ++k)
            cell[k] =
                std::min(static_cast<std::int64_t>(points_[i][k] * static_cast<double>(cells_[k])), cells_[k] - 1);
        return cell;
    }

    std::uint64_t key_of(const Cell& cell) const
    {
        return static_cast<std::uint64_t>((cell[2] * cells_[1] + cell[1]) * cells_[0] + cell[0]);
    }

    const PointSet& points_;
    Cell cells_{};
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> in_cell_;
};

double squared_on_torus(const PointSet& points, const PeriodicBox& box, std::size_t i, std::size_t j)
{
    double sum = 0;
    for (std::size_t k = 0; k < points[i].size(); ++k) {
        const double difference = std::abs(points[i][k] - points[j][k]);
        const double shortest = box.sides[k] * std::min(difference, 1 - difference);
        sum += shortest * shortest;
    }
    return sum;
}

struct PairOfPoints
{
    double squared = 0;
    std::size_t first = 0, second = 0;

    auto operator<=>(const PairOfPoints&) const = default;
};

/// Counts pairs closer than `reach`, the closest first; a point takes part in its first pair alone.
std::size_t separate_pairs(const PointSet& points, double reach, const PeriodicBox& box)
{
    std::vector<PairOfPoints> pairs;
    const SparseGrid grid(points, reach, box);
    for (std::size_t i = 0; i < points.size(); ++i)
        grid.for_each_around(i, [&](std::size_t j) {
            if (j <= i) return;
            if (const double squared = squared_on_torus(points, box, i, j); squared < reach * reach)
                pairs.push_back({squared, i, j});
        });
    std::ranges::sort(pairs);
    std::vector<bool> is_taken(points.size());
    std::size_t count = 0;
    for (const PairOfPoints& pair : pairs) {
        if (is_taken[pair.first] || is_taken[pair.second]) continue;
        is_taken[pair.first] = is_taken[pair.second] = true;
        ++count;
    }
    return count;
}

}

std::size_t closer_pairs_across(const PointSet& points, double least_in_window, const PeriodicBox& box)
{
    if (!(least_in_window > 0) || !std::isfinite(least_in_window)) return 0;
    const double reach = beyond_rounding * least_in_window;
    PointSet near{points.dimension, {}};
    append_near_border(points, reach, box, near);
    return separate_pairs(near, reach, box);
}

std::size_t closer_pairs_across(const PointStrips& points, double least_in_window)
{
    if (!(least_in_window > 0) || !std::isfinite(least_in_window)) return 0;
    const double reach = beyond_rounding * least_in_window;
    PointSet near{points.dimension(), {}};
    for (std::size_t strip = 0; strip < points.count(); ++strip)
        append_near_border(points.strip(strip), reach, {}, near);
    return separate_pairs(near, reach, {});
}

double chance_of_pairs_across(std::uint64_t pairs, std::size_t sets, std::size_t points, int dimension, int tiles,
                              const PeriodicBox& box)
{
    if (pairs == 0 || sets == 0) return 1;
    double across = dimension * std::pow(static_cast<double>(points), -1.0 / dimension) / box.shortest();
    if (tiles > 0) across = std::max(across, static_cast<double>(dimension) / tiles);
    if (across >= 1) return 1;
    // `pairs` or more before the first `sets` pairs inside: so many of the first pairs + sets - 1 are across, at least.
    const auto least = static_cast<double>(pairs), all = least + static_cast<double>(sets) - 1;
    double chance = 0;
    for (double k = least; k <= all; ++k)
        chance += std::exp(std::lgamma(all + 1) - std::lgamma(k + 1) - std::lgamma(all - k + 1) + k * std::log(across) +
                           (all - k) * std::log1p(-across));
    return std::min(chance, 1.0);
}

}
