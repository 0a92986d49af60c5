#include "reports/pages/page_texture_ranking.hpp"

#include "reports/words/measure_words.hpp"
#include "reports/words/number_format.hpp"
#include "results/texture_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace poissonlab {
namespace {

/// Distances from the exemplar by which textures are ranked, and what else they are chosen by.
constexpr std::array ranked_measures = {"histogram_spread", "contrast_spread", "gradient_spread",
                                        "structure_spread", "peak_times",      "contrast_peak_times"};
constexpr std::array cost_measures = {"contrast", "atlas_bytes", "fetches", "pixel_nanoseconds"};

const Measure& texture_measure(const std::string& key)
{
    return *std::ranges::find(texture_measures(), key, &Measure::key);
}

std::optional<double> measured(const ReportRun& run, std::size_t place, const std::string& key)
{
    const auto value = texture_value(texture_measure(key), *run.distributions[place].stored);
    return value ? std::optional(value->value) : std::nullopt;
}

/// 1 for the least value; equal ones share the mean of their ranks.
double rank_among(const std::vector<double>& values, double value)
{
    const auto below = std::ranges::count_if(values, [&](double other) { return other < value; });
    const auto equal = std::ranges::count(values, value);
    return static_cast<double>(below) + (static_cast<double>(equal) + 1) / 2;
}

struct RankedTexture
{
    std::size_t place = 0;
    double rank = 0; ///< mean over measures
};

std::vector<RankedTexture> ranked_textures(const ReportRun& run, const std::vector<std::size_t>& places)
{
    std::vector<RankedTexture> ranked;
    for (const std::size_t place : places)
        if (std::ranges::all_of(ranked_measures,
                                [&](const char* key) { return measured(run, place, key).has_value(); }))
            ranked.push_back({place, 0});
    for (const char* key : ranked_measures) {
        std::vector<double> values;
        for (const RankedTexture& texture : ranked) values.push_back(*measured(run, texture.place, key));
        for (std::size_t i = 0; i < ranked.size(); ++i)
            ranked[i].rank += rank_among(values, values[i]) / static_cast<double>(ranked_measures.size());
    }
    std::ranges::stable_sort(ranked, {}, &RankedTexture::rank);
    return ranked;
}

PageData ranking_cell(const ReportRun& run, std::size_t place, const char* key)
{
    PageData cell;
    const Measure& measure = texture_measure(key);
    const auto value = texture_value(measure, *run.distributions[place].stored);
    const std::string shown = value ? words_of(measure, *value).shown : std::string();
    cell.set("shown", shown.empty() ? PageData(false) : PageData(shown));
    cell.set("exact", value ? format_exact(value->value) : "");
    return cell;
}

PageData ranking_row(const ReportRun& run, const RankedTexture& texture, const std::string& anchor)
{
    PageData row, cells{PageData::type::list};
    row.set("label", run.distributions[texture.place].stored->label);
    row.set("anchor", fmt::format("{}{}", anchor, texture.place + 1));
    row.set("rank", fmt::format("{:.1f}", texture.rank));
    for (const char* key : ranked_measures) cells << ranking_cell(run, texture.place, key);
    for (const char* key : cost_measures) cells << ranking_cell(run, texture.place, key);
    row.set("cells", cells);
    return row;
}

}

PageData texture_ranking(const ReportRun& run, const std::vector<std::size_t>& places, const std::string& anchor)
{
    const std::vector<RankedTexture> ranked = ranked_textures(run, places);
    if (ranked.size() < 2) return PageData(false);
    PageData data, heads{PageData::type::list}, rows{PageData::type::list};
    const auto add_head = [&](const char* key) {
        PageData head;
        head.set("name", texture_measure(key).name);
        head.set("unit", texture_measure(key).unit);
        heads << head;
    };
    for (const char* key : ranked_measures) add_head(key);
    for (const char* key : cost_measures) add_head(key);
    for (const RankedTexture& texture : ranked) rows << ranking_row(run, texture, anchor);
    data.set("heads", heads);
    data.set("rows", rows);
    return data;
}

}
