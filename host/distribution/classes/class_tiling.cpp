#include "host/distribution/classes/class_tiling.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/cache_folder.hpp"
#include "host/settings/sampler_table.hpp"
#include "host/settings/tile_sets/tile_set_keys.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_sampling/tile_samplers.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <numeric>

namespace poissonlab {
namespace {

/// The report says that distances are proven: those of the file are what the program has proven when it wrote it.
void check_is_proven(const PoissonTileSet& set, const std::string& file)
{
    const TileClasses& classes = set.parameters.classes;
    for (std::size_t j = 0; j < classes.count(); ++j)
        for (std::size_t i = 0; i <= j; ++i)
            if (set.class_squared_distances[class_pair(i, j)] < squared_units(classes.distances.at(i, j)))
                throw InputError(
                    fmt::format("{}: the distance of classes {} and {} is not proven: see tiles verify", file, i, j));
}

PoissonTileSet set_with_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place)
{
    PoissonTileSet set = settings.colors > 0 ? cached_tile_set(class_tile_parameters(settings, seed), place.engine,
                                                               place.device, cache_folder(), place.on_step)
                                                   .set
                                             : read_tile_set(settings.tiles);
    if (set.parameters.classes.is_empty())
        throw InputError(
            fmt::format("{}: its points have no classes: see tiles build --class-points", settings.tiles.string()));
    const std::uint64_t points = std::uint64_t{settings.torus} * settings.torus * set.parameters.points_per_tile;
    if (points > static_cast<std::uint64_t>(max_points))
        throw InputError(
            fmt::format("a torus of {0} x {0} tiles has {1} points; at most {2}", settings.torus, points, max_points));
    check_is_proven(set, settings.tiles.string());
    return set;
}

/// Returns the distances that the set asks for, in sides of the torus.
ClassDistances distances_on_torus(const TileClasses& classes, std::uint32_t torus)
{
    ClassDistances distances(classes.count());
    for (std::size_t i = 0; i < classes.count(); ++i)
        for (std::size_t j = 0; j <= i; ++j) distances.set(i, j, classes.distances.at(i, j) / torus);
    return distances;
}

}

PoissonTileParameters class_tile_parameters(const ClassSettings& settings, std::uint64_t seed)
{
    AskedTileSet asked{.family = {PoissonTileKind::corner, 2}, .values = {}, .class_points = settings.points};
    asked.values = Parameters(tile_set_parameters(asked.family));
    asked.values.set("colors", std::int64_t{settings.colors});
    asked.values.set("relative_radius", settings.relative_radius);
    asked.values.set("points_per_tile",
                     std::accumulate(settings.points.begin(), settings.points.end(), std::int64_t{0}));
    if (settings.joint_iterations > 0) asked.values.set("joint_iterations", std::int64_t{settings.joint_iterations});
    if (settings.equal_moments > 0) asked.values.set("equal_moments", std::int64_t{settings.equal_moments});
    asked.class_distances = settings.distances;
    asked.class_matrix = settings.matrix;
    return asked.parameters(seed);
}

ClassSet tiled_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                       std::uint32_t number)
{
    const auto tiles = std::make_shared<const PoissonTileSet>(set_with_classes(settings, seed, place));
    return classes_by_tiles(tiles, settings, seed, place, number);
}

ClassSet classes_by_tiles(const std::shared_ptr<const PoissonTileSet>& tiles, const ClassSettings& settings,
                          std::uint64_t seed, const DistributionPlace& place, std::uint32_t number)
{
    const PoissonTileSet& set = *tiles;
    const TileClasses& classes = set.parameters.classes;
    const auto tiling_seed =
        number == 0 ? static_cast<std::uint32_t>(seed) : stream_key(seed, Purpose::class_darts, number)[0];
    ClassSet result;
    result.tiles = tiles;
    result.work.asked = distances_on_torus(classes, settings.torus);
    result.points.points = place.engine == Engine::reference
                               ? reference::torus_points(set, tiling_seed, settings.torus)
                               : TilePointGenerator(place.device(), set).generate_torus(tiling_seed, settings.torus);
    for (std::uint32_t tile = 0; tile < settings.torus * settings.torus; ++tile)
        for (std::uint32_t of = 0; of < classes.count(); ++of)
            result.points.classes.insert(result.points.classes.end(), classes.points[of], of);
    result.points.is_full.assign(classes.count(), false);
    return result;
}

}
