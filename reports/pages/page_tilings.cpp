// The page's section on tile sets and tilings.
#include "base/text/noun.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {

namespace {

PageData tiling_picture(const ReportTiling& tiling, const std::filesystem::path& page_folder, const std::string& shown,
                        const std::string& linked, const std::string& title, const std::string& caption)
{
    PageData data;
    data.set("title", title);
    data.set("caption", caption);
    data.set("alt", fmt::format("{}: {}. {}", tiling.stored->label, title, caption));
    data.set("source", relative_link(page_folder, tiling.pictures / shown));
    data.set("link", relative_link(page_folder, tiling.pictures / linked));
    return data;
}

std::string shown_tiles(const TilingResult& stored)
{
    if (!stored.set.empty()) return fmt::format("All {} tiles in order of their indices.", format_count(stored.tiles));
    const std::size_t axes = axes_of(stored.kind);
    const std::vector<std::size_t> sizes(stored.size.begin(), stored.size.begin() + static_cast<std::ptrdiff_t>(axes));
    const std::vector<std::int64_t> origin(stored.origin.begin(),
                                           stored.origin.begin() + static_cast<std::ptrdiff_t>(axes));
    return fmt::format("{} tiles from ({}) on.", fmt::join(sizes, " × "), fmt::join(origin, ", "));
}

std::string picture_caption(const TilingResult& stored)
{
    if (stored.regions == 0) return shown_tiles(stored);
    return fmt::format("{} Regions of Poisson {} of radius {}.", shown_tiles(stored),
                       stored.kind == TileKind::cube ? "spheres" : "disks", format_significant(stored.regions, 3));
}

std::string period_text(const TilingResult& stored, const std::vector<std::size_t>& period, const char* never)
{
    std::vector<std::string> texts;
    for (const std::size_t p : period)
        if (texts.size() < axes_of(stored.kind)) texts.push_back(p > 0 ? format_count(p) : std::string(never));
    return fmt::format("{}", fmt::join(texts, " × "));
}

PageData facts_of(const TilingResult& stored)
{
    PageData facts{PageData::type::list};
    facts << PageData(std::string(tile_kind_words(stored.kind)));
    facts << PageData(stored.vertical_colors > 0
                          ? fmt::format("{} horizontal and {} vertical colours", stored.colors, stored.vertical_colors)
                          : fmt::format("{} {}", stored.colors, noun(stored.colors, "colour")));
    facts << PageData(fmt::format("{} {} in the set", format_count(stored.tiles), noun(stored.tiles, "tile")));
    if (!stored.algorithm.empty()) facts << PageData("algorithm " + stored.algorithm);
    if (!stored.hash.empty())
        facts << PageData(fmt::format("hash {}, repeats after {} tiles", stored.hash,
                                      period_text(stored, stored.hash_period, "infinitely many")));
    if (std::ranges::any_of(stored.period, [](std::size_t p) { return p > 0; }))
        facts << PageData("closes after " + period_text(stored, stored.period, "–") + " tiles");
    return facts;
}

PageData fact_of(const std::string& name, const std::string& value, const std::string& meaning)
{
    PageData data;
    data.set("name", name);
    data.set("value", value);
    data.set("meaning", meaning);
    return data;
}

std::string p_text(double p) { return p < 1e-4 ? "p < 0.0001" : "p = " + format_significant(p, 2); }

/// Words on the place of the largest correlation, and on what follows from it: correlation within its bound is chance,
/// beyond it a dependence, and repetition only where all pairs agree.
std::string correlation_words(const ColorAutocorrelation& correlation)
{
    const std::string where =
        fmt::format("at ({}, {}); chance passes {} once in a hundred tilings", correlation.largest_at[0],
                    correlation.largest_at[1], format_fixed(correlation.bound, 2));
    if (correlation.largest <= correlation.bound) return where + ": no trace of repetition";
    if (correlation.agreement == 0 && correlation.chance == 0) return where; // of older runs, which did not store them
    const auto percent = [](double share) { return format_significant(100 * share, 3) + " %"; };
    return fmt::format("{}: {} of the pairs of tiles there have the same colour, by chance {}: {}", where,
                       percent(correlation.agreement), percent(correlation.chance),
                       correlation.agreement == 1 ? "these colours repeat" : "they depend on each other");
}

PageData measures_of(const TilingResult& stored)
{
    PageData list{PageData::type::list};
    if (!stored.statistics) return list;
    const auto& statistics = *stored.statistics;
    if (statistics.tiles)
        list << fact_of(
            "Frequencies of tiles", p_text(statistics.tiles->p_value),
            fmt::format("chi-square {} for {} tiles of the set in {} of the tiling: a small p says that some "
                        "come too often",
                        format_significant(statistics.tiles->chi_square, 4), format_count(stored.tiles),
                        format_count(statistics.samples)));
    for (const ColorStatistics& colors : statistics.colors) {
        list << fact_of(fmt::format("Frequencies of colours, {}", colors.name), p_text(colors.frequencies.p_value),
                        fmt::format("chi-square {} for {} colours",
                                    format_significant(colors.frequencies.chi_square, 3), colors.counts.size()));
        list << fact_of(fmt::format("Largest correlation, {}", colors.name),
                        fmt::format("{} standard deviations", format_significant(colors.autocorrelation.largest, 3)),
                        correlation_words(colors.autocorrelation));
    }
    return list;
}

}

PageData tiling_section(const ReportTiling& tiling, std::size_t index, const std::filesystem::path& page_folder)
{
    const auto& stored = *tiling.stored;
    PageData data;
    data.set("label", stored.label);
    data.set("anchor", fmt::format("tiles-{}", index + 1));
    data.set("facts", facts_of(stored));
    PageData tiles = tiling_picture(tiling, page_folder, "tiles.svg", "tiles.svg",
                                    stored.set.empty() ? "Tiling" : "Tile set", picture_caption(stored));
    tiles.set("beside", fmt::format("beside-{}", stored.statistics ? stored.statistics->colors.size() : 0));
    data.set("picture", tiles);
    PageData pictures{PageData::type::list};
    if (stored.statistics)
        for (const ColorStatistics& colors : stored.statistics->colors) {
            const auto name = autocorrelation_picture(colors);
            pictures << tiling_picture(
                tiling, page_folder, name, name, "Autocorrelation of " + colors.name,
                fmt::format("Displacements up to {0} along each axis, over {1} × {1} tiles; black −{2}, white {2} "
                            "standard deviations.",
                            colors.autocorrelation.lags, format_count(stored.statistics->size), format_exact(shown_z)));
        }
    data.set("autocorrelations", pictures);
    const PageData measures = measures_of(stored);
    data.set("measures", measures);
    data.set("has_measures", measures.is_non_empty_list());
    data.set("png", relative_link(page_folder, tiling.pictures / "tiles.png"));
    data.set("svg", relative_link(page_folder, tiling.pictures / "tiles.svg"));
    data.set("text", relative_link(page_folder, tiling.run->folder / stored.file));
    return data;
}

}
