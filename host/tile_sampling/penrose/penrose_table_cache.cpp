#include "host/tile_sampling/penrose/penrose_table_cache.hpp"

#include "base/errors/errors.hpp"
#include "code_hashes.hpp"
#include "host/tile_sampling/building_lock.hpp"
#include "host/tile_sampling/penrose/penrose_relaxation.hpp"

#include <fmt/format.h>

#include <chrono>

namespace poissonlab {

std::string penrose_table_name() { return fmt::format("penrose-{}.table", POISSONLAB_SAMPLING_VERSION); }

CachedPenroseTable cached_penrose_table(const std::filesystem::path& folder,
                                        const std::function<void(const std::string& what)>& on_step)
{
    if (folder.empty()) return {relaxed_penrose_table({}, on_step)};
    const std::filesystem::path file = folder / penrose_table_name();
    if (const auto stored = read_penrose_table(file)) return {*stored, true};
    const auto begin = std::chrono::steady_clock::now();
    const auto lock = building_lock(file, on_step);
    const double waiting = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (const auto stored = read_penrose_table(file)) return {*stored, true, waiting}; // another process built it
    const PenroseTable table = relaxed_penrose_table({}, on_step);
    try {
        write_penrose_table(file, table);
    } catch (const StorageError&) {
        // A cache that cannot be written is no reason to fail.
    }
    return {table, false, waiting};
}

}
