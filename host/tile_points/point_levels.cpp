#include "host/tile_points/point_levels.hpp"

#include <tbb/parallel_for.h>

namespace poissonlab {

PointLevels::PointLevels(const PoissonTileSet& tiles, const PoissonTiling& tiling, const TileBlock& block,
                         std::uint64_t first)
    : tiling_(runtime_tiling(tiles, tiling)), block_(block), done_(first)
{}

void PointLevels::write_tile(std::uint64_t tile, double* levels) const
{
    const ptiles_set& set = tiling_.set;
    const std::uint64_t row = tile / block_.size[0];
    const std::array<std::uint64_t, 3> offset{tile % block_.size[0], row % block_.size[1], row / block_.size[1]};
    std::int32_t place[3];
    for (std::size_t a = 0; a < 3; ++a) place[a] = block_.lowest[a] + static_cast<std::int32_t>(offset[a]);
    const std::uint16_t* numbers = ptiles_points(&set, ptiles_tile(&tiling_, place[0], place[1], place[2]));
    for (std::uint32_t n = 0; n < set.points_per_tile; ++n, numbers += set.dimension)
        levels[n] = ptiles_point_at(&tiling_, place, n, numbers).level;
}

std::span<const double> PointLevels::next(std::size_t tiles)
{
    const std::size_t points = tiling_.set.points_per_tile;
    levels_.resize(tiles * points);
    tbb::parallel_for(std::size_t{0}, tiles,
                      [&](std::size_t t) { write_tile(done_ + t, levels_.data() + t * points); });
    done_ += tiles;
    return levels_;
}

PointSet at_density(PointSet points, double density, const PoissonTileSet& tiles, std::uint32_t seed,
                    std::uint32_t period)
{
    if (density >= 1) return points;
    const auto dimension = static_cast<std::size_t>(points.dimension);
    const TileBlock block{{}, {period, period, dimension == 3 ? period : 1}};
    PointLevels levels(tiles, {seed, static_cast<std::int32_t>(period)}, block);
    std::size_t kept = 0;
    const std::span<const double> all = levels.next(block.tiles());
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i] >= density) continue;
        for (std::size_t k = 0; k < dimension; ++k)
            points.coordinates[kept * dimension + k] = points.coordinates[i * dimension + k];
        ++kept;
    }
    points.coordinates.resize(kept * dimension);
    return points;
}

}
