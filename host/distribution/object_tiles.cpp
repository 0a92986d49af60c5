#include "host/distribution/object_tiles.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/cache_folder.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

PoissonTileSet default_object_tiles(int dimension, const DistributionPlace& place)
{
    PoissonTileParameters p;
    p.kind = PoissonTileKind::corner;
    p.dimension = dimension;
    p.colors = dimension == 3 ? 2 : 3;
    p.tiles = tile_count(p.kind, dimension, p.colors);
    p.points_per_tile = dimension == 3 ? 128 : points_per_default_tile; // with fewer, spheres around corners would meet
    p.relative_radius = 0.75;
    p.lloyd_iterations = 20;
    p.repulsion = dimension == 3; // without it, edges fall short of the radius
    p.seed = 1;
    return cached_tile_set(p, place.engine, place.device, cache_folder(), place.on_step).set;
}

}

PoissonTileSet object_tile_set(const std::filesystem::path& file, int dimension, const DistributionPlace& place)
{
    if (file.empty()) return default_object_tiles(dimension, place);
    PoissonTileSet tiles = read_tile_set(file);
    if (tiles.parameters.dimension != dimension)
        throw InputError(fmt::format("tiles = \"{}\": are tiles in {} dimensions; must be in {}", file.string(),
                                     tiles.parameters.dimension, dimension));
    return tiles;
}

}
