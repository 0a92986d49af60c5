// The ranking of all series: a table that sorts, and what its columns mean.
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/ranking_order.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace poissonlab {

namespace {

/// The number of series from which on the table scrolls in a frame of its own, under its headings.
constexpr std::size_t long_ranking = 24;

/// The measure by which rows come first.
constexpr std::string_view sorted_by = "relative_radius";

struct BetterWords
{
    const char* name;
    const char* arrow;
};

BetterWords words_of(Better better)
{
    return better == Better::higher  ? BetterWords{"higher", "↑ higher: better"}
           : better == Better::lower ? BetterWords{"lower", "↓ lower: better"}
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

/// A cell or a heading belongs to a column of text, to one that is shown when all measures are asked for, or has the
/// best value.
std::string classes_of(bool is_text, bool is_detail, bool is_best = false)
{
    std::vector<std::string> classes;
    if (is_text) classes.emplace_back("text");
    if (is_detail) classes.emplace_back("detail");
    if (is_best) classes.emplace_back("best");
    return fmt::format("{}", fmt::join(classes, " "));
}

PageData text_column(const std::string& key, const std::string& title)
{
    PageData data;
    data.set("key", key);
    data.set("title", title);
    data.set("unit", false);
    data.set("better", "neither");
    data.set("arrow", false);
    data.set("sorting", "none");
    data.set("classes", optional_text(classes_of(true, false)));
    return data;
}

PageData text_cell(const std::string& key, const std::string& text, const std::string& link = {})
{
    PageData data;
    data.set("key", key);
    data.set("classes", optional_text(classes_of(true, false)));
    data.set("exact", false);
    data.set("shown", optional_text(text));
    data.set("text_link", optional_text(link));
    data.set("error", false);
    data.set("machine", false);
    return data;
}

/// A measure of the ranking.
struct RankingColumn
{
    const Measure* measure = nullptr;
    const ChoiceColumn* choice = nullptr; ///< null: of no choice
    bool is_detail = false;
    std::array<const ReportSeries*, 2> best{}; ///< in 2D and 3D; null: none is marked

    bool marks(const ReportSeries& series) const
    {
        const ReportSeries* best_one = best[series.run->dimension == 3 ? 1 : 0];
        return best_one && is_ranked(series) && is_as_good(*measure, series, *best_one);
    }
};

/// The measures that at least one of the series has. Sizes and numbers of sets are shown where they differ.
std::vector<RankingColumn> columns_of(const std::vector<const ReportSeries*>& series)
{
    std::vector<RankingColumn> columns;
    for (const Measure& measure : measures()) {
        std::vector<double> values;
        for (const ReportSeries* entry : series)
            if (const auto value = measure.get(*entry->stored)) values.push_back(value->value);
        if (values.empty()) continue;
        const bool is_size = measure.key == "points" || measure.key == "realizations";
        const bool differs = std::ranges::any_of(values, [&](double value) { return value != values.front(); });
        const ChoiceColumn* choice = choice_column(measure.key);
        columns.push_back({&measure,
                           choice,
                           is_size ? !differs : choice == nullptr,
                           {best_to_mark(measure, series, 2), best_to_mark(measure, series, 3)}});
    }
    return columns;
}

PageData number_cell(const RankingColumn& column, const ReportSeries& series, const std::string& machine)
{
    const Measure& measure = *column.measure;
    const auto value = measure.get(*series.stored);
    const MeasureWords words = value ? words_of(measure, *value) : MeasureWords{};
    PageData data;
    data.set("key", measure.key);
    data.set("classes", optional_text(classes_of(false, column.is_detail, column.marks(series))));
    data.set("shown", optional_text(words.shown));
    data.set("exact", optional_text(value ? format_exact(value->value) : ""));
    data.set("error", optional_text(words.spread));
    data.set("machine", optional_text(value && measure.kind == MeasureKind::time ? machine : ""));
    return data;
}

/// The dimension of all series; 0 where they differ.
int only_dimension(const Site& site)
{
    const auto all = site.series();
    const auto differs = [&](const ReportSeries* series) {
        return series->run->dimension != all.front()->run->dimension;
    };
    return all.empty() || std::ranges::any_of(all, differs) ? 0 : all.front()->run->dimension;
}

PageData number_column(const RankingColumn& column, int dimension)
{
    const Measure& measure = *column.measure;
    PageData data;
    data.set("key", measure.key);
    data.set("title", column.choice ? std::string(column.choice->heading) : in_dimension(measure.title(), dimension));
    data.set("unit", optional_text(in_dimension(column.choice ? column.choice->unit : measure.unit, dimension)));
    data.set("better", words_of(measure.better).name);
    data.set("arrow", optional_text(words_of(measure.better).arrow));
    data.set("sorting", measure.key == sorted_by ? "descending" : "none");
    data.set("classes", optional_text(classes_of(false, column.is_detail)));
    return data;
}

PageData columns_data(const Site& site, const std::vector<RankingColumn>& columns, const Provenances& from)
{
    PageData list{PageData::type::list};
    list << text_column("series", "Series");
    if (site.has_several_runs()) list << text_column("run", "Run");
    for (const RankingColumn& column : columns) list << number_column(column, only_dimension(site));
    if (from.machines.any()) list << text_column("device", "Machine");
    if (from.versions.any()) list << text_column("version", "Version");
    return list;
}

/// The reason why a series stands behind the others.
std::string remark_of(const ReportSeries& series)
{
    if (follows_density(series)) return "follows a density: not ranked";
    if (is_not_periodic(series)) return "not periodic: not ranked";
    return {};
}

/// `index` is the number of the series among all of the site, whose colour it has on the compare page.
PageData row_data(const Site& site, const ReportRun& run, const ReportSeries& series, std::size_t index,
                  const std::vector<RankingColumn>& columns, const Provenances& from)
{
    auto row = series_identity(series, index);
    row.set("link", relative_link(site.out, page_of(series)));
    row.set("run", run.stored->title);
    row.set("remark", optional_text(remark_of(series)));
    PageData cells{PageData::type::list};
    if (site.has_several_runs()) cells << text_cell("run", run.stored->title, relative_link(site.out, page_of(run)));
    const auto machine = machine_of(*run.stored);
    for (const RankingColumn& column : columns) cells << number_cell(column, series, from.machines.letter(machine));
    if (from.machines.any())
        cells << text_cell("device", machine.empty() ? "" : from.machines.letter(machine) + ": " + machine);
    if (from.versions.any()) cells << text_cell("version", run.stored->version);
    row.set("cells", cells);
    return row;
}

/// The lines above the table, one a dimension: which series is best for what.
PageData best_lines(const Site& site)
{
    const auto all = site.series();
    PageData lines{PageData::type::list};
    const bool has_both =
        std::ranges::any_of(all, [&](const auto* s) { return s->run->dimension != all.front()->run->dimension; });
    for (const int dimension : {2, 3}) {
        const std::vector<BestFor> best = best_series(all, dimension);
        if (best.empty()) continue;
        PageData line, wishes{PageData::type::list};
        line.set("where", has_both ? fmt::format("Best in {}D", dimension) : std::string("Best"));
        for (const BestFor& wish : best) {
            PageData item;
            item.set("what", wish.what);
            item.set("label", wish.series->full_label);
            item.set("link", relative_link(site.out, page_of(*wish.series)));
            item.set("value", wish.value);
            item.set("is_last", &wish == &best.back());
            wishes << item;
        }
        line.set("wishes", wishes);
        line.set("blue_noise", optional_text(blue_noise_words(all, dimension)));
        const std::string hidden = hidden_best_words(all, dimension);
        line.set("directions", optional_text(directions_words(all, dimension) + (hidden.empty() ? "" : " " + hidden)));
        lines << line;
    }
    return lines;
}

PageData notices(const Site& site, const Provenances& from)
{
    PageData list{PageData::type::list};
    for (const ReportSeries* series : site.series())
        if (const std::string border = border_notice(*series); !border.empty())
            list << PageData(fmt::format("{}: {}", series->full_label, border));
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
PageData notes(const std::vector<RankingColumn>& columns, int dimension)
{
    PageData list{PageData::type::list};
    for (std::size_t i = 0; i < columns.size();) {
        const std::string& meaning = columns[i].measure->meaning;
        std::string names = in_dimension(columns[i].measure->title(), dimension);
        bool is_detail = columns[i].is_detail;
        for (++i; i < columns.size() && columns[i].measure->meaning == meaning; ++i) {
            names += "; " + in_dimension(columns[i].measure->title(), dimension);
            is_detail = is_detail && columns[i].is_detail;
        }
        if (meaning.empty()) continue;
        PageData note;
        note.set("name", names);
        note.set("is_detail", is_detail);
        note.set("text", in_dimension(meaning, dimension));
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
    for (const ReportSeries* entry : ranking_order(series)) {
        const auto is_of = [&](const ReportRun& run) { return run.stored == entry->run; };
        const auto index = static_cast<std::size_t>(std::ranges::find(series, entry) - series.begin());
        rows << row_data(site, *std::ranges::find_if(site.runs, is_of), *entry, index, columns, from);
    }
    page.set("best_lines", best_lines(site));
    page.set("columns", columns_data(site, columns, from));
    page.set("rows", rows);
    page.set("has_details", std::ranges::any_of(columns, &RankingColumn::is_detail));
    page.set("is_long", series.size() > long_ranking);
    page.set("series_count", format_count(series.size()));
    page.set("notices", notices(site, from));
    page.set("notes", notes(columns, only_dimension(site)));
}

}
