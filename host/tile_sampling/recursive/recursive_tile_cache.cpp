#include "host/tile_sampling/recursive/recursive_sampler.hpp"

#include "code_hashes.hpp"
#include "host/tile_construction/recursive/recursive_construction.hpp"
#include "host/tile_sampling/built_once.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/recursive/recursive_tile_set.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <chrono>
#include <optional>
#include <utility>

namespace poissonlab {
namespace {

using TilesAndBuild = std::pair<RecursiveTileSet, std::optional<TileSetBuild>>;

std::optional<TilesAndBuild> stored_tiles(const std::filesystem::path& file, std::uint32_t points_per_tile,
                                          std::uint64_t seed)
{
    RecursiveTileSet tiles = read_recursive_tiles(file);
    if (tiles.points_per_tile() != points_per_tile || tiles.seed() != seed) return std::nullopt;
    return TilesAndBuild{std::move(tiles), read_build_record(file)};
}

void store_tiles(const std::filesystem::path& file, const TilesAndBuild& built)
{
    std::filesystem::remove(build_record_file(file)); // of earlier tiles, which the new ones must not be taken for
    write_recursive_tiles(file, built.first);
    write_build_record(file, *built.second);
}

TilesAndBuild timed_tiles(std::uint32_t points_per_tile, std::uint64_t seed,
                          const std::function<void(const std::string& what)>& on_step)
{
    const auto begin = std::chrono::steady_clock::now();
    RecursiveTileSet tiles = build_recursive_tiles(points_per_tile, seed, on_step);
    TileSetBuild build;
    build.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    build.threads = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    return {std::move(tiles), std::move(build)};
}

CachedRecursiveTiles with_record(RecursiveTileSet tiles, bool cached, std::optional<TileSetBuild> build,
                                 double waiting_seconds)
{
    TileSetRecord record;
    record.tiles = even_wang_tiles;
    record.points_per_tile = tiles.points_per_tile();
    record.cached = cached;
    record.build = std::move(build);
    return {std::move(tiles), std::move(record), waiting_seconds};
}

}

CachedRecursiveTiles cached_recursive_tiles(std::uint32_t points_per_tile, std::uint64_t seed,
                                            const std::filesystem::path& folder,
                                            const std::function<void(const std::string& what)>& on_step)
{
    const std::string name =
        fmt::format("recursive-n{}-seed{}-{}.rtiles", points_per_tile, seed, POISSONLAB_CONSTRUCTION_VERSION);
    auto once = built_once(
        folder.empty() ? folder : folder / name, on_step,
        [&](const std::filesystem::path& file) { return stored_tiles(file, points_per_tile, seed); },
        [&] { return timed_tiles(points_per_tile, seed, on_step); }, store_tiles);
    auto& [tiles, build] = once.built;
    return with_record(std::move(tiles), once.cached, std::move(build), once.waiting_seconds);
}

}
