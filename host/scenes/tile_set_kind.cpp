// `tiles build` and poissonlab.tiles.build() make a Poisson tile set with the proof of its minimum distance.
#include "base/programs/interrupt.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/tile_sets/tile_set_keys.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

void built_tile_set_keys(Keys& keys, AskedTileSet& set)
{
    keys.word("kind", set.family, poisson_tile_families, "the kind of tiles");
    tile_set_keys(keys, set, {}, true);
}

std::string built_tile_set_label(const AskedTileSet& set)
{
    return fmt::format("Poisson {} tiles", poisson_tile_families[set.family]);
}

DistributionResult make_tile_set_file(const AskedTileSet& set, std::uint64_t seed, const DistributionPlace& place,
                                      DistributionFiles& files)
{
    const PoissonTileParameters parameters = set.parameters(seed);
    ConstructionOptions options;
    options.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
        stop_if_interrupted();
        if (place.on_step) place.on_step(fmt::format("{}: {} of {}", stage, done, total));
    };
    if (place.engine == Engine::opencl)
        check_fits(fmt::format("filling a tile of {} points", parameters.points_per_tile),
                   build_memory(parameters, place.device().info()), place.device().info());
    const ConstructedTileSet built = build_tile_set(parameters, place.engine, place.device, options);
    write_tile_set(files.add("tiles.ptiles"), built.set);
    DistributionResult result;
    result.facts = {fmt::format("{} tiles of {} points", parameters.tiles, parameters.points_per_tile)};
    result.numbers = {{"relative_radius", "Relative radius",
                       relative_radius_of(built.set.squared_min_distance, parameters),
                       "proven: every tiling has it or a larger one"},
                      {"tori", "Fillings", static_cast<double>(built.report.tori), "of tori with points"},
                      {"failures", "Failures", static_cast<double>(built.report.failures),
                       "fillings that did not reach the minimum distance and were repeated"},
                      {"remade", "Pieces made again", static_cast<double>(built.report.remade),
                       "because of a tile that could not be filled"}};
    result.files.emplace_back("tiles.ptiles");
    return result;
}

}

Kind tile_set_kind()
{
    return make_kind<AskedTileSet>({"", "tiles build", "tiles build", "Poisson tile set",
                                    "Build a tile set and prove the minimum distance of its tilings"},
                                   built_tile_set_keys, built_tile_set_label, make_tile_set_file);
}

}
