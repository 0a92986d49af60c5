// The ranking of all series: a table that sorts, and what its columns mean.
#include "reports/pages/page_parts.hpp"
#include "reports/pages/ranking_columns.hpp"
#include "reports/pages/relative_link.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {

namespace {

/// From so many series on the table scrolls in a frame of its own, under its headings.
constexpr std::size_t long_ranking = 24;

struct BetterWords
{
    const char* name;
    const char* arrow;
};

BetterWords words_of(Better better)
{
    return better == Better::higher  ? BetterWords{"higher", "↑ higher is better"}
           : better == Better::lower ? BetterWords{"lower", "↓ lower is better"}
                                     : BetterWords{"neither", ""};
}

// The members of "machine" that make times comparable, in one text; empty for runs that needed no device, which do not
// say where they were.
std::string machine_of(const Run& run)
{
    std::string text = run.machine_member("device");
    if (text.empty()) return text;
    for (const char* name : {"driver", "threads"})
        if (const auto value = run.machine_member(name); !value.empty())
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value);
    return text;
}

// What tells runs that have series apart, where it does: the different texts, in order of appearance; empty ones do
// not.
class Differences
{
public:
    template <class TextOf>
    Differences(const Site& site, const TextOf& text_of)
    {
        for (const auto& run : site.runs) {
            if (run.series.empty()) continue;
            const auto text = text_of(*run.stored);
            if (!text.empty() && std::ranges::find(texts_, text) == texts_.end()) texts_.push_back(text);
        }
    }

    bool any() const { return texts_.size() > 1; }
    const std::vector<std::string>& texts() const { return texts_; }

    // "A" for the first text, "B" for the second; 27 and more: numbers.
    std::string letter(const std::string& text) const
    {
        if (!any() || text.empty()) return {};
        const auto index = std::ranges::find(texts_, text) - texts_.begin();
        return index < 26 ? std::string(1, static_cast<char>('A' + index)) : std::to_string(index + 1);
    }

private:
    std::vector<std::string> texts_;
};

std::string version_of(const Run& run) { return run.version; }

struct Provenances
{
    Differences machines;
    Differences versions;
};

PageData column_data(const std::string& key, const std::string& title, const std::string& unit, Better better,
                     bool is_text)
{
    PageData data;
    data.set("key", key);
    data.set("title", title);
    data.set("unit", optional_text(unit));
    data.set("better", words_of(better).name);
    data.set("arrow", is_text ? std::string() : words_of(better).arrow);
    data.set("is_text", is_text);
    return data;
}

PageData text_cell(const std::string& key, const std::string& text, const std::string& link = {})
{
    PageData data;
    data.set("key", key);
    data.set("is_text", true);
    data.set("exact", false);
    data.set("shown", optional_text(text));
    data.set("text_link", optional_text(link));
    data.set("error", false);
    data.set("machine", false);
    return data;
}

PageData number_cell(const RankingColumn& column, const ReportSeries& series, const std::string& machine)
{
    const auto cell = column.cell(series).value_or(RankingCell{});
    PageData data;
    data.set("key", column.key);
    data.set("is_text", false);
    data.set("shown", optional_text(cell.shown));
    data.set("exact", optional_text(cell.shown.empty() ? "" : format_exact(cell.value)));
    data.set("error", optional_text(cell.spread));
    data.set("machine", optional_text(column.is_time && !cell.shown.empty() ? machine : ""));
    return data;
}

PageData columns_data(const Site& site, const std::vector<const RankingColumn*>& columns, const Provenances& from)
{
    PageData list{PageData::type::list};
    list << column_data("series", "Series", "", Better::neither, true);
    if (site.has_several_runs()) list << column_data("run", "Run", "", Better::neither, true);
    for (const auto* column : columns)
        list << column_data(column->key, column->title, column->unit, column->better, false);
    if (from.machines.any()) list << column_data("device", "Machine", "", Better::neither, true);
    if (from.versions.any()) list << column_data("version", "Version", "", Better::neither, true);
    return list;
}

PageData row_data(const Site& site, const ReportRun& run, std::size_t index,
                  const std::vector<const RankingColumn*>& columns, const Provenances& from)
{
    const ReportSeries& series = run.series[index];
    auto row = series_identity(series, index);
    row.set("link", relative_link(site.out, page_of(series)));
    PageData cells{PageData::type::list};
    if (site.has_several_runs()) cells << text_cell("run", run.stored->title, relative_link(site.out, page_of(run)));
    const auto machine = machine_of(*run.stored);
    for (const auto* column : columns) cells << number_cell(*column, series, from.machines.letter(machine));
    if (from.machines.any())
        cells << text_cell("device", machine.empty() ? "" : from.machines.letter(machine) + ": " + machine);
    if (from.versions.any()) cells << text_cell("version", run.stored->version);
    row.set("cells", cells);
    return row;
}

PageData notices(const Provenances& from)
{
    PageData list{PageData::type::list};
    if (from.machines.any()) {
        std::string text = "These runs were made on different machines: times of one do not compare with times of "
                           "another, and have the machine's letter.";
        for (const auto& machine : from.machines.texts())
            text += fmt::format(" {}: {}.", from.machines.letter(machine), machine);
        list << PageData(text);
    }
    if (from.versions.any())
        list << PageData("These runs were made by different versions of the program: " +
                         fmt::format("{}.", fmt::join(from.versions.texts(), "; ")));
    return list;
}

PageData notes(const std::vector<const RankingColumn*>& columns)
{
    PageData list{PageData::type::list};
    for (const auto* column : columns) {
        if (column->meaning.empty()) continue;
        PageData note;
        note.set("name", column->title);
        note.set("text", column->meaning);
        list << note;
    }
    return list;
}

}

void set_ranking(PageData& page, const Site& site)
{
    const auto series = site.series();
    page.set("ranking", !series.empty());
    const auto columns = columns_of(series);
    const Provenances from{Differences(site, machine_of), Differences(site, version_of)};
    PageData rows{PageData::type::list};
    for (const auto& run : site.runs)
        for (std::size_t i = 0; i < run.series.size(); ++i) rows << row_data(site, run, i, columns, from);
    page.set("columns", columns_data(site, columns, from));
    page.set("rows", rows);
    page.set("is_long", series.size() > long_ranking);
    page.set("notices", notices(from));
    page.set("notes", notes(columns));
}

}
