#include "host/tile_sampling/penrose/penrose_relaxation.hpp"

#include "base/geometry/convex_cell.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/tile_sampling/penrose/penrose_walk.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace poissonlab {
namespace {

using contract::penrose::INDICES;
using contract::penrose::ROWS;

/// Importances of a row that share its vectors, from its first one to its last one.
constexpr std::uint64_t shared_importances = 3;

using PlaneVector = std::array<double, 2>;

/// Vectors of a row, in scales of the level.
using RowVectors = std::array<PlaneVector, INDICES>;

/// Changes of a row's vectors: means of movements in the frames of their points.
class RowChange
{
public:
    void add(std::size_t index, const PlaneVector& movement)
    {
        sums_[index][0] += movement[0];
        sums_[index][1] += movement[1];
        ++counts_[index];
    }

    void apply(RowVectors& vectors, double part) const
    {
        for (std::size_t i = 0; i < vectors.size(); ++i)
            for (std::size_t k = 0; k < 2 && counts_[i] > 0; ++k) vectors[i][k] += part * sums_[i][k] / counts_[i];
    }

private:
    RowVectors sums_{};
    std::array<double, INDICES> counts_{};
};

/// Points of the unit square that share a row's vectors, and a grid that finds those near a place.
class PenrosePatch
{
public:
    PenrosePatch(const PenroseTiling& tiling, std::uint64_t importance)
    {
        const PenroseWalk walk(tiling, importance, {});
        visit_new_points(walk, PenroseTile{}, [&](const PenroseTile& tile) {
            if (const auto found = walk.staying(tile)) add(*found, tiling.scales);
        });
        spacing_ = max_min_distance(members_.size(), 2);
        cells_ = static_cast<int>(1 / spacing_);
    }

    double spacing() const { return spacing_; }

    /// Puts points where the vectors move them.
    void place(const RowVectors& vectors)
    {
        places_.resize(members_.size());
        starts_.assign(cell_at(0, cells_) + 1, 0);
        for (std::size_t i = 0; i < members_.size(); ++i) {
            const Member& m = members_[i];
            const auto& [u, v] = vectors[m.index];
            places_[i] = {m.corner[0] + u * m.frame[0] - v * m.frame[1], m.corner[1] + u * m.frame[1] + v * m.frame[0]};
            ++starts_[cell_at(places_[i]) + 1];
        }
        std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
        in_cells_.resize(members_.size());
        std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
        for (std::size_t i = 0; i < members_.size(); ++i) in_cells_[next[cell_at(places_[i])]++] = {places_[i], i};
    }

    /// The way of each inner point to the centroid of its Voronoi cell.
    void add_centroids(RowChange& change) const
    {
        add_movements(change, 5, [&](std::size_t i, PlaneVector& movement) {
            ConvexCell cell(4 * spacing_);
            for (const auto& [squared, x, y] : near(i, 3)) {
                if (!cell.is_reached_from(squared)) break;
                cell.cut(x, y);
            }
            movement = cell.centroid();
            return true;
        });
    }

    /// The pushes of inner points by those that are nearer than `distance`. Returns the smallest distance of inner
    /// points.
    double add_pushes(RowChange& change, double distance) const
    {
        std::vector<double> nearest(members_.size(), 1);
        add_movements(change, 1, [&](std::size_t i, PlaneVector& movement) {
            const auto others = near(i, 1);
            if (!others.empty()) nearest[i] = std::sqrt(others.front()[0]);
            for (const auto& [squared, x, y] : others) {
                const double length = std::sqrt(squared);
                if (length >= distance || length == 0) continue;
                movement[0] -= x / length * (distance - length) / 2;
                movement[1] -= y / length * (distance - length) / 2;
            }
            return nearest[i] < distance;
        });
        return *std::ranges::min_element(nearest);
    }

private:
    struct Member
    {
        PlaneVector corner;
        PlaneVector frame; ///< its direction, one scale long
        std::size_t index;
    };

    void add(const StayingPoint& found, const PenroseScales& scales)
    {
        const auto place = [](const FixedPlace& p) {
            return PlaneVector{static_cast<double>(p[0]) * 0x1p-56, static_cast<double>(p[1]) * 0x1p-56};
        };
        const PlaneVector corner = place(found.corner);
        if (std::min(corner[0], corner[1]) < 0 || std::max(corner[0], corner[1]) >= 1) return;
        const PlaneVector tip = place(found.moved({1 << vector_bits, 0}, scales));
        members_.push_back({corner, {tip[0] - corner[0], tip[1] - corner[1]}, found.index});
    }

    /// Adds the movements of points that are `margin` spacings away from the border of the square: they have all of
    /// the neighbours that move them.
    template <class Move>
    void add_movements(RowChange& change, double margin, const Move& move) const
    {
        std::vector<PlaneVector> movements(members_.size());
        std::vector<char> moves(members_.size());
        tbb::parallel_for(std::size_t{0}, members_.size(), [&](std::size_t i) {
            const auto [low, high] = std::ranges::minmax(members_[i].corner);
            moves[i] = low > margin * spacing_ && high < 1 - margin * spacing_ && move(i, movements[i]);
        });
        for (std::size_t i = 0; i < members_.size(); ++i) {
            if (!moves[i]) continue;
            const auto& [x, y] = movements[i];
            const PlaneVector& f = members_[i].frame;
            const double squared = f[0] * f[0] + f[1] * f[1];
            change.add(members_[i].index, {(x * f[0] + y * f[1]) / squared, (y * f[0] - x * f[1]) / squared});
        }
    }

    std::size_t cell_at(const PlaneVector& place) const { return cell_at(cell_of(place[0]), cell_of(place[1])); }

    int cell_of(double c) const { return std::clamp(static_cast<int>(c * cells_), 0, cells_ - 1); }

    std::size_t cell_at(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(column);
    }

    /// Squared distance and relative place of the points in the cells around a point's own, nearest first.
    std::vector<std::array<double, 3>> near(std::size_t i, int reach) const
    {
        std::vector<std::array<double, 3>> others;
        others.reserve(static_cast<std::size_t>((2 * reach + 1) * (2 * reach + 2)));
        const auto& [x, y] = places_[i];
        const int column = cell_of(x), row = cell_of(y);
        const int first = std::max(0, column - reach), last = std::min(cells_ - 1, column + reach);
        for (int r = std::max(0, row - reach); r <= std::min(cells_ - 1, row + reach); ++r)
            for (std::size_t at = starts_[cell_at(first, r)]; at < starts_[cell_at(last, r) + 1]; ++at) {
                const auto& [place, other] = in_cells_[at];
                if (other == i) continue;
                const double dx = place[0] - x, dy = place[1] - y;
                others.push_back({dx * dx + dy * dy, dx, dy});
            }
        std::ranges::sort(others);
        return others;
    }

    std::vector<Member> members_;
    double spacing_ = 0; ///< the largest minimum distance of so many points
    int cells_ = 1;
    std::vector<PlaneVector> places_;
    std::vector<std::size_t> starts_;                           ///< of cells, and the end
    std::vector<std::pair<PlaneVector, std::size_t>> in_cells_; ///< places and numbers of points, cell after cell
};

std::vector<PenrosePatch> patches_of(const PenroseTiling& tiling, const PenroseRow& row)
{
    const auto [begin, end] = importances_of(tiling.scales, row);
    std::vector<PenrosePatch> patches;
    for (std::uint64_t i = 0; i < shared_importances; ++i)
        patches.emplace_back(tiling, begin + (end - 1 - begin) * i / (shared_importances - 1));
    return patches;
}

/// Moves points apart, and leaves the vectors of the round with the largest minimum distance.
void push_apart(std::vector<PenrosePatch>& patches, const PenroseRelaxation& relaxation, RowVectors& vectors)
{
    constexpr double part = 0.6; // of a push; more of them overshoots
    double best = 0;
    RowVectors current = vectors;
    for (std::uint32_t round = 0;; ++round) {
        RowChange change;
        double least = 1;
        for (PenrosePatch& patch : patches) {
            patch.place(current);
            const double reached = patch.add_pushes(change, relaxation.pushed_radius * patch.spacing());
            least = std::min(least, reached / patch.spacing());
        }
        if (least > best) {
            best = least;
            vectors = current;
        }
        if (round == relaxation.push_rounds) return;
        change.apply(current, part);
    }
}

PenroseVector rounded(const PlaneVector& v)
{
    static constexpr double longest = longest_vector;
    const auto units = [](double c) {
        return static_cast<std::int32_t>(std::nearbyint(std::clamp(c, -longest, longest) * (1 << vector_bits)));
    };
    return {units(v[0]), units(v[1])};
}

}

PenroseTable relaxed_penrose_table(const PenroseRelaxation& relaxation,
                                   const std::function<void(const std::string& what)>& on_step)
{
    const PenroseTiling tiling{PenroseTable{}};
    PenroseTable table;
    for (std::size_t row = 0; row < ROWS; ++row) {
        if (on_step) on_step(fmt::format("Penrose table: row {} of {}", row + 1, int{ROWS}));
        auto patches = patches_of(tiling, {relaxation.lloyd_level, row});
        RowVectors vectors{};
        for (std::uint32_t round = 0; round < relaxation.lloyd_rounds; ++round) {
            RowChange change;
            for (PenrosePatch& patch : patches) {
                patch.place(vectors);
                patch.add_centroids(change);
            }
            change.apply(vectors, 1);
        }
        patches = patches_of(tiling, {relaxation.push_level, row});
        push_apart(patches, relaxation, vectors);
        std::ranges::transform(vectors, table.rows[row].begin(), rounded);
    }
    return table;
}

}
