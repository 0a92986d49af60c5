#include "host/distribution/regions/nearest_in_plane.hpp"

#include "base/geometry/plane_delaunay.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace poissonlab {
namespace {

/// If a cell of the grid has more points than this, the set is too uneven for a grid.
constexpr std::size_t most_in_a_cell = 64;

/// Cells along each axis in which the share of the box that has points is looked for, for each root of their number.
constexpr double coarse_cells = 0.5;

/// Points in a cell that has some, nearly.
constexpr double usual_in_a_cell = 2;

/// Cells for each point at most, unless they are folded: many of them have a number in common then.
constexpr double most_cells = 16;

/// Cells are halved while those that have points have more than this on average, as in long sets, down to so many along
/// the square.
constexpr double many_in_a_cell = 8;
constexpr std::size_t most_along = std::size_t{1} << 26;

/// The cell of a point is rounded, by far less than this part of its width.
constexpr double more_than_rounding = 1 - 0x1p-20;

double squared_gap(const PointSet& points, std::size_t i, std::size_t j)
{
    const double dx = points[i][0] - points[j][0], dy = points[i][1] - points[j][1];
    return dx * dx + dy * dy;
}

/// The points by the cells of a grid over the square around them, which are folded where there are too many of them:
/// rows begin at multiples of the golden ratio of all numbers. Cells serve to find neighbours; distances are those of
/// the points' own coordinates.
class PlaneCells
{
public:
    PlaneCells(const PointSet& points, std::size_t cells_along) : points_(points), along_(cells_along)
    {
        low_ = {points[0][0], points[0][1]};
        std::array<double, 2> high = low_;
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                low_[k] = std::min(low_[k], points[i][k]);
                high[k] = std::max(high[k], points[i][k]);
            }
        }
        width_ = std::max(high[0] - low_[0], high[1] - low_[1]) / static_cast<double>(along_);
        if (static_cast<double>(along_) * static_cast<double>(along_) > most_cells * static_cast<double>(points.size()))
            folded_ = std::bit_ceil(2 * points.size());
        starts_.assign((folded_ > 0 ? folded_ : along_ * along_) + 1, 0);
        for (std::size_t i = 0; i < points.size(); ++i) ++starts_[cell_of(i) + 1];
        for (std::size_t c = 0; c + 1 < starts_.size(); ++c) {
            fullest_ = std::max(fullest_, starts_[c + 1]);
            filled_ += starts_[c + 1] > 0;
            starts_[c + 1] += starts_[c];
        }
        std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
        sorted_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) sorted_[next[cell_of(i)]++] = i;
    }

    std::size_t fullest() const { return fullest_; }
    double filled_share() const { return static_cast<double>(filled_) / static_cast<double>(along_ * along_); }
    double points_a_cell() const { return static_cast<double>(points_.size()) / static_cast<double>(filled_); }

    /// The squared distance of the nearest other point: rings of cells are looked at until all that is farther out is
    /// farther away than what was found.
    double squared_nearest(std::size_t i) const
    {
        const auto x = static_cast<std::ptrdiff_t>(column_of(i, 0)), y = static_cast<std::ptrdiff_t>(column_of(i, 1));
        double squared = std::numeric_limits<double>::infinity();
        for (std::ptrdiff_t ring = 0; ring <= static_cast<std::ptrdiff_t>(along_); ++ring) {
            const double beyond = static_cast<double>(ring - 1) * width_ * more_than_rounding;
            if (ring > 1 && beyond * beyond > squared) break;
            if (4 * ring * ring > static_cast<std::ptrdiff_t>(points_.size())) return squared_nearest_of_all(i);
            for (std::ptrdiff_t row = y - ring; row <= y + ring; ++row) {
                const bool is_whole = row == y - ring || row == y + ring;
                for (std::ptrdiff_t column = x - ring; column <= x + ring; column += is_whole ? 1 : 2 * ring)
                    look_at(i, column, row, squared);
            }
        }
        return squared;
    }

private:
    std::size_t column_of(std::size_t i, std::size_t axis) const
    {
        if (!(width_ > 0)) return 0; // all points coincide
        return std::min(static_cast<std::size_t>((points_[i][axis] - low_[axis]) / width_), along_ - 1);
    }
    std::size_t cell_of(std::size_t i) const { return number_of(column_of(i, 0), column_of(i, 1)); }

    std::size_t number_of(std::size_t column, std::size_t row) const
    {
        if (folded_ == 0) return row * along_ + column;
        const auto step = static_cast<std::size_t>(0.6180339887498949 * static_cast<double>(folded_)) | 1;
        return (column + row * step) & (folded_ - 1);
    }

    double squared_nearest_of_all(std::size_t i) const
    {
        double squared = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < points_.size(); ++j)
            if (j != i) squared = std::min(squared, squared_gap(points_, i, j));
        return squared;
    }

    void look_at(std::size_t i, std::ptrdiff_t column, std::ptrdiff_t row, double& squared) const
    {
        const auto along = static_cast<std::ptrdiff_t>(along_);
        if (column < 0 || row < 0 || column >= along || row >= along) return;
        const std::size_t cell = number_of(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
        for (std::size_t at = starts_[cell]; at < starts_[cell + 1]; ++at)
            if (sorted_[at] != i) squared = std::min(squared, squared_gap(points_, i, sorted_[at]));
    }

    const PointSet& points_;
    std::size_t along_;
    std::size_t folded_ = 0; ///< numbers of folded cells, a power of two; 0: each cell has its own
    std::array<double, 2> low_{};
    double width_ = 0;
    std::size_t fullest_ = 0, filled_ = 0;
    std::vector<std::size_t> starts_, sorted_;
};

/// The squared distance of each point from the nearest, by neighbours in the Delaunay triangulation; points on one line
/// have none.
std::vector<double> squared_by_triangles(const PointSet& points)
{
    std::vector<PlanePosition> positions;
    for (std::size_t i = 0; i < points.size(); ++i) positions.push_back({points[i][0], points[i][1]});
    std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
    const auto look_at = [&](std::size_t i, std::size_t j) {
        const double gap = squared_gap(points, i, j);
        nearest[i] = std::min(nearest[i], gap);
        nearest[j] = std::min(nearest[j], gap);
    };
    const std::vector<PlaneTriangle> triangles = plane_triangles(positions);
    for (const PlaneTriangle& triangle : triangles)
        for (std::size_t i = 0; i < 3; ++i) look_at(triangle.points[i], triangle.points[(i + 1) % 3]);
    if (triangles.empty())
        for (std::size_t i = 0; i < points.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) look_at(i, j);
    return nearest;
}

std::size_t cells_along(double cells) { return static_cast<std::size_t>(std::max(1.0, std::sqrt(cells))); }

std::vector<double> squared_nearest(const PointSet& points)
{
    const auto count = static_cast<double>(points.size());
    const PlaneCells coarse(points, cells_along(coarse_cells * coarse_cells * count));
    const double cells = count / usual_in_a_cell / coarse.filled_share();
    std::size_t along = cells_along(std::min(cells, most_cells * count));
    auto fine = std::make_unique<const PlaneCells>(points, along);
    while (fine->points_a_cell() > many_in_a_cell && along < most_along)
        fine = std::make_unique<const PlaneCells>(points, along *= 2);
    if (fine->fullest() > most_in_a_cell) return squared_by_triangles(points);
    std::vector<double> nearest(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) { nearest[i] = fine->squared_nearest(i); });
    return nearest;
}

}

NearestDistances nearest_distances(const PointSet& points)
{
    const std::vector<double> nearest = squared_nearest(points);
    NearestDistances distances{std::sqrt(std::ranges::min(nearest)), 0};
    for (const double squared : nearest) distances.mean += std::sqrt(squared) / static_cast<double>(nearest.size());
    return distances;
}

}
