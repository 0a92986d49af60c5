#include "results/pictures/tiling_result.hpp"

#include "base/errors/errors.hpp"
#include "base/files/json_members.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {

void members(JsonMembers& m, Stored<FrequencyTest> auto& test)
{
    m.member("chi_square", test.chi_square);
    m.member("p_value", test.p_value);
}

void members(JsonMembers& m, Stored<ColorStatistics> auto& colors)
{
    m.member("name", colors.name);
    m.member("counts", colors.counts);
    m.object("frequencies", colors.frequencies);
    m.group("autocorrelation", [&](JsonMembers& group) {
        group.file_name("file", colors.autocorrelation_file);
        group.member("lags", colors.autocorrelation.lags);
        group.or_none("chance", colors.autocorrelation.chance);
        group.member("largest", colors.autocorrelation.largest);
        group.member("largest_at", colors.autocorrelation.largest_at);
        group.or_none("agreement", colors.autocorrelation.agreement);
        group.member("bound", colors.autocorrelation.bound);
    });
}

void members(JsonMembers& m, Stored<TilingStatistics> auto& statistics)
{
    m.member("size", statistics.size, 1);
    m.member("samples", statistics.samples, 1);
    m.object("tile_frequencies", statistics.tiles);
    m.objects("colors", statistics.colors);
}

namespace {

constexpr std::size_t most_tiles = 1'000'000; // of a window that is drawn

void kind(JsonMembers& m, const TileKind& kind)
{
    const std::string word = tile_kinds[kind];
    m.member("kind", word);
}

void kind(JsonMembers& m, TileKind& kind)
{
    const auto known = tile_kinds.find(m.stored().text("kind"));
    if (!known) throw m.stored().error("kind", fmt::format("must be one of {}", fmt::join(tile_kinds.all(), ", ")));
    kind = *known;
}

void colors(JsonMembers& m, const TilingResult& tiling)
{
    m.member("colors", tiling.colors);
    m.if_any("vertical_colors", tiling.vertical_colors);
}

void colors(JsonMembers& m, TilingResult& tiling)
{
    tiling.colors = static_cast<Color>(m.stored().integer("colors", 2, most_colors_of(tiling.kind)));
    if (!m.stored().has("vertical_colors")) return;
    if (tiling.kind != TileKind::wang) throw m.stored().error("vertical_colors", "is of Wang tiles only");
    tiling.vertical_colors = static_cast<Color>(m.stored().integer("vertical_colors", 2, max_colors));
}

/// The origin of a window, then its size.
void window(JsonMembers& m, const TilingResult& tiling)
{
    const auto axes = static_cast<std::ptrdiff_t>(axes_of(tiling.kind));
    std::vector<std::int64_t> window(tiling.origin.begin(), tiling.origin.begin() + axes);
    window.insert(window.end(), tiling.size.begin(), tiling.size.begin() + axes);
    m.member("window", std::as_const(window));
}

void window(JsonMembers& m, TilingResult& tiling)
{
    const auto window = m.stored().integers("window");
    const std::size_t axes = axes_of(tiling.kind);
    if (window.size() != 2 * axes) throw m.stored().error("window", fmt::format("must be {} numbers", 2 * axes));
    std::size_t tiles = 1;
    for (std::size_t i = 0; i < axes; ++i) {
        const std::int64_t size = window[axes + i];
        if (size < 1 || size > static_cast<std::int64_t>(most_tiles / tiles))
            throw m.stored().error(
                "window", fmt::format("must have at least 1 tile along each axis and at most {} in all", most_tiles));
        tiling.origin[i] = window[i];
        tiling.size[i] = static_cast<std::size_t>(size);
        tiles *= tiling.size[i];
    }
}

void describe(JsonMembers& m, Stored<TilingResult> auto& tiling)
{
    m.folder_name("name", tiling.name);
    m.member("label", tiling.label);
    kind(m, tiling.kind);
    colors(m, tiling);
    m.member("tiles", tiling.tiles, 1);
    m.file_name("file", tiling.file);
    m.if_any("regions", tiling.regions);
    m.if_any("set", tiling.set);
    if (!tiling.set.empty()) return;
    m.member("algorithm", tiling.algorithm);
    window(m, tiling);
    m.if_any("hash", tiling.hash);
    if (!tiling.hash.empty()) {
        m.member("hash_period", tiling.hash_period);
        m.member("period", tiling.period);
    }
    m.object("statistics", tiling.statistics);
}

}

void members(JsonMembers& m, const TilingResult& tiling) { describe(m, tiling); }
void members(JsonMembers& m, TilingResult& tiling) { describe(m, tiling); }

std::string autocorrelation_file(const ColorStatistics& colors)
{
    std::string name = colors.name;
    std::ranges::replace(name, ' ', '-');
    return name + "-autocorrelation.exr";
}

}
