// A sweep along rows: from each point to both sides, until others are too far away along one axis to matter.
#include "analysis/regions/kept_distances.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr double points_a_row = 0.7; ///< to the root of all: rows of squares with half a point each

class KeptSweep
{
public:
    KeptSweep(std::span<const TorusPoint<2>> points, std::span<const std::uint32_t> distances, bool is_mean)
        : points_(points), distances_(distances), is_mean_(is_mean)
    {
        std::uint32_t highest = 0;
        for (const TorusPoint<2>& point : points) highest = std::max(highest, point[1]);
        most_ = distances.empty() ? 0 : std::ranges::max(distances);
        const double rows = std::max(1.0, points_a_row * std::sqrt(static_cast<double>(points.size())));
        height_ = static_cast<std::uint32_t>(highest / rows) + 1;
        rows_.resize(highest / height_ + 1);
        for (std::uint32_t i = 0; i < points.size(); ++i) rows_[points[i][1] / height_].push_back(i);
        for (auto& row : rows_) std::ranges::sort(row, {}, [&](std::uint32_t i) { return points_[i][0]; });
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
        // No pair of the point keeps more than this.
        const double own = is_mean_ ? (double{1} * distances_[i] + most_) / 2 : distances_[i];
        bool are_kept = true;
        const auto row = static_cast<std::int64_t>(points_[i][1] / height_);
        for (std::int64_t away = 0;; ++away) {
            const double gap = std::max<double>(0, static_cast<double>(away - 1) * height_);
            // Pairs that are not kept lie within `own`; `nearest` may be less than 1 by then.
            if (gap > own * std::max(1.0, nearest) || (row - away < 0 && row + away >= row_count())) break;
            if (row - away >= 0) are_kept &= look_along(rows_[static_cast<std::size_t>(row - away)], i, own, nearest);
            if (away > 0 && row + away < row_count())
                are_kept &= look_along(rows_[static_cast<std::size_t>(row + away)], i, own, nearest);
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

    std::int64_t row_count() const { return static_cast<std::int64_t>(rows_.size()); }

    std::span<const TorusPoint<2>> points_;
    std::span<const std::uint32_t> distances_;
    bool is_mean_;
    double most_ = 0;
    std::uint32_t height_ = 1;
    std::vector<std::vector<std::uint32_t>> rows_; ///< of points, by x
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
