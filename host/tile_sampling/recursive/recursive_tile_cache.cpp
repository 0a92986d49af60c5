#include "host/tile_sampling/recursive/recursive_tile_cache.hpp"

#include "base/errors/errors.hpp"
#include "code_hashes.hpp"
#include "host/tile_construction/recursive/recursive_construction.hpp"
#include "host/tile_sampling/building_lock.hpp"
#include "host/tile_sampling/tile_set_build.hpp"
#include "tiles/recursive/recursive_tile_file.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <chrono>
#include <utility>

namespace poissonlab {
namespace {

using CacheClock = std::chrono::steady_clock;

double seconds_from(CacheClock::time_point begin)
{
    return std::chrono::duration<double>(CacheClock::now() - begin).count();
}

std::optional<RecursiveTileSet> stored_tiles(const std::filesystem::path& file, std::uint32_t points_per_tile,
                                             std::uint64_t seed)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    try {
        RecursiveTileSet tiles = read_recursive_tiles(file);
        if (tiles.points_per_tile() == points_per_tile && tiles.seed() == seed) return tiles;
    } catch (const InputError&) {
        // Built again below, which replaces it.
    }
    return std::nullopt;
}

void try_to_store_tiles(const std::filesystem::path& file, const RecursiveTileSet& tiles, const TileSetBuild& build)
{
    try {
        std::filesystem::create_directories(file.parent_path());
        std::filesystem::remove(build_record_file(file));
        write_recursive_tiles(file, tiles);
        write_build_record(file, build);
    } catch (const std::filesystem::filesystem_error&) {
        // A cache that cannot be written is no reason to fail.
    } catch (const StorageError&) {
    }
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
    const std::filesystem::path file =
        folder / fmt::format("recursive-n{}-seed{}-{}.rtiles", points_per_tile, seed, POISSONLAB_CONSTRUCTION_VERSION);
    std::optional<FileLock> lock;
    double waiting_seconds = 0;
    if (!folder.empty()) {
        auto stored = stored_tiles(file, points_per_tile, seed);
        if (!stored) {
            const auto begin = CacheClock::now();
            lock = building_lock(file, on_step);
            waiting_seconds = seconds_from(begin);
            stored = stored_tiles(file, points_per_tile, seed); // another process may have built them meanwhile
        }
        if (stored) return with_record(*std::move(stored), true, read_build_record(file), waiting_seconds);
    }
    const auto begin = CacheClock::now();
    RecursiveTileSet tiles = build_recursive_tiles(points_per_tile, seed, on_step);
    TileSetBuild build;
    build.seconds = seconds_from(begin);
    build.threads = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    if (!folder.empty()) try_to_store_tiles(file, tiles, build);
    return with_record(std::move(tiles), false, std::move(build), waiting_seconds);
}

}
