#include "analysis/regions/plane_neighbours.hpp"

namespace poissonlab {

/// Rings of cells around the place's own, until all that is farther out is farther away than what was found.
double PlaneNeighbours::nearest(const std::array<double, 2>& place, std::size_t left_out) const
{
    const int column = cell_along(place[0]), row = cell_along(place[1]);
    double squared = std::numeric_limits<double>::infinity();
    const auto visit_if_there = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= grid_.cells || y >= grid_.cells) return;
        visit(x, y, [&](std::size_t i) {
            if (i != left_out) squared = std::min(squared, squared_distance(place, i));
        });
    };
    for (int ring = 0; ring <= grid_.cells; ++ring) {
        const double beyond = static_cast<double>(ring - 1) / grid_.cells;
        if (ring > 0 && beyond * beyond > squared) break;
        for (int x = column - ring; x <= column + ring; ++x) {
            visit_if_there(x, row - ring);
            if (ring > 0) visit_if_there(x, row + ring);
        }
        for (int y = row - ring + 1; y <= row + ring - 1; ++y) {
            visit_if_there(column - ring, y);
            visit_if_there(column + ring, y);
        }
    }
    return std::sqrt(squared);
}

}
