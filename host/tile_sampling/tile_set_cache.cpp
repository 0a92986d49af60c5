#include "tile_sampling/tile_set_cache.hpp"

#include "errors/errors.hpp"
#include "poisson_tiles/tile_certificate.hpp"
#include "poisson_tiles/tile_set_file.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>

namespace poissonlab {
namespace {

/// Of the construction: another one gives other tiles for the same parameters.
constexpr int construction_version = 1;

std::optional<PoissonTileSet> stored_set(const std::filesystem::path& file,
                                         const PoissonTileParameters& parameters)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    try {
        PoissonTileSet set = read_tile_set(file);
        if (set.parameters == parameters && set.squared_min_distance >= asked_squared_distance(parameters))
            return set;
    } catch (const InputError&) {
        // Built again below, which replaces it.
    }
    return std::nullopt;
}

void try_to_store(const std::filesystem::path& file, const PoissonTileSet& set)
{
    try {
        std::filesystem::create_directories(file.parent_path());
        write_tile_set(file, set);
    } catch (const std::filesystem::filesystem_error&) {
        // A cache that cannot be written is no reason to fail.
    } catch (const StorageError&) {
    }
}

}

ConstructedTileSet build_tile_set(const PoissonTileParameters& parameters, Engine engine,
                                  const DeviceProvider& device, const ConstructionOptions& options)
{
    check(parameters);
    const FillSettings settings = fill_settings(parameters);
    const auto filler = engine == Engine::opencl ? make_tile_filler(settings, device())
                                                 : reference::make_tile_filler(settings);
    ConstructedTileSet built = construct_tile_set(parameters, *filler, options);
    built.set.squared_min_distance = certify(built.set).squared_min_distance;
    if (built.set.squared_min_distance < asked_squared_distance(parameters))
        throw std::logic_error("a tile set was built whose tilings do not keep the minimum distance");
    return built;
}

std::filesystem::path tile_cache_folder()
{
    const auto folder_of = [](const char* variable) {
        const char* value = std::getenv(variable);
        return std::filesystem::path(value ? value : "");
    };
    if (const auto folder = folder_of("POISSONLAB_CACHE"); !folder.empty()) return folder;
    if (const auto folder = folder_of("XDG_CACHE_HOME"); !folder.empty()) return folder / "poissonlab";
    if (const auto folder = folder_of("HOME"); !folder.empty()) return folder / ".cache" / "poissonlab";
    return {};
}

std::string tile_cache_name(const PoissonTileParameters& p, Engine engine)
{
    return fmt::format("{}-{}{}-n{}-rho{}-{}-{}x{}-lloyd{}{}-seed{}-{}-v{}.ptiles", kind_name(p),
                       p.kind == PoissonTileKind::frame ? "t" : "c",
                       p.kind == PoissonTileKind::frame ? p.tiles : p.colors, p.points_per_tile,
                       p.relative_radius, p.filling == TileFilling::dart_throwing ? "darts" : "relaxation",
                       p.attempts, p.factor, p.lloyd_iterations, p.repulsion ? "-repulsion" : "", p.seed,
                       engine == Engine::opencl ? "opencl" : "reference", construction_version);
}

PoissonTileSet cached_tile_set(const PoissonTileParameters& parameters, Engine engine,
                               const DeviceProvider& device, const std::filesystem::path& folder)
{
    if (folder.empty()) return build_tile_set(parameters, engine, device).set;
    const std::filesystem::path file = folder / tile_cache_name(parameters, engine);
    if (auto stored = stored_set(file, parameters)) return *std::move(stored);
    PoissonTileSet set = build_tile_set(parameters, engine, device).set;
    try_to_store(file, set);
    return set;
}

}
