// poissonlab tiles build: constructs a Poisson disk (sphere) tile set, proves its minimum distance, and
// writes it.
#include "app/commands/kind_options.hpp"
#include "base/files/whole_file.hpp"
#include "base/programs/interrupt.hpp"
#include "base/text/noun.hpp"
#include "experiment/run/progress.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/tile_sets/tile_set_keys.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/monotiles/monotile_file.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace poissonlab {
namespace {

constexpr auto tiles_build_notes =
    R"(corner: C^4 tiles; edge: C^12; sphere: C^8 in three dimensions; template: T tiles. Lloyd relaxation alone is good
for relative radii up to 0.75, with --repulsion 0.85 can be had. hat, spectre: 1 to 16 points in each copy of one tile,
whose tilings never repeat; they are made without random numbers, so that --seed changes nothing. The file is
described in docs/tile-set-file.md.
  poissonlab tiles build corner --colors 4 --points 64 --out corner.ptiles
  poissonlab tiles build corner --colors 4 --points 64 --border chain --out seamless.ptiles
  poissonlab tiles build template --tiles 16 --points 32 --relative-radius 0.8 --repulsion --out template.ptiles
  poissonlab tiles build spectre --points 4 --out spectre.ptiles)";

ConstructedTileSet built_tiles(const KindOptions& o, const PoissonTileParameters& parameters)
{
    const DistributionPlace place = o.place();
    if (place.engine == Engine::opencl)
        check_fits(fmt::format("filling a tile of {} points", parameters.points_per_tile),
                   build_memory(parameters, place.device().info()), place.device().info());
    ConstructionOptions construction;
    construction.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
        place.on_step(fmt::format("{}: {} of {}", stage, done, total));
    };
    return build_tile_set(parameters, place.engine, place.device, construction);
}

void print_built_tiles(const KindOptions& o, const PoissonTileParameters& parameters, const ConstructedTileSet& built,
                       double seconds)
{
    const double relative_radius = relative_radius_of(built.set.squared_min_distance, parameters);
    if (o.prints_json()) {
        const nlohmann::ordered_json json{{"file", printable(o.out.string())},
                                          {"tiles", parameters.tiles},
                                          {"points_per_tile", parameters.points_per_tile},
                                          {"relative_radius", relative_radius},
                                          {"fillings", built.report.tori},
                                          {"failures", built.report.failures},
                                          {"remade", built.report.remade},
                                          {"seconds", seconds}};
        fmt::print("{}\n", json.dump(2));
        return;
    }
    if (o.is_quiet()) return;
    fmt::print("{}: {} tiles of {} points, every tiling has a relative radius of {:.4f} or more, {}\n", o.out.string(),
               parameters.tiles, parameters.points_per_tile, relative_radius, duration_text(seconds));
    if (built.report.failures > 0)
        fmt::print("{} of {} fillings did not reach the minimum distance and were repeated; {} pieces were "
                   "made again\n",
                   built.report.failures, built.report.tori, built.report.remade);
}

void print_built_monotile(const KindOptions& o, const MonotilePointsFile& file, double seconds)
{
    const pmono_set& set = file.set();
    if (o.prints_json()) {
        const nlohmann::ordered_json json{{"file", printable(o.out.string())},
                                          {"states", set.states},
                                          {"points_per_tile", set.points_per_tile},
                                          {"relative_radius", file.relative_radius()},
                                          {"seconds", seconds}};
        fmt::print("{}\n", json.dump(2));
    } else if (!o.is_quiet()) {
        fmt::print("{}: {} states of tiles with {}, every tiling has a relative radius of {:.4f} or more, {}\n",
                   o.out.string(), set.states,
                   fmt::format("{} {}", set.points_per_tile, noun(set.points_per_tile, "point")),
                   file.relative_radius(), duration_text(seconds));
    }
}

void build_monotile(const KindOptions& o, const AskedTileSet& asked)
{
    checked_output("tiles build", "--out", o.out, {{".ptiles"}, false, true});
    const auto begin = std::chrono::steady_clock::now();
    const auto number = [&](const char* key) { return static_cast<std::uint32_t>(asked.values.integer(key)); };
    const DistributionPlace place = o.place();
    const auto on_step = [&](const std::string& step) {
        stop_if_interrupted();
        if (place.on_step) place.on_step(step);
    };
    const MonotilePointsFile file(
        built_monotile_file(built_in_tiling(asked.monotile), number("points_per_tile"), number("levels"), on_step),
        o.out.string());
    write_whole_file(o.out, file.bytes());
    print_built_monotile(o, file, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

void build_tiles(const KindOptions& o)
{
    const KindSettings settings = o.settings();
    if (!settings.as<AskedTileSet>().monotile.empty()) return build_monotile(o, settings.as<AskedTileSet>());
    const PoissonTileParameters parameters = settings.as<AskedTileSet>().parameters(o.seed());
    checked_output("tiles build", "--out", o.out, {{".ptiles", ".json"}, false, true});
    const auto begin = std::chrono::steady_clock::now();
    const ConstructedTileSet built = built_tiles(o, parameters);
    write_tile_set(o.out, built.set);
    print_built_tiles(o, parameters, built,
                      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

}

Command tiles_build_command()
{
    const auto o = std::make_shared<KindOptions>(*find_kind("", "tiles build"), "kind");
    return kind_command(o, {{"--out", &o->out, "The file: .ptiles, or .json for people", "FILE", required}},
                        tiles_build_notes, build_tiles);
}

}
