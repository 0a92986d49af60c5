#include "analysis/regions/plane_neighbours.hpp"

#include <numeric>

namespace poissonlab {
namespace {

/// Cells along an axis at most, where they are listed, and where all of them count.
constexpr double most_listed = 1 << 28, most_counted = 32768;

/// All cells count where they are no more than so many for each point.
constexpr double counted_a_point = 32;

}

PlaneNeighbours::PlaneNeighbours(const PointSet& points, double share)
{
    const auto count = static_cast<double>(points.size());
    const double along = std::max(1.0, std::floor(std::sqrt(std::floor(count / share) / 2)));
    const bool is_listed = along > most_counted || along * along > counted_a_point * count;
    cells_ = static_cast<int>(std::min(along, is_listed ? most_listed : most_counted));
    std::vector<std::size_t> cell_of_point;
    for (std::size_t i = 0; i < points.size(); ++i)
        cell_of_point.push_back(static_cast<std::size_t>(cell_along(points[i][1])) * static_cast<std::size_t>(cells_) +
                                static_cast<std::size_t>(cell_along(points[i][0])));
    if (is_listed)
        list_filled(cell_of_point);
    else
        number_cells(cell_of_point);
    places_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) places_[numbers_[i]] = {points[i][0], points[i][1]};
}

void PlaneNeighbours::number_cells(const std::vector<std::size_t>& cell_of_point)
{
    starts_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_) + 1, 0);
    for (const std::size_t cell : cell_of_point) ++starts_[cell + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (const std::size_t cell : cell_of_point) numbers_.push_back(next[cell]++);
}

void PlaneNeighbours::list_filled(const std::vector<std::size_t>& cell_of_point)
{
    std::vector<std::size_t> order(cell_of_point.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return cell_of_point[i]; });
    numbers_.resize(order.size());
    rows_.assign(static_cast<std::size_t>(cells_) + 1, 0);
    std::size_t before = none;
    for (std::size_t k = 0; k < order.size(); ++k) {
        numbers_[order[k]] = k;
        const std::size_t cell = cell_of_point[order[k]];
        if (cell == before) continue;
        before = cell;
        filled_.push_back(static_cast<int>(cell % static_cast<std::size_t>(cells_)));
        starts_.push_back(k);
        ++rows_[cell / static_cast<std::size_t>(cells_) + 1];
    }
    starts_.push_back(order.size());
    std::partial_sum(rows_.begin(), rows_.end(), rows_.begin());
}

/// Rings of cells around the place's own, until all that is farther out is farther away than what was found, or more
/// cells were looked at than there are points.
double PlaneNeighbours::nearest(const std::array<double, 2>& place, std::size_t left_out) const
{
    const int column = cell_along(place[0]), row = cell_along(place[1]);
    double squared = std::numeric_limits<double>::infinity();
    const auto visit = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            if (i != left_out) squared = std::min(squared, squared_distance(place, i));
    };
    const auto visit_row = [&](int first, int last, int y) {
        if (y < 0 || y >= cells_ || last < 0 || first >= cells_) return;
        visit(first_point(std::max(first, 0), y), first_point(std::min(last, cells_ - 1) + 1, y));
    };
    for (int ring = 0; ring <= cells_; ++ring) {
        const double beyond = static_cast<double>(ring - 1) / cells_;
        if (ring > 0 && beyond * beyond > squared) break;
        if (4 * static_cast<double>(ring) * ring > static_cast<double>(size())) {
            visit(0, size());
            break;
        }
        visit_row(column - ring, column + ring, row - ring);
        if (ring > 0) visit_row(column - ring, column + ring, row + ring);
        for (int y = row - ring + 1; y <= row + ring - 1; ++y) {
            visit_row(column - ring, column - ring, y);
            visit_row(column + ring, column + ring, y);
        }
    }
    return std::sqrt(squared);
}

}
