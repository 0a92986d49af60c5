// Points are sorted by the powers of two below their distances. For each of these a sweep along rows goes from a point
// to both sides, until others are too far away along one axis to matter: how far that is follows from the largest
// distance of the class, so that a few large ones cost what few points do.
#include "analysis/regions/kept_distances.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr double points_a_row = 0.7; ///< to the root of all in a square: rows of squares with half a point each

/// The points whose distances have a number of bits in common, in rows, by x.
class DistanceClass
{
public:
    DistanceClass(std::span<const TorusPoint<2>> points, std::span<const std::uint32_t> distances,
                  const std::vector<std::uint32_t>& members)
    {
        std::uint32_t highest = 0, left = std::numeric_limits<std::uint32_t>::max(), right = 0;
        lowest_ = std::numeric_limits<std::uint32_t>::max();
        for (const std::uint32_t i : members) {
            highest = std::max(highest, points[i][1]);
            lowest_ = std::min(lowest_, points[i][1]);
            left = std::min(left, points[i][0]);
            right = std::max(right, points[i][0]);
            most_ = std::max(most_, distances[i]);
        }
        const auto count = static_cast<double>(members.size());
        const double upright = (highest - lowest_ + 1.0) / (right - left + 1.0);
        const double rows = std::clamp(points_a_row * std::sqrt(count * upright), 1.0, count);
        height_ = static_cast<std::uint32_t>((highest - lowest_) / rows) + 1;
        rows_.resize((highest - lowest_) / height_ + 1);
        for (const std::uint32_t i : members) rows_[(points[i][1] - lowest_) / height_].push_back(i);
        for (auto& row : rows_) std::ranges::sort(row, {}, [&](std::uint32_t i) { return points[i][0]; });
    }

    std::uint32_t most() const { return most_; }

    /// Calls visit(row) for rows from that of a height on to both sides, while may_matter(gap) of the gap along y.
    template <typename Visit, typename MayMatter>
    void for_each_row_from(std::uint32_t y, const Visit& visit, const MayMatter& may_matter) const
    {
        const double at = (double{1} * y - lowest_) / height_;
        const auto count = static_cast<std::int64_t>(rows_.size());
        const std::int64_t row = std::clamp(static_cast<std::int64_t>(std::floor(at)), std::int64_t{0}, count - 1);
        const auto visit_if_near = [&](std::int64_t other) {
            const double below = static_cast<double>(other) * height_ + lowest_, above = below + height_;
            const double gap = std::max({0.0, below - y, y - above});
            if (!may_matter(gap)) return false;
            visit(rows_[static_cast<std::size_t>(other)]);
            return true;
        };
        bool goes_down = true, goes_up = true;
        for (std::int64_t away = 0; goes_down || goes_up; ++away) {
            goes_down = goes_down && row - away >= 0 && visit_if_near(row - away);
            goes_up = goes_up && row + away < count && (away == 0 || visit_if_near(row + away));
        }
    }

private:
    std::uint32_t lowest_ = 0, height_ = 1, most_ = 0;
    std::vector<std::vector<std::uint32_t>> rows_;
};

class KeptSweep
{
public:
    KeptSweep(std::span<const TorusPoint<2>> points, std::span<const std::uint32_t> distances, bool is_mean)
        : points_(points), distances_(distances), is_mean_(is_mean)
    {
        std::array<std::vector<std::uint32_t>, 33> members;
        for (std::uint32_t i = 0; i < points.size(); ++i)
            members[static_cast<std::size_t>(std::bit_width(distances[i]))].push_back(i);
        for (const std::vector<std::uint32_t>& some : members)
            if (!some.empty()) classes_.emplace_back(points, distances, some);
    }

    KeptDistances run()
    {
        KeptDistances kept;
        kept.nearest.assign(points_.size(), std::numeric_limits<double>::infinity());
        std::atomic<bool> are_kept = true;
        tbb::parallel_for(std::size_t{0}, points_.size(), [&](std::size_t i) {
            if (!look_from(static_cast<std::uint32_t>(i), kept.nearest[i])) are_kept = false;
        });
        kept.are_kept = are_kept;
        return kept;
    }

private:
    /// Returns whether all distances are kept; `nearest` is the least one over what is to be kept.
    bool look_from(std::uint32_t i, double& nearest) const
    {
        bool are_kept = true;
        for (const DistanceClass& others : classes_) {
            // No pair of the point and one of these keeps more than this.
            const double own =
                is_mean_ ? (double{1} * distances_[i] + others.most()) / 2 : std::min(distances_[i], others.most());
            // Pairs that are not kept lie within `own`; `nearest` may be less than 1 by then.
            others.for_each_row_from(
                points_[i][1],
                [&](const std::vector<std::uint32_t>& row) { are_kept &= look_along(row, i, own, nearest); },
                [&](double gap) { return gap <= own * std::max(1.0, nearest); });
        }
        return are_kept;
    }

    bool look_along(const std::vector<std::uint32_t>& row, std::uint32_t i, double own, double& nearest) const
    {
        bool are_kept = true;
        const auto look = [&](std::uint32_t j) {
            const double along = std::abs(double{1} * points_[j][0] - points_[i][0]);
            if (along > own * std::max(1.0, nearest)) return false;
            if (j != i) are_kept &= compare(i, j, nearest);
            return true;
        };
        const auto begin =
            std::ranges::lower_bound(row, points_[i][0], {}, [&](std::uint32_t j) { return points_[j][0]; });
        for (auto at = begin; at != row.end() && look(*at);) ++at;
        for (auto at = begin; at != row.begin() && look(*(at - 1));) --at;
        return are_kept;
    }

    bool compare(std::uint32_t i, std::uint32_t j, double& nearest) const
    {
        const std::uint64_t squared = poissonlab::squared_distance<2>(points_[i], points_[j]);
        const std::uint64_t a = distances_[i], b = distances_[j], twice = is_mean_ ? a + b : 2 * std::min(a, b);
        nearest = std::min(nearest, 2 * std::sqrt(static_cast<double>(squared)) / static_cast<double>(twice));
        return squared >= std::uint64_t{1} << 62 || 4 * squared >= twice * twice;
    }

    std::span<const TorusPoint<2>> points_;
    std::span<const std::uint32_t> distances_;
    bool is_mean_;
    std::vector<DistanceClass> classes_; ///< from the smallest distances on
};

}

double KeptDistances::least() const
{
    return nearest.empty() ? std::numeric_limits<double>::infinity() : std::ranges::min(nearest);
}

KeptDistances kept_distances(std::span<const TorusPoint<2>> points, std::span<const std::uint32_t> distances,
                             bool is_mean)
{
    return KeptSweep(points, distances, is_mean).run();
}

}
