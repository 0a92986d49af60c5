#include "reports/diff/comparison_page.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "reports/diff/comparison_text.hpp"
#include "reports/layout/site.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/plots/gnuplot_text.hpp"
#include "results/own_files.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

std::pair<bool, std::string> compare_runs(const std::filesystem::path& before, const std::filesystem::path& after,
                                          const std::filesystem::path& out, const std::string& format)
{
    const auto comparison = compare_results(before, after);
    if (!out.empty()) write_comparison_page(comparison, before, after, out);
    return {comparison.changed(),
            format == "json" ? comparison_json(comparison) : comparison_table(comparison, format == "all")};
}

namespace fs = std::filesystem;

namespace {

constexpr auto radial_quantity = "radially averaged power";
constexpr auto diff_page = "diff.html";

std::string verdict_class(const NumberComparison& number)
{
    const auto words = verdict_words(number);
    return words == "better" ? "agrees" : words == "worse" ? "disagrees" : words == "changed" ? "partly" : "unjudged";
}

PageData row(const ComparedLine& line)
{
    const auto texts = number_texts(*line.number);
    PageData data;
    data.set("class", verdict_class(*line.number));
    data.set("verdict", verdict_words(*line.number));
    data.set("series", line.series->name());
    data.set("quantity", line.number->quantity);
    data.set("unit", optional_text(line.number->unit));
    data.set("before", texts.before);
    data.set("after", texts.after);
    data.set("reason", reason_words(*line.number));
    return data;
}

PageData rows(const std::vector<ComparedLine>& lines)
{
    PageData list{PageData::type::list};
    for (const auto& line : lines) list << row(line);
    return list;
}

PageData texts(const std::vector<std::string>& values)
{
    PageData list{PageData::type::list};
    for (const auto& value : values) list << PageData(value);
    return list;
}

/// The series whose radial curve changed.
std::vector<const SeriesComparison*> changed_curves(const RunComparison& comparison)
{
    std::vector<const SeriesComparison*> found;
    for (const auto& series : comparison.series)
        if (std::ranges::any_of(series.numbers, [](const NumberComparison& number) {
                return number.quantity == radial_quantity && number.verdict == Verdict::changed;
            }))
            found.push_back(&series);
    return found;
}

std::string plot_stem(std::size_t index) { return fmt::format("diff-radial-{:03}", index); }

/// Old over new, of each series whose radial curve changed.
void draw_curves(const std::vector<const SeriesComparison*>& changed, const fs::path& out)
{
    std::vector<GnuplotPicture> pictures;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        ReportSeries before, after;
        before.run = changed[i]->run_before;
        before.stored = changed[i]->before;
        after.run = changed[i]->run_after;
        after.stored = changed[i]->after;
        for (ReportSeries* series : {&before, &after}) series->curve = read_curve(*series->run, *series->stored);
        const auto both = with_points_in_names({{&before, "old"}, {&after, "new"}});
        const auto plot = power_plot(frequency_curves(both), common_unit(both));
        pictures.push_back(gnuplot_picture(together(plot), out / plot_stem(i)));
    }
    if (!pictures.empty()) draw_with_gnuplot(pictures, PrintPictures::drawn);
}

PageData plots(const std::vector<const SeriesComparison*>& changed)
{
    PageData list{PageData::type::list};
    for (std::size_t i = 0; i < changed.size(); ++i) {
        PageData plot;
        plot.set("source", plot_stem(i) + ".svg");
        plot.set("png", plot_stem(i) + ".png");
        plot.set("series", changed[i]->name());
        list << plot;
    }
    return list;
}

std::string title_of(const RunComparison& comparison)
{
    return comparison.changed() ? "What changed" : "Nothing changed";
}

}

void write_comparison_page(const RunComparison& comparison, const fs::path& before, const fs::path& after,
                           const fs::path& out)
{
    check_own_page(out / diff_page);
    try {
        fs::create_directories(out / asset_folder);
    } catch (const fs::filesystem_error& error) {
        throw StorageError(error.what());
    }
    const auto changed = changed_curves(comparison);
    draw_curves(changed, out);

    const auto lines = sorted_lines(comparison, true);
    const auto first_unchanged =
        std::ranges::find_if(lines, [](const auto& line) { return line.number->verdict != Verdict::changed; });
    PageData page;
    page.set("title", title_of(comparison));
    page.set("before", before.string());
    page.set("after", after.string());
    page.set("summary", comparison_summary(comparison));
    page.set("remarks", texts(comparison.remarks));
    page.set("has_remarks", !comparison.remarks.empty());
    page.set("missing", texts(comparison.missing));
    page.set("added", texts(comparison.added));
    page.set("has_changes", first_unchanged != lines.begin());
    page.set("changes", rows({lines.begin(), first_unchanged}));
    page.set("others", rows({first_unchanged, lines.end()}));
    page.set("plots", plots(changed));
    page.set("has_plots", !changed.empty());
    const Site site{out, title_of(comparison), {}, {}, {{diff_page, "Difference"}}};
    write_assets(site);
    write_whole_file(out / diff_page, render_in_frame(site, {out / diff_page, title_of(comparison), {}}, "diff", page));
}

}
