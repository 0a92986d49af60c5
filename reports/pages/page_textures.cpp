// A run's textures: those of one exemplar beside each other, in a table of the measures that they have.
#include "reports/layout/distribution_pictures.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"
#include "reports/words/measure_words.hpp"
#include "reports/words/number_format.hpp"
#include "results/texture_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

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

/// The table, `places` being those of textures in the run's list: heads, rows; false unless two textures or more have
/// all distances from their exemplar. `anchor` is a prefix, to which a texture's place + 1 is added.
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

/// The numbers that stand under a tiling.
constexpr std::array tiling_measures = {"seam_mismatch", "novelty",          "longest_run", "border_exceptions",
                                        "lattice_power", "exemplar_power",   "repetition",  "color_distance",
                                        "contrast",      "structure_spread", "peak_times"};

/// Tables with more textures would be wider than pages: the others go into tables of their own.
constexpr std::size_t textures_in_a_table = 6;

const char* arrow_of(const Measure& measure)
{
    return measure.better == Better::higher  ? "↑ higher is better"
           : measure.better == Better::lower ? "↓ lower is better"
                                             : "";
}

PageData texture_cell(const Measure& measure, const DistributionResult& texture)
{
    const auto value = texture_value(measure, texture);
    const MeasureWords words = value ? words_of(measure, *value) : MeasureWords{};
    PageData data;
    data.set("shown", optional_text(words.shown));
    data.set("exact", value ? format_exact(value->value) : "");
    data.set("error", optional_text(words.spread));
    return data;
}

PageData texture_note(const Measure& measure)
{
    PageData data;
    data.set("name", measure.title());
    data.set("text", measure.meaning);
    return data;
}

/// Places of textures in a run's list.
using TexturePlaces = std::vector<std::size_t>;

/// The textures of each exemplar, in the order of the first ones.
std::vector<TexturePlaces> textures_by_exemplar(const ReportRun& run)
{
    std::vector<TexturePlaces> groups;
    const auto exemplar = [&](std::size_t i) { return run.distributions[i].stored->parameter("exemplar"); };
    for (std::size_t i = 0; i < run.distributions.size(); ++i) {
        if (!is_of_textures(run.distributions[i])) continue;
        const auto group = std::ranges::find_if(
            groups, [&](const TexturePlaces& places) { return exemplar(places.front()) == exemplar(i); });
        if (group == groups.end())
            groups.push_back({i});
        else
            group->push_back(i);
    }
    return groups;
}

std::string texture_anchor(std::size_t place) { return fmt::format("distribution-{}", place + 1); }

/// A measure with its values of all textures; false where none has it.
PageData texture_row(const Measure& measure, const ReportRun& run, const TexturePlaces& places)
{
    PageData row, cells{PageData::type::list};
    bool is_there = false;
    for (const std::size_t place : places) {
        const DistributionResult& texture = *run.distributions[place].stored;
        is_there = is_there || texture_value(measure, texture);
        cells << texture_cell(measure, texture);
    }
    if (!is_there) return false;
    row.set("title", measure.title());
    row.set("unit", measure.unit);
    row.set("arrow", arrow_of(measure));
    row.set("cells", cells);
    return row;
}

/// The picture of a texture whose file has this name; null where there is none.
const DistributionPicture* texture_picture(const ReportDistribution& texture, const std::string& name)
{
    const auto& pictures = texture.stored->pictures;
    const auto found = std::ranges::find_if(pictures, [&](const DistributionPicture& picture) {
        return std::filesystem::path(picture.file).filename() == name;
    });
    return found == pictures.end() ? nullptr : &*found;
}

PageData tiling_numbers(const DistributionResult& texture)
{
    PageData list{PageData::type::list};
    for (const Measure& measure : texture_measures()) {
        const auto value = texture_value(measure, texture);
        if (!value || std::ranges::find(tiling_measures, measure.key) == tiling_measures.end()) continue;
        PageData number;
        number.set("name", measure.name);
        number.set("value", words_of(measure, *value).shown);
        list << number;
    }
    return list;
}

/// The exemplar and the tilings of all its textures, to be seen side by side.
PageData texture_tilings(const ReportRun& run, const TexturePlaces& places, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    const auto add = [&](const ReportDistribution& texture, const DistributionPicture& picture,
                         const std::string& label, const std::string& anchor, const PageData& numbers) {
        PageData data;
        data.set("source", relative_link(page_folder, png_of(texture, picture)));
        data.set("alt", fmt::format("{}. {}", label, picture.caption));
        data.set("label", label);
        data.set("anchor", anchor);
        data.set("numbers", numbers);
        list << data;
    };
    for (const std::size_t place : places)
        if (const auto* exemplar = texture_picture(run.distributions[place], "exemplar.png")) {
            add(run.distributions[place], *exemplar, "Exemplar", texture_anchor(place), PageData(false));
            break;
        }
    for (const std::size_t place : places) {
        const ReportDistribution& texture = run.distributions[place];
        if (const auto* tiling = texture_picture(texture, "tiling.png"))
            add(texture, *tiling, texture.stored->label, texture_anchor(place), tiling_numbers(*texture.stored));
    }
    return list;
}

/// A row for each measure, a column for each texture.
PageData texture_table(const ReportRun& run, const TexturePlaces& places)
{
    PageData data, heads{PageData::type::list}, rows{PageData::type::list};
    for (const std::size_t place : places) {
        PageData head;
        head.set("label", run.distributions[place].stored->label);
        head.set("anchor", texture_anchor(place));
        heads << head;
    }
    for (const Measure& measure : texture_measures())
        if (PageData row = texture_row(measure, run, places); !row.is_false()) rows << row;
    data.set("heads", heads);
    data.set("rows", rows);
    return data;
}

/// All measures of a group, in tables that pages have room for.
PageData texture_tables(const ReportRun& run, const TexturePlaces& places)
{
    PageData tables{PageData::type::list};
    const std::size_t count = (places.size() + textures_in_a_table - 1) / textures_in_a_table;
    for (std::size_t part = 0; part < count; ++part)
        tables << texture_table(run,
                                {places.begin() + static_cast<std::ptrdiff_t>(part * places.size() / count),
                                 places.begin() + static_cast<std::ptrdiff_t>((part + 1) * places.size() / count)});
    return tables;
}

std::string group_title(const ReportRun& run, const TexturePlaces& places)
{
    const std::string exemplar = run.distributions[places.front()].stored->parameter("exemplar");
    return fmt::format("Textures of {}", exemplar.empty() ? "the same exemplar" : exemplar);
}

}

void set_textures(PageData& page, const ReportRun& run, const std::filesystem::path& page_folder)
{
    PageData groups{PageData::type::list}, notes{PageData::type::list};
    bool has_tables = false;
    for (const TexturePlaces& places : textures_by_exemplar(run)) {
        const bool has_table = places.size() > 1;
        has_tables = has_tables || has_table;
        PageData group, textures{PageData::type::list};
        for (const std::size_t place : places)
            textures << distribution_section(run.distributions[place], texture_anchor(place), page_folder,
                                             has_table ? PageNumbers::elsewhere : PageNumbers::shown);
        group.set("title", group_title(run, places));
        group.set("has_tables", has_table);
        group.set("tilings", has_table ? texture_tilings(run, places, page_folder) : PageData(false));
        group.set("tables", has_table ? texture_tables(run, places) : PageData(false));
        group.set("ranking", texture_ranking(run, places, "distribution-"));
        group.set("textures", textures);
        groups << group;
    }
    for (const Measure& measure : texture_measures()) notes << texture_note(measure);
    page.set("texture_groups", groups);
    page.set("has_textures", groups.is_non_empty_list());
    page.set("has_texture_tables", has_tables);
    page.set("texture_notes", notes);
}

}
