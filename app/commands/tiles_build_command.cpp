// poissonlab tiles build: constructs a Poisson disk (sphere) tile set, proves its minimum distance, and
// writes it.
#include "app/commands/commands.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/config/nearest_key.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>

#include <unistd.h>

namespace poissonlab {
namespace {

void check_word(const std::string& what, const std::string& word, const std::vector<std::string>& known)
{
    if (std::ranges::find(known, word) == known.end())
        throw InputError(fmt::format("tiles build: {} \"{}\": unknown{} (known: {})", what, word,
                                     did_you_mean(word, known), fmt::join(known, ", ")));
}

PoissonTileParameters checked_parameters(const TilesBuildOptions& o)
{
    check_word("kind", o.kind, poisson_tile_families.all());
    check_word("--filling", o.filling, tile_fillings.all());
    check_word("--engine", o.engine, engines.all());
    const bool is_template = o.kind == "template";
    if (is_template ? o.colors != 0 || o.tiles == 0 : o.tiles != 0 || o.colors == 0)
        throw InputError(fmt::format("tiles build: {} tiles need {} and have no {}", o.kind,
                                     is_template ? "--tiles" : "--colors", is_template ? "--colors" : "--tiles"));
    PoissonTileParameters p;
    const PoissonTileFamily family = *poisson_tile_families.find(o.kind);
    p.kind = family.kind;
    p.dimension = family.dimension;
    p.colors = is_template ? 1 : o.colors;
    p.tiles = is_template ? o.tiles : tile_count(p.kind, p.dimension, p.colors);
    p.points_per_tile = o.points;
    p.relative_radius = o.relative_radius;
    if (tile_fillings.find(o.filling) == TileFilling::dart_throwing) set_dart_throwing(p);
    p.lloyd_iterations = o.lloyd_iterations;
    p.repulsion = o.repulsion;
    p.seed = o.seed;
    try {
        check(p);
    } catch (const InputError& error) {
        throw error.moved_to({"tiles build"});
    }
    return p;
}

/// Building takes up to minutes, which a file that cannot be written would waste.
void check_target(const std::filesystem::path& file)
{
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code unknown;
    if (!std::filesystem::is_directory(folder, unknown))
        throw InputError(fmt::format("tiles build: --out {}: there is no folder {}", file.string(), folder.string()));
    if (std::filesystem::is_directory(file, unknown))
        throw InputError(fmt::format("tiles build: --out {}: is a folder", file.string()));
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw StorageError(fmt::format("tiles build: --out {}: cannot be written: {}", file.string(),
                                       std::generic_category().message(errno)));
}

void check_memory(const PoissonTileParameters& parameters, const DeviceInfo& device)
{
    check_fits(fmt::format("tiles build: filling a tile of {} points", parameters.points_per_tile),
               construction_memory(parameters, device), device);
}

}

void tiles_build_command(const TilesBuildOptions& options)
{
    const PoissonTileParameters parameters = checked_parameters(options);
    check_target(options.out);
    Progress progress(Progress::detect(options.quiet));
    const auto begin = std::chrono::steady_clock::now();
    ConstructionOptions construction;
    construction.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
        stop_if_interrupted();
        progress.step(fmt::format("{}: {} of {}", stage, done, total));
    };
    std::optional<Device> device;
    const DeviceProvider open = [&]() -> Device& {
        if (!device) device = Device::open(options.device);
        return *device;
    };
    const Engine engine = *engines.find(options.engine);
    if (engine == Engine::opencl) check_memory(parameters, open().info());
    const ConstructedTileSet built = build_tile_set(parameters, engine, open, construction);
    write_tile_set(options.out, built.set);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    progress.finish();
    if (options.quiet) return;
    fmt::print("{}: {} tiles of {} points, every tiling has a relative radius of {:.4f} or more, {}\n",
               options.out.string(), parameters.tiles, parameters.points_per_tile,
               relative_radius_of(built.set.squared_min_distance, parameters), duration_text(seconds));
    if (built.report.failures > 0)
        fmt::print("{} of {} fillings did not reach the minimum distance and were repeated; {} pieces were "
                   "made again\n",
                   built.report.failures, built.report.tori, built.report.remade);
}

}
