#include "results/pictures/stored_tiles.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <sstream>

namespace poissonlab {

std::vector<TileIndex> read_tiles(const std::filesystem::path& folder, const TilingResult& tiling)
{
    const auto file = folder / tiling.file;
    const TileSet all = TileSet::complete(tiling.kind, tiling.all_colors());
    std::istringstream text(read_whole_file(file));
    std::vector<TileIndex> tiles;
    for (std::uint64_t tile = 0; text >> tile;) {
        if (tile >= all.size())
            throw InputError(fmt::format("{}: {} is no tile of {} colours; must be less than {}", file.string(), tile,
                                         tiling.colors, all.size()));
        tiles.push_back(static_cast<TileIndex>(tile));
    }
    if (!text.eof() || tiles.size() != tiling.shown())
        throw InputError(
            fmt::format("{}: must hold {} tile indices, as results.json says", file.string(), tiling.shown()));
    return tiles;
}

}
