// Looks at the cells around each point of the smaller set, ring after ring, until cells are farther away than the
// least distance so far.
#include "host/distribution/classes/least_between.hpp"

#include "analysis/measures/cell_grid.hpp"
#include "base/geometry/torus.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace poissonlab {
namespace {

/// Calls visit(cell) for the cells that are `ring` cells away from a cell, around the torus; some twice where the torus
/// is no wider.
template <int D, typename Visit>
void for_each_in_ring(const std::array<int, D>& cell, int ring, int cells, const Visit& visit)
{
    std::array<int, D> offset;
    offset.fill(-ring);
    for (;;) {
        bool is_in_ring = false;
        std::size_t index = 0;
        for (int k = D - 1; k >= 0; --k) {
            is_in_ring = is_in_ring || std::abs(offset[k]) == ring;
            const int along = ((cell[k] + offset[k]) % cells + cells) % cells;
            index = index * static_cast<std::size_t>(cells) + static_cast<std::size_t>(along);
        }
        if (is_in_ring) visit(index);
        int k = 0;
        while (k < D && ++offset[k] > ring) offset[k++] = -ring;
        if (k == D) return;
    }
}

/// Squares in units of 2^-64, of coordinates that are rounded to multiples of 2^-32.
template <int D>
double least_between(const PointSet& few, const PointSet& many)
{
    const CellGrid<D> grid(many, CellGrid<D>::cells_of(many.size()));
    const auto fixed = [](double x) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(x * 0x1p32)); };
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (std::size_t i = 0; i < few.size(); ++i) {
        TorusPoint<D> from;
        std::array<int, D> cell;
        for (std::size_t k = 0; k < D; ++k) {
            from[k] = fixed(few[i][k]);
            cell[k] = std::min(static_cast<int>(few[i][k] * grid.cells), grid.cells - 1);
        }
        for (int ring = 0; 2 * ring <= grid.cells + 1; ++ring) {
            // Points of a ring are a ring less one cell away at least.
            const double away = (ring - 1) * 0x1p32 / grid.cells;
            if (ring > 1 && away * away >= static_cast<double>(least)) break;
            for_each_in_ring<D>(cell, ring, grid.cells, [&](std::size_t index) {
                for (std::size_t j = grid.starts[index]; j < grid.starts[index + 1]; ++j) {
                    TorusPoint<D> to;
                    for (int k = 0; k < D; ++k) to[k] = fixed(grid.position[k][j]);
                    least = std::min(least, squared_distance<D>(from, to));
                }
            });
        }
    }
    return std::sqrt(static_cast<double>(least)) * 0x1p-32;
}

}

double least_distance_between(const PointSet& a, const PointSet& b)
{
    if (a.size() == 0 || b.size() == 0) return std::numeric_limits<double>::infinity();
    const bool is_first_larger = a.size() > b.size();
    const PointSet &few = is_first_larger ? b : a, &many = is_first_larger ? a : b;
    return a.dimension == 2 ? least_between<2>(few, many) : least_between<3>(few, many);
}

}
