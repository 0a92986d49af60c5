#include "host/config/schemes/scheme_table.hpp"

#include "host/config/config_values.hpp"
#include "host/config/schemes/aperiodic_scheme_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::int64_t most_scheme_colors = 5; // those that the papers have names for
constexpr std::int64_t most_scheme_tiles = 16; // along each axis of a picture

Color read_scheme_colors(const ConfigTable& table, Color otherwise, std::int64_t most = most_scheme_colors)
{
    return static_cast<Color>(read_integer(table, "colors", 2, most, otherwise));
}

SchemeChoice read_corner_problem(const ConfigTable& table, std::uint64_t)
{
    check_keys(table, {"kind", "label", "colors"});
    constexpr std::int64_t most_compared_colors = 4; // pairs of their tiles are counted one by one
    return {CornerProblemSettings{read_scheme_colors(table, 2, most_compared_colors)}, "The corner problem"};
}

SchemeChoice read_scanline_steps(const ConfigTable& table, std::uint64_t)
{
    check_keys(table, {"kind", "label", "tiles", "colors", "set"});
    ScanlineStepsSettings settings;
    settings.tiles = read_word(table, "tiles", {"wang", "corner"}) == 0 ? TileKind::wang : TileKind::corner;
    settings.colors = read_scheme_colors(table, 2);
    settings.is_compact = read_word(table, "set", {"compact", "complete"}) == 0;
    return {settings, fmt::format("{} placed by scanlines, {} set over {} colours",
                                  settings.tiles == TileKind::wang ? "Wang tiles" : "Corner tiles",
                                  settings.is_compact ? "compact" : "complete", settings.colors)};
}

SchemeChoice read_direct_tiling(const ConfigTable& table, std::uint64_t seed)
{
    check_keys(table, {"kind", "label", "algorithm", "colors", "hash", "window"});
    static const std::vector<std::string> algorithms{"direct", "two-hashes", "one-hash", "edge-hash"};
    DirectTilingSettings settings;
    TilingRequest& request = settings.request;
    request.algorithm = algorithms[read_word(table, "algorithm", algorithms)];
    request.kind = request.algorithm == "direct" ? TileKind::corner : TileKind::wang;
    request.colors = read_scheme_colors(table, 2);
    request.seed = seed;
    if (find(table, "hash")) request.hash = static_cast<HashKind>(read_word(table, "hash", hash_names()));
    const auto w = read_integers(table, "window", 4, 4, -any_integer - 1, "[X, Y, width, height]");
    settings.window = {0, 0, 4, 3};
    if (!w.empty()) {
        const auto fits = [](std::int64_t size) { return size >= 1 && size <= most_scheme_tiles; };
        if (!fits(w[2]) || !fits(w[3]))
            throw invalid_node("window", *find(table, "window"),
                               fmt::format("must be of 1 to {} tiles along each axis", most_scheme_tiles));
        settings.window = {w[0], w[1], static_cast<std::uint64_t>(w[2]), static_cast<std::uint64_t>(w[3])};
    }
    return {settings,
            fmt::format("From a coloured lattice to {}: {}", tile_kind_words(request.kind), request.algorithm)};
}

SchemeChoice read_noise(const ConfigTable& table, std::uint64_t)
{
    check_keys(table, {"kind", "label", "pixels", "cells"});
    NoiseSettings settings;
    settings.pixels = static_cast<std::uint32_t>(read_integer(table, "pixels", 16, 2048, settings.pixels));
    settings.cells = static_cast<std::uint32_t>(read_integer(table, "cells", 1, 256, settings.cells));
    return {settings, "Perlin's noise with two hash functions"};
}

SchemeChoice read_tiling_costs(const ConfigTable& table, std::uint64_t)
{
    check_keys(table, {"kind", "label", "colors", "tiles"});
    TilingCostSettings settings;
    settings.colors = read_scheme_colors(table, settings.colors, 8);
    settings.tiles = static_cast<std::uint32_t>(read_integer(table, "tiles", 4096, 1 << 24, settings.tiles));
    return {settings, fmt::format("What tiles cost, {} colours", settings.colors)};
}

using ReadScheme = SchemeChoice (*)(const ConfigTable& table, std::uint64_t seed);

const std::vector<std::pair<std::string, ReadScheme>>& scheme_readers()
{
    static const std::vector<std::pair<std::string, ReadScheme>> all{{"corner-problem", read_corner_problem},
                                                                     {"scanline", read_scanline_steps},
                                                                     {"direct", read_direct_tiling},
                                                                     {"noise", read_noise},
                                                                     {"tiling-costs", read_tiling_costs},
                                                                     {"construction", read_construction_scheme},
                                                                     {"aperiodic-tables", read_aperiodic_tables},
                                                                     {"diffraction", read_diffraction},
                                                                     {"isohedral", read_isohedral},
                                                                     {"surface", read_surface}};
    return all;
}

}

const std::vector<std::string>& scheme_kinds()
{
    static const std::vector<std::string> kinds = [] {
        std::vector<std::string> words;
        for (const auto& [word, read] : scheme_readers()) words.push_back(word);
        return words;
    }();
    return kinds;
}

SchemeChoice read_scheme(const ConfigTable& table, const std::string& kind, std::uint64_t seed)
{
    const auto reader = std::ranges::find(scheme_readers(), kind, [](const auto& known) { return known.first; });
    return reader->second(table, seed);
}

}
