#include "tiles/poisson/region_counts.hpp"

#include <algorithm>
#include <bit>

namespace poissonlab {
namespace {

/// The cells of a dimension that a tile has a whole of: in 2D one corner (four quarters) and two edges.
double whole_cells(int dimension, int cell_dimension)
{
    return cell_dimension == 0 || cell_dimension == dimension ? 1 : dimension;
}

/// The points of one tile by the dimension of the cell in whose region they are.
std::array<std::uint32_t, 4> points_of_tile(const PoissonTileSet& set, const TileRegions& regions, std::uint32_t tile)
{
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    const std::span<const std::uint16_t> points = set.tile(tile);
    std::array<std::uint32_t, 4> counts{};
    for (std::size_t i = 0; i < points.size(); i += dimension)
        ++counts[static_cast<std::size_t>(std::popcount(regions.cell_of(points.subspan(i, dimension)).axes))];
    return counts;
}

}

std::array<RegionCounts, 4> region_counts(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    const TileRegions regions = regions_of(p);
    const auto cells = static_cast<std::size_t>(p.dimension) + 1;

    std::array<RegionCounts, 4> result{};
    std::array<std::uint64_t, 4> sum{};
    for (std::size_t k = 0; k < cells; ++k) result[k].min = UINT32_MAX;
    for (std::uint32_t tile = 0; tile < p.tiles; ++tile) {
        const std::array<std::uint32_t, 4> counts = points_of_tile(set, regions, tile);
        for (std::size_t k = 0; k < cells; ++k) {
            result[k].min = std::min(result[k].min, counts[k]);
            result[k].max = std::max(result[k].max, counts[k]);
            sum[k] += counts[k];
        }
    }
    for (std::size_t k = 0; k < cells; ++k) {
        const auto axes = static_cast<std::uint8_t>((1 << k) - 1);
        result[k].mean = static_cast<double>(sum[k]) / p.tiles;
        result[k].expected = p.points_per_tile * whole_cells(p.dimension, static_cast<int>(k)) * regions.volume(axes);
        result[k].density = result[k].mean / result[k].expected;
    }
    return result;
}

}
