#include "host/tile_sampling/polyominoes/polyomino_table_cache.hpp"

#include "base/errors/errors.hpp"
#include "code_hashes.hpp"
#include "host/tile_sampling/building_lock.hpp"
#include "tiles/polyominoes/polyomino_table_file.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>

namespace poissonlab {
namespace {

PolyominoTable table_with_steps(Polyomino shape, const std::function<void(const std::string& what)>& on_step)
{
    if (!on_step) return build_polyomino_table(shape);
    return build_polyomino_table(shape, [&](const std::string& what, std::size_t done, std::size_t total) {
        on_step(total > 0 ? fmt::format("table of polyominoes: {} {} of {}", what, done, total)
                          : fmt::format("table of polyominoes: {}", what));
    });
}

}

std::string polyomino_table_name(Polyomino shape)
{
    return fmt::format("polyominoes-{}-{}.table", polyominoes[shape], POISSONLAB_CONSTRUCTION_VERSION);
}

CachedPolyominoTable cached_polyomino_table(Polyomino shape, const std::filesystem::path& folder,
                                            const std::function<void(const std::string& what)>& on_step)
{
    if (folder.empty()) return {table_with_steps(shape, on_step)};
    const std::filesystem::path file = folder / polyomino_table_name(shape);
    if (auto stored = read_polyomino_table(file)) return {*std::move(stored), true};
    const auto begin = std::chrono::steady_clock::now();
    const std::optional<FileLock> lock = building_lock(file, on_step);
    const double waiting = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (auto stored = read_polyomino_table(file)) return {*std::move(stored), true, waiting}; // by another process
    CachedPolyominoTable built{table_with_steps(shape, on_step), false, waiting};
    try {
        write_polyomino_table(file, built.table);
    } catch (const StorageError&) {
        // A cache that cannot be written is no reason to fail.
    }
    return built;
}

}
