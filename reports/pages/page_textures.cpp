// A run's textures: those of one exemplar beside each other, with a verdict above and the measures below.
#include "reports/layout/distribution_pictures.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"
#include "reports/words/texture_words.hpp"
#include "results/texture_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace poissonlab {
namespace {

/// The verdict uses the first four of these measures.
constexpr std::array shown_measures = {"recurrence", "edge_loss",        "edge_gain",   "novelty", "conspicuous_seams",
                                       "contrast",   "structure_spread", "atlas_bytes", "fetches", "pixel_nanoseconds"};

/// Places of textures in a run's list.
using TexturePlaces = std::vector<std::size_t>;

const Measure& texture_measure(const std::string& key)
{
    return *std::ranges::find(texture_measures(), key, &Measure::key);
}

std::vector<const DistributionResult*> textures_at(const ReportRun& run, const TexturePlaces& places)
{
    std::vector<const DistributionResult*> textures;
    for (const std::size_t place : places) textures.push_back(run.distributions[place].stored);
    return textures;
}

/// Places in the order in which a person should look at their textures.
TexturePlaces judged_places(const ReportRun& run, const TexturePlaces& places)
{
    TexturePlaces judged;
    for (const std::size_t i : judged_order(textures_at(run, places))) judged.push_back(places[i]);
    return judged;
}

std::string texture_anchor(std::size_t place) { return fmt::format("distribution-{}", place + 1); }

PageData number_cell(const Measure& measure, const DistributionResult& texture, bool has_failed)
{
    PageData cell;
    const auto value = texture_value(measure, texture);
    const std::string shown = value ? words_of(measure, *value).shown : std::string();
    cell.set("shown", optional_text(shown));
    cell.set("exact", value ? format_exact(value->value) : "");
    cell.set("failed", has_failed);
    return cell;
}

PageData number_row(const DistributionResult& texture, const std::string& anchor)
{
    PageData row, cells{PageData::type::list};
    row.set("label", label_of_method(texture));
    row.set("anchor", anchor);
    const auto failed = failed_gates(texture);
    for (const char* key : shown_measures)
        cells << number_cell(texture_measure(key), texture,
                             std::ranges::any_of(failed, [&](const auto* gate) { return gate->key == key; }));
    row.set("cells", cells);
    return row;
}

/// The limit of a measure that has a gate, in words.
std::string limit_words(std::string_view key)
{
    const auto gate = std::ranges::find(texture_gates(), key, &TextureGate::key);
    if (gate == texture_gates().end()) return "";
    return fmt::format("at most {}", gate->limit);
}

/// The numbers behind the sentences: a row a texture.
PageData texture_numbers(const ReportRun& run, const TexturePlaces& places)
{
    PageData data, heads{PageData::type::list}, rows{PageData::type::list};
    for (const char* key : shown_measures) {
        PageData head;
        head.set("name", texture_measure(key).name);
        head.set("unit", texture_measure(key).unit);
        head.set("limit", optional_text(limit_words(key)));
        heads << head;
    }
    for (const std::size_t place : places) rows << number_row(*run.distributions[place].stored, texture_anchor(place));
    data.set("heads", heads);
    data.set("rows", rows);
    return data;
}

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

/// A card shows a tiling of a texture, a view to the horizon, and a sentence.
PageData texture_card(const ReportDistribution& texture, const std::string& anchor,
                      const std::filesystem::path& page_folder)
{
    PageData card, faults{PageData::type::list};
    const std::string label = label_of_method(*texture.stored);
    const auto set_picture = [&](const std::string& name, const std::string& file) {
        const auto* const picture = texture_picture(texture, file);
        card.set(name, picture ? PageData(relative_link(page_folder, png_of(texture, *picture))) : PageData(false));
        card.set(name + "_alt", picture ? fmt::format("{}. {}", label, picture->caption) : "");
    };
    set_picture("near", "tiling.png");
    set_picture("far", "plane.png");
    for (const TextureGate* gate : failed_gates(*texture.stored)) faults << PageData(std::string(gate->fault));
    card.set("label", label);
    card.set("anchor", anchor);
    card.set("sentence", optional_text(texture_sentence(*texture.stored)));
    card.set("faults", faults);
    card.set("failed", faults.is_non_empty_list());
    return card;
}

/// The exemplar, and the cards of its textures, to be seen side by side.
PageData texture_cards(const ReportRun& run, const TexturePlaces& places, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (const std::size_t place : places)
        if (const auto* exemplar = texture_picture(run.distributions[place], "exemplar.png")) {
            PageData card;
            card.set("near", relative_link(page_folder, png_of(run.distributions[place], *exemplar)));
            card.set("near_alt", exemplar->caption);
            card.set("far", false);
            card.set("far_alt", false);
            card.set("label", "Exemplar");
            card.set("anchor", false);
            card.set("sentence", "All other textures are made of it.");
            card.set("faults", false);
            card.set("failed", false);
            list << card;
            break;
        }
    for (const std::size_t place : places)
        list << texture_card(run.distributions[place], texture_anchor(place), page_folder);
    return list;
}

/// True if cards do not show all pictures of a texture.
bool has_other_pictures(const DistributionResult& texture)
{
    return std::ranges::any_of(texture.pictures, [](const DistributionPicture& picture) {
        const std::string name = std::filesystem::path(picture.file).filename().string();
        return name != "exemplar.png" && name != "tiling.png" && name != "plane.png";
    });
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
        PageData group, textures{PageData::type::list}, rows{PageData::type::list};
        for (const std::size_t place : places) {
            const PageData section = distribution_section(run.distributions[place], texture_anchor(place), page_folder,
                                                          has_table ? PageNumbers::elsewhere : PageNumbers::shown);
            (has_table && !has_other_pictures(*run.distributions[place].stored) ? rows : textures) << section;
        }
        const TexturePlaces judged = judged_places(run, places);
        group.set("title", group_title(run, places));
        group.set("has_tables", has_table);
        group.set("verdict", has_table ? optional_text(textures_verdict(textures_at(run, judged))) : PageData(false));
        group.set("cards", has_table ? texture_cards(run, judged, page_folder) : PageData(false));
        group.set("numbers", has_table ? texture_numbers(run, judged) : PageData(false));
        group.set("tables", has_table ? texture_tables(run, places) : PageData(false));
        group.set("textures", textures);
        group.set("has_rows", rows.is_non_empty_list());
        group.set("rows", rows);
        groups << group;
    }
    for (const Measure& measure : texture_measures()) notes << texture_note(measure);
    page.set("texture_groups", groups);
    page.set("has_textures", groups.is_non_empty_list());
    page.set("has_texture_tables", has_tables);
    page.set("texture_notes", notes);
}

}
