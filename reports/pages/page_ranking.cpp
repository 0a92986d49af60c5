// The ranking of all series: a table that sorts, and what its columns mean.
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"
#include "reports/words/measure_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {

namespace {

/// The number of series from which on the table scrolls in a frame of its own, under its headings.
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

/// The members of "machine" that make times comparable, in one text; empty for runs that needed no device, which do not
/// say where they were.
std::string machine_of(const Run& run)
{
    std::string text = run.machine.text("device");
    if (text.empty()) return text;
    for (const char* name : {"driver", "threads"})
        if (const auto value = run.machine.text(name); !value.empty())
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value);
    return text;
}

/// The texts that tell runs that have series apart: the different texts, in order of appearance; empty ones do
/// not.
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
                     bool is_text, bool is_detail = false)
{
    PageData data;
    data.set("key", key);
    data.set("title", title);
    data.set("unit", optional_text(unit));
    data.set("better", words_of(better).name);
    data.set("arrow", is_text ? std::string() : words_of(better).arrow);
    data.set("is_text", is_text);
    data.set("is_detail", is_detail);
    return data;
}

PageData text_cell(const std::string& key, const std::string& text, const std::string& link = {})
{
    PageData data;
    data.set("key", key);
    data.set("is_text", true);
    data.set("is_detail", false);
    data.set("exact", false);
    data.set("shown", optional_text(text));
    data.set("text_link", optional_text(link));
    data.set("error", false);
    data.set("machine", false);
    return data;
}

PageData number_cell(const Measure& measure, const ReportSeries& series, const std::string& machine)
{
    const auto value = measure.get(*series.stored);
    const MeasureWords words = value ? words_of(measure, *value) : MeasureWords{};
    PageData data;
    data.set("key", measure.key);
    data.set("is_text", false);
    data.set("is_detail", measure.is_detail);
    data.set("shown", optional_text(words.shown));
    data.set("exact", optional_text(value ? format_exact(value->value) : ""));
    data.set("error", optional_text(words.spread));
    data.set("machine", optional_text(value && measure.kind == MeasureKind::time ? machine : ""));
    return data;
}

/// The measures that at least one of the series has.
std::vector<const Measure*> columns_of(const std::vector<const ReportSeries*>& series)
{
    std::vector<const Measure*> columns;
    for (const Measure& measure : measures())
        if (std::ranges::any_of(series, [&](const auto* entry) { return measure.get(*entry->stored).has_value(); }))
            columns.push_back(&measure);
    return columns;
}

PageData columns_data(const Site& site, const std::vector<const Measure*>& columns, const Provenances& from)
{
    PageData list{PageData::type::list};
    list << column_data("series", "Series", "", Better::neither, true);
    if (site.has_several_runs()) list << column_data("run", "Run", "", Better::neither, true);
    for (const auto* column : columns)
        list << column_data(column->key, in_dimension(column->title()), in_dimension(column->unit), column->better,
                            false, column->is_detail);
    if (from.machines.any()) list << column_data("device", "Machine", "", Better::neither, true);
    if (from.versions.any()) list << column_data("version", "Version", "", Better::neither, true);
    return list;
}

PageData row_data(const Site& site, const ReportRun& run, std::size_t index, const std::vector<const Measure*>& columns,
                  const Provenances& from)
{
    const ReportSeries& series = run.series[index];
    auto row = series_identity(series, index);
    row.set("link", relative_link(site.out, page_of(series)));
    row.set("run", run.stored->title);
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

/// The meaning of columns; neighbours with one meaning share a note.
PageData notes(const std::vector<const Measure*>& columns)
{
    PageData list{PageData::type::list};
    for (std::size_t i = 0; i < columns.size();) {
        const std::string& meaning = columns[i]->meaning;
        std::string names = in_dimension(columns[i]->title());
        bool is_detail = columns[i]->is_detail;
        for (++i; i < columns.size() && columns[i]->meaning == meaning; ++i) {
            names += "; " + in_dimension(columns[i]->title());
            is_detail = is_detail && columns[i]->is_detail;
        }
        if (meaning.empty()) continue;
        PageData note;
        note.set("name", names);
        note.set("is_detail", is_detail);
        note.set("text", in_dimension(meaning));
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
    page.set("has_details", std::ranges::any_of(columns, &Measure::is_detail));
    page.set("is_long", series.size() > long_ranking);
    page.set("series_count", format_count(series.size()));
    page.set("notices", notices(from));
    page.set("notes", notes(columns));
}

}
