#include "results/pictures/stored_tilings.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <sstream>

namespace poissonlab {

namespace {

constexpr std::size_t most_tiles = 1'000'000; // of a window that is drawn

StoredFrequencies read_frequencies(const StoredObject& parent, const std::string& name)
{
    const auto object = parent.object(name);
    return {object.number("chi_square"), object.number("p_value")};
}

StoredColors read_colors(const StoredObject& object)
{
    StoredColors colors;
    colors.name = object.text("name");
    colors.count = object.numbers("counts").size();
    colors.frequencies = read_frequencies(object, "frequencies");
    const auto autocorrelation = object.object("autocorrelation");
    colors.autocorrelation_file = autocorrelation.file_name("file");
    colors.lags = autocorrelation.small_integer("lags", 0);
    colors.largest = autocorrelation.number("largest");
    const auto at = autocorrelation.numbers("largest_at");
    if (at.size() != 2) throw autocorrelation.error("largest_at", "must be two numbers");
    colors.largest_at = {at[0], at[1]};
    colors.bound = autocorrelation.number("bound");
    return colors;
}

StoredTilingStatistics read_statistics(const StoredObject& object)
{
    StoredTilingStatistics statistics;
    statistics.size = static_cast<std::size_t>(object.integer("size", 1));
    statistics.samples = static_cast<std::size_t>(object.integer("samples", 1));
    if (object.has("tile_frequencies")) statistics.tiles = read_frequencies(object, "tile_frequencies");
    for (const auto& colors : object.objects("colors")) statistics.colors.push_back(read_colors(colors));
    return statistics;
}

TileKind read_kind(const StoredObject& object)
{
    const auto kind = tile_kinds.find(object.text("kind"));
    if (!kind) throw object.error("kind", "must be \"corner\", \"wang\" or \"cube\"");
    return *kind;
}

void read_window(const StoredObject& object, TilingResult& tiling)
{
    const auto window = object.integers("window");
    const std::size_t axes = tiling.kind == TileKind::cube ? 3 : 2;
    if (window.size() != 2 * axes) throw object.error("window", fmt::format("must be {} numbers", 2 * axes));
    std::size_t tiles = 1;
    for (std::size_t i = 0; i < axes; ++i) {
        const std::int64_t size = window[axes + i];
        if (size < 1 || size > static_cast<std::int64_t>(most_tiles / tiles))
            throw object.error(
                "window", fmt::format("must have at least 1 tile along each axis and at most {} in all", most_tiles));
        tiling.origin[i] = window[i];
        tiling.size[i] = static_cast<std::size_t>(size);
        tiles *= tiling.size[i];
    }
}

TilingResult read_tiling(const StoredObject& object)
{
    TilingResult tiling;
    tiling.name = object.folder_name("name");
    tiling.label = object.text("label");
    tiling.kind = read_kind(object);
    tiling.colors =
        static_cast<Color>(object.integer("colors", 2, tiling.kind == TileKind::cube ? max_cube_colors : max_colors));
    tiling.tiles = static_cast<std::size_t>(object.integer("tiles", 1));
    tiling.file = object.file_name("file");
    if (object.has("regions")) tiling.regions = object.number("regions");
    if (object.has("set")) {
        tiling.set = object.text("set");
        return tiling;
    }
    tiling.algorithm = object.text("algorithm");
    read_window(object, tiling);
    if (object.has("hash")) {
        tiling.hash = object.text("hash");
        tiling.hash_period = object.numbers("hash_period");
        tiling.period = object.numbers("period");
    }
    if (object.has("statistics")) tiling.statistics = read_statistics(object.object("statistics"));
    return tiling;
}

}

std::vector<TilingResult> read_tilings(const StoredObject& root)
{
    std::vector<TilingResult> tilings;
    if (!root.has("tilings")) return tilings;
    for (const auto& object : root.objects("tilings")) tilings.push_back(read_tiling(object));
    return tilings;
}

std::vector<TileIndex> read_tiles(const std::filesystem::path& folder, const TilingResult& tiling)
{
    const auto file = folder / tiling.file;
    const TileSet all = TileSet::complete(tiling.kind, tiling.colors);
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
