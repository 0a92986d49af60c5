#include "tiles/poisson/proof/piece_extents.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// The extents of the interiors of all tiles.
Extents interior_extents(const PoissonTileSet& set, const TileRegions& regions)
{
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, set.parameters.tiles), Extents{},
        [&](const tbb::blocked_range<std::uint32_t>& range, Extents extents) {
            for (std::uint32_t tile = range.begin(); tile < range.end(); ++tile) {
                const std::span<const std::uint16_t> points = set.tile(tile);
                for (std::size_t i = 0; i < points.size(); i += dimension) {
                    const auto point = points.subspan(i, dimension);
                    if (regions.cell_of(point).axes == all_axes(set.parameters.dimension))
                        extents.include(UnitPosition{point[0], point[1], dimension == 3 ? point[2] : 0});
                }
            }
            return extents;
        },
        [](Extents a, const Extents& b) {
            a.include(b);
            return a;
        });
}

}

void Extents::include(const Extents& other)
{
    if (other.are_empty()) return;
    include(other.low);
    include(other.high);
}

void Extents::include(const UnitPosition& position)
{
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], position[k]);
        high[k] = std::max(high[k], position[k]);
    }
}

std::vector<Extents> piece_extents(const PoissonTileSet& set, const SharedPieces& pieces)
{
    std::vector<Extents> extents(all_axes(set.parameters.dimension));
    for (std::uint8_t axes = 0; axes < extents.size(); ++axes) {
        for (std::uint32_t variant = 0; variant < piece_count(set.parameters, axes); ++variant)
            for (const UnitPosition& position : pieces.piece(axes, variant)) extents[axes].include(position);
    }
    extents.push_back(interior_extents(set, pieces.regions()));
    return extents;
}

std::uint64_t squared_separation(const std::vector<Extents>& one, const std::vector<Extents>& other, int dimension)
{
    std::int64_t smallest = 2 * tile_units; // where no cell has a point, places two above
    const auto consider = [&](const std::vector<Extents>& lowers, const std::vector<Extents>& uppers) {
        for (const Extents& lower : lowers) {
            for (std::size_t axes = 0; axes < uppers.size(); ++axes) {
                const Extents& upper = uppers[axes];
                if (lower.are_empty() || upper.are_empty()) continue;
                for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
                    const int places = axes >> k & 1 ? 1 : 2;
                    smallest = std::min<std::int64_t>(smallest, places * tile_units + upper.low[k] - lower.high[k]);
                }
            }
        }
    };
    consider(one, other);
    consider(other, one);
    return static_cast<std::uint64_t>(std::max<std::int64_t>(smallest, 0) * std::max<std::int64_t>(smallest, 0));
}

}
