#include "host/distribution/classes/class_tiling.hpp"

#include "base/errors/errors.hpp"
#include "host/settings/sampler_table.hpp"
#include "host/tile_points/tile_points.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

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

PoissonTileSet set_with_classes(const ClassSettings& settings)
{
    PoissonTileSet set = read_tile_set(settings.tiles);
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

ClassSet tiled_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place)
{
    const PoissonTileSet set = set_with_classes(settings);
    const TileClasses& classes = set.parameters.classes;
    const auto tiling_seed = static_cast<std::uint32_t>(seed);
    ClassSet result;
    result.request.distances = distances_on_torus(classes, settings.torus);
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
