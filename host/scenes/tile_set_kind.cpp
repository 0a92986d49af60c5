// `tiles build` and poissonlab.tiles.build() make a Poisson tile set with the proof of its minimum distance.
#include "base/files/whole_file.hpp"
#include "base/programs/interrupt.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/tile_sets/tile_set_keys.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/monotiles/monotile_file.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

void built_tile_set_keys(Keys& keys, AskedTileSet& set)
{
    std::string word = poisson_tile_families[set.family];
    std::vector<std::string> words = poisson_tile_families.all(set.family);
    for (const char* monotile : {"hat", "spectre"}) words.emplace_back(monotile);
    keys.word("kind", word, std::move(words), "the kind of tiles");
    if (const auto family = poisson_tile_families.find(word))
        set.family = *family;
    else
        set.monotile = word;
    tile_set_keys(keys, set, {}, true);
}

std::string built_tile_set_label(const AskedTileSet& set)
{
    return fmt::format("Poisson {} tiles", set.monotile.empty() ? poisson_tile_families[set.family] : set.monotile);
}

/// Builds and writes the points of a monotile.
DistributionResult make_monotile_file(const AskedTileSet& set, const DistributionPlace& place, DistributionFiles& files)
{
    const auto number = [&](const char* key) { return static_cast<std::uint32_t>(set.values.integer(key)); };
    const MonotilePointsFile file(built_monotile_file(built_in_tiling(set.monotile), number("points_per_tile"),
                                                      number("levels"),
                                                      [&](const std::string& step) {
                                                          stop_if_interrupted();
                                                          if (place.on_step) place.on_step(step);
                                                      }),
                                  set.monotile);
    write_whole_file(files.add("tiles.ptiles"), file.bytes());
    DistributionResult result;
    result.facts = {fmt::format("{} states of tiles with {} points", file.set().states, file.set().points_per_tile)};
    result.numbers = {
        {"relative_radius", "Relative radius", file.relative_radius(), "proven: every tiling has it or a larger one"}};
    result.files.emplace_back("tiles.ptiles");
    return result;
}

DistributionResult make_tile_set_file(const AskedTileSet& set, std::uint64_t seed, const DistributionPlace& place,
                                      DistributionFiles& files)
{
    if (!set.monotile.empty()) return make_monotile_file(set, place, files);
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
