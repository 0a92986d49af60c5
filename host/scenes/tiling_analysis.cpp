#include "host/scenes/tiling_analysis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace poissonlab {
namespace {

constexpr double least_expected = 10;           // of a cell of a chi-square test
constexpr std::uint64_t statistics_size = 1024; // tiles along each axis
constexpr std::uint64_t statistics_samples = statistics_size * statistics_size / 4;

/// Colours where tiles meet, and how many tiles there are of each.
struct Survey
{
    std::vector<ColorField> fields;
    std::vector<std::uint64_t> tiles; ///< by position in the set, at even places; empty: too many tiles to count
};

/// The places whose colours a tile brings to the fields: its lower left corner, its southern and western edge, or the
/// same faces and the lower one.
std::vector<std::string> field_names(TileKind kind)
{
    if (kind == TileKind::wang) return {"horizontal edges", "vertical edges"};
    if (kind == TileKind::wang_cube)
        return {"northern and southern faces", "eastern and western faces", "top and bottom faces"};
    return {"corners"};
}

std::vector<Color> colors_of(TileKind kind, TileIndex index, WangColors colors)
{
    if (kind == TileKind::wang) {
        const WangTile tile = wang_tile(index, colors);
        return {tile.south, tile.west};
    }
    if (kind == TileKind::wang_cube) {
        const WangCube cube = wang_cube(index, colors.horizontal);
        return {cube.south, cube.west, cube.bottom};
    }
    if (kind == TileKind::cube) return {cube_tile(index, colors.horizontal).bottom.south_west};
    return {corner_tile(index, colors.horizontal).south_west};
}

Survey survey_of(const ShownTiling& config)
{
    const TilingRequest& request = config.request;
    const TileSet set = tile_set_of(request);
    CubeWindow window = config.window;
    window.width = window.height = statistics_size;
    window.depth = 1;
    Survey survey;
    const bool counted = static_cast<double>(statistics_samples) >= least_expected * static_cast<double>(set.size());
    if (counted) survey.tiles.resize(set.size());
    const WangColors all_colors = request.all_colors();
    const std::size_t count = field_names(request.kind).size();
    survey.fields.assign(
        count, {request.colors, statistics_size, std::vector<std::uint8_t>(statistics_size * statistics_size)});
    if (request.kind == TileKind::wang) survey.fields[1].colors = all_colors.vertical;
    stream_tiles(request, window, [&](std::int64_t x, std::int64_t y, auto, std::span<const TileIndex> tiles) {
        const auto row = static_cast<std::uint64_t>(y) - static_cast<std::uint64_t>(window.y);
        auto column = static_cast<std::uint64_t>(x) - static_cast<std::uint64_t>(window.x);
        for (const TileIndex tile : tiles) {
            const auto colors = colors_of(request.kind, tile, all_colors);
            for (std::size_t f = 0; f < count; ++f)
                survey.fields[f].values[row * statistics_size + column] = static_cast<std::uint8_t>(colors[f]);
            if (counted && row % 2 == 0 && column % 2 == 0) ++survey.tiles.at(set.position(tile).value());
            ++column;
        }
    });
    return survey;
}

}

std::string tiles_text(const ShownTiling& config)
{
    std::string text;
    if (config.is_set()) {
        const TileSet set = tile_set_of(config);
        for (std::uint64_t i = 0; i < set.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : " ", set.index(i));
        return text + "\n";
    }
    const std::int64_t end = stepped(config.window.x, config.window.width);
    std::int64_t layer = config.window.z;
    stream_tiles(config.request, config.window,
                 [&](std::int64_t x, auto, std::int64_t z, std::span<const TileIndex> tiles) {
                     if (z != layer) text += "\n";
                     layer = z;
                     text += fmt::format("{}{}", fmt::join(tiles, " "), stepped(x, tiles.size()) == end ? "\n" : " ");
                 });
    return text;
}

TilingStatistics tiling_statistics(const ShownTiling& config)
{
    const Survey survey = survey_of(config);
    TilingStatistics statistics;
    statistics.size = statistics_size;
    statistics.samples = statistics_samples;
    if (!survey.tiles.empty()) statistics.tiles = test_frequencies(survey.tiles);
    for (std::size_t f = 0; f < survey.fields.size(); ++f) {
        const ColorField& field = survey.fields[f];
        const auto counts = color_counts(field);
        statistics.colors.push_back({field_names(config.request.kind)[f],
                                     counts,
                                     test_frequencies(counts),
                                     {},
                                     color_autocorrelation(field, statistics_lags)});
    }
    return statistics;
}

}
