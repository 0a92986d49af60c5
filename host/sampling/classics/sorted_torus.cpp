#include "host/sampling/classics/sorted_torus.hpp"

#include <algorithm>
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

}
