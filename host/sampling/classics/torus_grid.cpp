#include "host/sampling/classics/torus_grid.hpp"

#include <numeric>

namespace poissonlab {

SortedTorus::SortedTorus(std::span<const TorusPosition> points, int dimension)
    : cells_(points.size(), dimension), starts_(cells_.count() + 2), points_(points.size())
{
    // Counts stand two places behind their cells: added up, they are begins one place behind, which become ends.
    for (const TorusPosition& point : points) ++starts_[cells_.number_of(point) + 2];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    for (const TorusPosition& point : points) points_[starts_[cells_.number_of(point) + 1]++] = point;
}

std::uint64_t SortedTorus::nearest_within(const TorusPosition& position, std::uint64_t reach) const
{
    std::uint64_t nearest = UINT64_MAX;
    cells_.any_row_around(position, reach, [&](std::int64_t first, std::int64_t end) {
        const std::uint32_t last = starts_[static_cast<std::size_t>(end)];
        for (std::uint32_t i = starts_[static_cast<std::size_t>(first)]; i < last; ++i)
            nearest = std::min(nearest, squared_torus_distance(points_[i], position));
        return false;
    });
    return nearest;
}

std::uint64_t SortedTorus::squared_nearest(const TorusPosition& position, std::uint64_t enough) const
{
    const std::uint64_t least = cells_.width() / 2;
    for (std::uint64_t reach = std::max(reach_for(enough), least);; reach = std::min(half_torus, 2 * reach)) {
        const std::uint64_t nearest = nearest_within(position, reach);
        if (nearest <= std::max(enough, reach * reach) || reach == half_torus) return nearest;
        if (nearest < UINT64_MAX) return nearest_within(position, reach_for(nearest));
    }
}

TorusGrid::TorusGrid(std::size_t points, int dimension)
    : dimension_(dimension), cells_(points, dimension), lasts_(cells_.count(), {{}, none})
{}

TorusGrid::TorusGrid(std::size_t points, int dimension, std::uint64_t width)
    : dimension_(dimension), cells_(TorusCells::folded(points, dimension, width)), lasts_(cells_.count(), {{}, none})
{}

void TorusGrid::add(const TorusPosition& position)
{
    Link& last = lasts_[cells_.number_of(position)];
    const bool is_first = last.number == none;
    points_.push_back({position, is_first ? none : last.number & ~has_more});
    last = {position, static_cast<std::uint32_t>(points_.size() - 1) | (is_first ? 0 : has_more)};
}

template <typename Is>
bool TorusGrid::any_in(const Link& cell, const Is& is) const
{
    if (cell.number == none) return false;
    const std::uint32_t last = cell.number & ~has_more;
    if (is(cell.position, last)) return true;
    if (cell.number == last) return false;
    for (std::uint32_t i = points_[last].number; i != none; i = points_[i].number)
        if (is(points_[i].position, i)) return true;
    return false;
}

template <typename Is>
bool TorusGrid::any_around(const TorusPosition& position, std::uint64_t reach, const Is& is) const
{
    return cells_.any_row_around(position, reach, [&](std::int64_t first, std::int64_t end) {
        for (std::int64_t cell = first; cell < end; ++cell)
            if (any_in(lasts_[static_cast<std::size_t>(cell)], is)) return true;
        return false;
    });
}

std::uint64_t TorusGrid::squared_nearest_below(const TorusPosition& position, std::uint64_t limit) const
{
    std::uint64_t nearest = limit;
    any_around(position, reach_for(limit), [&](const TorusPosition& point, std::uint32_t) {
        nearest = std::min(nearest, squared_torus_distance(point, position));
        return false;
    });
    return nearest;
}

std::uint64_t TorusGrid::squared_nearest(const TorusPosition& position) const
{
    for (std::uint64_t reach = cells_.width() / 2;; reach = std::min(half_torus, 2 * reach)) {
        std::uint64_t nearest = UINT64_MAX;
        any_around(position, reach, [&](const TorusPosition& point, std::uint32_t) {
            nearest = std::min(nearest, squared_torus_distance(point, position));
            return false;
        });
        if (nearest <= reach * reach || reach == half_torus) return nearest;
        if (nearest < UINT64_MAX) return squared_nearest_below(position, nearest);
    }
}

bool TorusGrid::is_near(const TorusPosition& position, std::uint64_t distance) const
{
    const auto is_nearer = [&, squared = distance * distance](const TorusPosition& point, std::uint32_t) {
        return squared_torus_distance(point, position) < squared;
    };
    // Most of what is near to a point is so here.
    return any_in(lasts_[cells_.number_of(position)], is_nearer) ||
           any_around(position, std::min(distance, half_torus), is_nearer);
}

void TorusGrid::ask_around(const TorusPosition& position, std::uint64_t distance) const
{
    constexpr std::int64_t cells_of_line = 64 / sizeof(Link); // of cache
    cells_.any_row_around(position, std::min(distance, half_torus), [&](std::int64_t first, std::int64_t end) {
        for (std::int64_t cell = first; cell < end + cells_of_line - 1; cell += cells_of_line)
            __builtin_prefetch(&lasts_[static_cast<std::size_t>(std::min(cell, end - 1))]);
        return false;
    });
}

std::vector<std::size_t> TorusGrid::within(const TorusPosition& position, double distance) const
{
    std::vector<std::size_t> found;
    any_around(position, static_cast<std::uint64_t>(std::ceil(distance)),
               [&](const TorusPosition& point, std::uint32_t number) {
                   if (static_cast<double>(squared_torus_distance(point, position)) < distance * distance)
                       found.push_back(number);
                   return false;
               });
    if (cells_.is_folded()) {
        std::ranges::sort(found);
        found.erase(std::ranges::unique(found).begin(), found.end());
    }
    return found;
}

PointSet TorusGrid::point_set() const
{
    std::vector<TorusPosition> positions;
    positions.reserve(points_.size());
    for (const Link& point : points_) positions.push_back(point.position);
    return point_set_of(positions, dimension_);
}

PointSet point_set_of(std::span<const TorusPosition> positions, int dimension)
{
    PointSet set{dimension, {}};
    set.coordinates.reserve(positions.size() * static_cast<std::size_t>(dimension));
    for (const TorusPosition& position : positions)
        for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
            set.coordinates.push_back(static_cast<double>(position[k]) / 4294967296.0);
    return set;
}

}
