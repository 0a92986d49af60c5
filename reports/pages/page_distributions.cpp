// The page's sections on points and objects that follow densities, and on schemes of tilings.
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace poissonlab {

namespace {

constexpr int distribution_digits = 4;

/// Distributions that have one picture each make one figure if there are at least this many.
constexpr std::size_t least_in_figure = 3;

/// Small pictures that link to the sections come first if at least this many distributions have one.
constexpr std::size_t least_with_overview = 4;

PageData picture_data(const ReportDistribution& distribution, const DistributionPicture& picture,
                      const std::string& anchor, const std::filesystem::path& page_folder)
{
    PageData data;
    const std::filesystem::path png = png_of(distribution, picture);
    const bool is_light = shows_tones(distribution);
    data.set("source", relative_link(page_folder, is_light ? light_copy_of(distribution, picture) : png));
    data.set("png", relative_link(page_folder, png));
    data.set("style", is_light ? fmt::format(" style=\"filter: url(#{}-light)\"", anchor) : "");
    data.set("caption", picture.caption);
    data.set("alt", fmt::format("{}. {}", distribution.stored->label, picture.caption));
    return data;
}

PageData curve_data(const ReportDistribution& distribution, const Panel& panel,
                    const std::filesystem::path& page_folder)
{
    PageData data;
    const std::string svg = relative_link(page_folder, distribution.pictures / shown_file(panel));
    data.set("source", svg);
    data.set("title", panel.title);
    data.set("caption", panel.caption);
    data.set("how_to_read", optional_text(panel.guide));
    data.set("alt", fmt::format("{}: {}. {}", distribution.stored->label, panel.title, panel.caption));
    return data;
}

/// Counts have all of their digits.
std::string number_words(double value)
{
    constexpr double most_counted = 1e15;
    const bool is_count = value >= 0 && value < most_counted && value == std::floor(value);
    return is_count ? format_count(static_cast<std::uint64_t>(value)) : format_significant(value, distribution_digits);
}

PageData number_data(const DistributionNumber& number)
{
    PageData data;
    data.set("name", number.title);
    const RoundedEstimate estimate = format_estimate(number.value, number.standard_error, distribution_digits);
    data.set("value", estimate.error.empty() ? number_words(number.value) : estimate.text());
    data.set("meaning", number.meaning);
    return data;
}

PageData table_data(const DistributionTable& table)
{
    PageData data, columns{PageData::type::list}, rows{PageData::type::list};
    for (const std::string& column : table.columns) columns << PageData(column);
    for (const std::vector<std::string>& row : table.rows) {
        PageData cells{PageData::type::list}, line;
        for (const std::string& cell : row) cells << PageData(cell);
        line.set("cells", cells);
        rows << line;
    }
    data.set("title", table.title);
    data.set("columns", columns);
    data.set("rows", rows);
    return data;
}

/// The class of a grid of so many pictures: no row has a lone picture, and a single one has the whole width.
const char* grid_of_pictures(std::size_t count)
{
    if (count == 1) return "alone";
    if (count == 2) return "two";
    return count % 3 == 1 ? "four" : "three";
}

PageData file_data(const ReportDistribution& distribution, const std::string& file,
                   const std::filesystem::path& page_folder)
{
    PageData data;
    data.set("words", std::filesystem::path(file).filename().string());
    data.set("link", relative_link(page_folder, distribution.run->folder / file));
    return data;
}

}

PageData distribution_section(const ReportDistribution& distribution, const std::string& anchor,
                              const std::filesystem::path& page_folder, PageNumbers shown)
{
    const DistributionResult& stored = *distribution.stored;
    PageData data, facts{PageData::type::list}, numbers{PageData::type::list}, pictures{PageData::type::list},
        files{PageData::type::list};
    for (const std::string& fact : stored.facts) facts << PageData(fact);
    for (const DistributionNumber& number : stored.numbers)
        if (shown == PageNumbers::shown && !number.is_in_table) numbers << number_data(number);
    std::size_t shown_pictures = 0;
    for (const DistributionPicture& picture : stored.pictures) {
        if (picture.file.ends_with(".json")) files << file_data(distribution, picture.file, page_folder);
        if (picture.has_curves()) continue;
        ++shown_pictures;
        pictures << picture_data(distribution, picture, anchor, page_folder);
    }
    for (const std::string& file : stored.files) files << file_data(distribution, file, page_folder);
    data.set("label", stored.label);
    data.set("anchor", anchor);
    data.set("facts", facts);
    data.set("numbers", numbers);
    data.set("has_numbers", numbers.is_non_empty_list());
    data.set("pictures", pictures);
    data.set("has_pictures", shown_pictures > 0);
    data.set("shows_tones", shows_tones(distribution));
    data.set("grid", grid_of_pictures(shown_pictures));
    PageData curves{PageData::type::list};
    for (const Panel& panel : distribution.curves) curves << curve_data(distribution, panel, page_folder);
    data.set("curves", curves);
    data.set("has_curves", !distribution.curves.empty());
    PageData tables{PageData::type::list};
    for (const DistributionTable& table : stored.tables) tables << table_data(table);
    data.set("tables", tables);
    data.set("files", files);
    data.set("has_files", files.is_non_empty_list());
    return data;
}

namespace {

struct PlacedDistribution
{
    const ReportDistribution* distribution = nullptr;
    std::string anchor;
};
using PlacedDistributions = std::vector<PlacedDistribution>;

/// True if a picture, its facts and numbers are all that a page shows. Tones need a filter of their own.
bool has_one_picture(const PlacedDistribution& placed)
{
    const ReportDistribution& its = *placed.distribution;
    return its.stored->pictures.size() == 1 && its.curves.empty() && its.stored->tables.empty() && !shows_tones(its);
}

/// One table of the numbers of several distributions: a row each, and a column for each number that one of them has.
void set_number_table(PageData& data, const PlacedDistributions& shown)
{
    std::vector<DistributionNumber> columns;
    for (const auto& [distribution, anchor] : shown)
        for (const DistributionNumber& number : distribution->stored->numbers)
            if (std::ranges::find(columns, number.title, &DistributionNumber::title) == columns.end())
                columns.push_back(number);
    PageData heads{PageData::type::list}, rows{PageData::type::list};
    for (const DistributionNumber& column : columns) heads << number_data(column);
    for (const auto& [distribution, anchor] : shown) {
        PageData row, cells{PageData::type::list};
        for (const DistributionNumber& column : columns) {
            const auto& numbers = distribution->stored->numbers;
            const auto found = std::ranges::find(numbers, column.title, &DistributionNumber::title);
            PageData cell;
            cell.set("value", found == numbers.end() ? PageData("–") : *number_data(*found).get("value"));
            cells << cell;
        }
        row.set("label", distribution->stored->label);
        row.set("anchor", anchor);
        row.set("cells", cells);
        rows << row;
    }
    data.set("heads", heads);
    data.set("rows", rows);
    data.set("has_rows", !columns.empty());
}

/// Small pictures that link to the sections of distributions.
PageData overview_data(const PlacedDistributions& shown, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (const auto& [distribution, anchor] : shown) {
        const auto& pictures = distribution->stored->pictures;
        const auto picture = std::ranges::find_if(pictures, [](const auto& its) { return !its.has_curves(); });
        if (picture == pictures.end()) continue;
        PageData card;
        card.set("label", distribution->stored->label);
        card.set("anchor", anchor);
        card.set("source", relative_link(page_folder, png_of(*distribution, *picture)));
        list << card;
    }
    return list;
}

/// The distributions that `is_shown` takes, whose anchors are their places in the whole list.
void set_group(PageData& page, const std::string& name, const std::vector<ReportDistribution>& distributions,
               const std::string& anchor, bool (*is_shown)(const ReportDistribution&),
               const std::filesystem::path& page_folder)
{
    PlacedDistributions placed;
    for (std::size_t i = 0; i < distributions.size(); ++i)
        if (is_shown(distributions[i])) placed.push_back({&distributions[i], fmt::format("{}-{}", anchor, i + 1)});
    const bool has_figure = static_cast<std::size_t>(std::ranges::count_if(placed, has_one_picture)) >= least_in_figure;
    PlacedDistributions in_figure, large;
    for (const PlacedDistribution& one : placed)
        (has_figure && has_one_picture(one) ? in_figure : large).push_back(one);
    PageData group, figure{PageData::type::list}, sections{PageData::type::list};
    for (const PlacedDistribution& one : in_figure)
        figure << distribution_section(*one.distribution, one.anchor, page_folder, PageNumbers::elsewhere);
    for (const PlacedDistribution& one : large)
        sections << distribution_section(*one.distribution, one.anchor, page_folder);
    group.set("has_figure", has_figure);
    group.set("figure", figure);
    group.set("figure_grid", grid_of_pictures(in_figure.size()));
    set_number_table(group, in_figure);
    group.set("has_overview", large.size() >= least_with_overview);
    group.set("overview", overview_data(large, page_folder));
    group.set("sections", sections);
    page.set(name, group);
    page.set("has_" + name, !placed.empty());
}

}

void set_distributions(PageData& page, const ReportRun& run, const std::filesystem::path& page_folder)
{
    const auto is_any = [](const ReportDistribution& /*scheme*/) { return true; };
    set_group(page, "packings", run.distributions, "distribution", is_of_packings, page_folder);
    set_group(page, "distributions", run.distributions, "distribution", is_of_densities, page_folder);
    set_group(page, "schemes", run.schemes, "scheme", is_any, page_folder);
}

}
