#include "host/tile_sampling/polyominoes/polyomino_table_cache.hpp"

#include "code_hashes.hpp"
#include "tiles/polyominoes/polyomino_table_file.hpp"

#include <fmt/format.h>

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

BuiltOnce<PolyominoTable> cached_polyomino_table(Polyomino shape, const std::filesystem::path& folder,
                                                 const std::function<void(const std::string& what)>& on_step)
{
    return built_once(
        folder.empty() ? folder : folder / polyomino_table_name(shape), on_step, read_polyomino_table,
        [&] { return table_with_steps(shape, on_step); }, write_polyomino_table);
}

}
