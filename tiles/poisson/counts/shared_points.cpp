#include "tiles/poisson/counts/shared_points.hpp"

#include <algorithm>
#include <vector>

namespace poissonlab {

double shared_points(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    std::vector<UnitPosition> places;
    places.reserve(std::size_t{p.tiles} * p.points_per_tile);
    for (std::uint32_t tile = 0; tile < p.tiles; ++tile)
        for (std::uint32_t i = 0; i < p.points_per_tile; ++i) places.push_back(set.position(tile, i));
    std::ranges::sort(places);
    double pairs = 0; // of tiles with a point at the same place
    for (auto first = places.begin(); first != places.end();) {
        const auto end = std::upper_bound(first, places.end(), *first);
        const auto tiles = static_cast<double>(end - first);
        pairs += tiles * tiles;
        first = end;
    }
    return pairs / p.tiles / p.tiles / p.points_per_tile;
}

}
