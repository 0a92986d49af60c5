// The compare page: curves of all series as data for its script, and what works without it.
#include "reports/pages/page.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace poissonlab {

namespace {

using Json = nlohmann::json;

constexpr std::size_t most_shown_at_first = 12;
constexpr const char* gallery_title = "Gallery of reference curves";

/// The number of points in the middle of all: curves of far fewer or more would not lie over the others.
std::size_t typical_points(const std::vector<const ReportSeries*>& series)
{
    std::vector<std::size_t> points;
    for (const ReportSeries* entry : series)
        if (entry->stored->has_spectrum()) points.push_back(entry->stored->points);
    if (points.empty()) return 0;
    const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
    std::ranges::nth_element(points, middle);
    return *middle;
}

/// The numbers of the series that are shown at first: all of a few; of many, the first estimate by each method, of
/// about as many points as most; of many by one method, some from all over the list.
std::set<std::size_t> shown_at_first(const std::vector<const ReportSeries*>& series)
{
    std::set<std::size_t> all, spread, methods;
    std::set<std::string> seen;
    const auto typical = static_cast<double>(typical_points(series));
    for (std::size_t i = 0; i < series.size(); ++i) {
        all.insert(i);
        const auto step = [&](std::size_t number) { return number * most_shown_at_first / series.size(); };
        if (step(i + 1) > step(i)) spread.insert(i);
        const Series& stored = *series[i]->stored;
        const bool is_typical = std::abs(static_cast<double>(stored.points) - typical) < typical / 4;
        const bool is_candidate =
            stored.has_spectrum() && stored.is_estimate && is_typical && methods.size() < most_shown_at_first;
        if (is_candidate && seen.insert(stored.sampler).second) methods.insert(i);
    }
    return all.size() <= most_shown_at_first ? all : methods.size() > 1 ? methods : spread;
}

/// Numbers with five digits, each on its own so that none is written with more; null where there is no number.
std::string short_number(double value) { return std::isfinite(value) ? fmt::format("{:.5g}", value) : "null"; }

std::string short_numbers(const std::vector<double>& values)
{
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ",") + short_number(value);
    return "[" + text + "]";
}

/// Series share their frequencies and distances, mostly: each list is written once.
class Abscissae
{
public:
    std::size_t number_of(const std::string& list)
    {
        const auto [place, added] = numbers_.try_emplace(list, lists_.size());
        if (added) lists_.push_back(list);
        return place->second;
    }
    std::string text() const { return fmt::format("[{}]", fmt::join(lists_, ",")); }

private:
    std::vector<std::string> lists_;
    std::map<std::string, std::size_t> numbers_;
};

/// A plot that the reader chooses, with the curves of all series over unit lengths or cycles per unit length.
struct ChosenPlot
{
    std::string title;
    std::string abscissa; // what the data of series call its horizontal axis
    Plot plot;
};

std::vector<ChosenPlot> chosen_plots(const Site& site)
{
    const auto series = series_of(site);
    auto frequencies = frequency_curves(series);
    for (std::size_t i = 0; i < site.gallery.size(); ++i)
        frequencies.push_back({series.size() + i, site.gallery[i]->label, &site.gallery[i]->curve});
    auto pairs = pair_correlation_curves(series);
    for (auto& curve : pairs) curve.unit = 1;
    std::vector<ChosenPlot> plots = {
        {"Radially averaged power", "frequencies", power_plot(frequencies, LengthUnit::absolute)},
        {"Anisotropy", "frequencies", anisotropy_comparison(frequencies, LengthUnit::absolute)},
        {"Pair correlation", "distances", pair_correlation_plot(pairs, distance_words(LengthUnit::absolute))}};
    std::erase_if(plots, [](const ChosenPlot& chosen) { return chosen.plot.curves.empty(); });
    return plots;
}

/// The looks of plots, whichever curves are in them.
std::string plots_json(const std::vector<ChosenPlot>& plots)
{
    std::vector<std::string> parts;
    for (const auto& [title, abscissa, plot] : plots) {
        const bool has_reference = plot.references.size() == 1;
        parts.push_back(fmt::format("\"{}\":{{\"abscissa\":\"{}\",\"label\":{},\"reference\":{},\"most\":{},"
                                    "\"floor\":{}}}",
                                    plot.key, abscissa, script_text(plot.y.label),
                                    has_reference ? short_number(plot.references.front().height) : "null",
                                    short_number(plot.y.most), short_number(plot.y.floor)));
    }
    return fmt::format("{{{}}}", fmt::join(parts, ","));
}

template <class Words>
std::string axis_json(const Words& words)
{
    return fmt::format(
        R"({{"absolute":{},"spacing":{},"principal":{}}})", script_text(plain_words(words(LengthUnit::absolute))),
        script_text(plain_words(words(LengthUnit::spacing))), script_text(plain_words(words(LengthUnit::principal))));
}

/// `page`: a JSON text; null for methods of the gallery.
std::string curve_json(const std::string& label, std::size_t run, const Curve& curve, const std::string& page)
{
    auto text = fmt::format("\"label\":{},\"run\":{},\"dimension\":{},\"points\":{},\"page\":{}", script_text(label),
                            run, curve.dimension, curve.points, page);
    if (curve.principal_frequency) text += ",\"principal\":" + short_number(*curve.principal_frequency);
    return text;
}

/// The standard errors of a curve, with two digits; nothing where none is known.
std::string errors_json(const std::string& key, const PlotCurve& curve)
{
    std::vector<std::string> errors;
    bool is_known = false;
    for (std::size_t i = 0; i < curve.high.size(); ++i) {
        const double error = curve.high[i] - curve.y[i];
        is_known = is_known || error > 0;
        errors.push_back(std::isfinite(error) ? fmt::format("{:.2g}", error) : "0");
    }
    return is_known ? fmt::format(",\"{}_error\":[{}]", key, fmt::join(errors, ",")) : "";
}

std::string site_json(const Site& site, const std::vector<ChosenPlot>& plots)
{
    Abscissae abscissae;
    std::vector<std::string> series;
    std::vector<std::string> runs;
    for (std::size_t i = 0; i < site.runs.size(); ++i) {
        runs.push_back(script_text(site.runs[i].stored->title));
        for (const auto& entry : site.runs[i].series)
            series.push_back(
                curve_json(entry.label, i, entry.curve, script_text(relative_link(site.out, page_of(entry)))));
    }
    runs.push_back(script_text(gallery_title));
    for (const GalleryMethod* method : site.gallery)
        series.push_back(curve_json(method->label, site.runs.size(), method->curve, "null"));
    for (const auto& chosen : plots)
        for (const auto& curve : chosen.plot.curves)
            series.at(curve.index) +=
                fmt::format(",\"{}\":{},\"{}\":{}", chosen.abscissa, abscissae.number_of(short_numbers(curve.x)),
                            chosen.plot.key, short_numbers(curve.y)) +
                errors_json(chosen.plot.key, curve);
    return fmt::format(
        "{{\"runs\":[{}],\n\"severalRuns\":{},\n\"plots\":{},\n\"axes\":{{\"frequencies\":{},\"distances\":{}}},\n"
        "\"principalUnits\":{},\"colors\":{},\"dashes\":{},\"mostAtFirst\":{},\n"
        "\"series\":[\n{{{}}}],\n\"abscissae\":{}}}",
        fmt::join(runs, ","), site.has_several_runs(), plots_json(plots), axis_json(frequency_words),
        axis_json(distance_words), principal_units_shown, palette().size(), Json(dash_patterns()).dump(),
        most_shown_at_first, fmt::join(series, "},\n{"), abscissae.text());
}

PageData series_box(std::size_t number, bool is_checked, const std::string& label)
{
    PageData box;
    box.set("number", std::to_string(number));
    box.set("checked", is_checked);
    box.set("label", label);
    return box;
}

PageData box_group(std::size_t run, const std::string& title, const PageData& boxes)
{
    PageData group;
    group.set("run", std::to_string(run));
    group.set("title", title);
    group.set("boxes", boxes);
    return group;
}

/// The boxes of the gallery.
PageData gallery_group(const Site& site)
{
    const bool is_asked = site.gallery_use == Gallery::laid_behind;
    PageData boxes{PageData::type::list};
    std::size_t number = site.series().size();
    for (const GalleryMethod* method : site.gallery) {
        const auto chosen = gallery_choice(method->curve.dimension);
        const bool is_checked = is_asked && std::ranges::find(chosen, method) != chosen.end();
        boxes << series_box(number++, is_checked, label_with_points(method->label, method->curve.points));
    }
    return box_group(site.runs.size(), gallery_title, boxes);
}

/// The boxes to tick, a group a run.
PageData groups(const Site& site)
{
    PageData list{PageData::type::list};
    const auto checked = shown_at_first(site.series());
    std::size_t number = 0;
    for (std::size_t i = 0; i < site.runs.size(); ++i) {
        const auto& run = site.runs[i];
        if (run.series.empty()) continue;
        PageData boxes{PageData::type::list};
        for (const auto& series : run.series) {
            boxes << series_box(number, checked.contains(number), series.label);
            ++number;
        }
        list << box_group(i, run.stored->title, boxes);
    }
    if (!site.gallery.empty()) list << gallery_group(site);
    return list;
}

PageData quantities(const std::vector<ChosenPlot>& plots)
{
    PageData list{PageData::type::list};
    for (const auto& chosen : plots) {
        PageData quantity;
        quantity.set("value", chosen.plot.key);
        quantity.set("text", chosen.title);
        list << quantity;
    }
    return list;
}

}

std::string render_compare_page(const Site& site)
{
    std::vector<const ReportRun*> runs;
    for (const auto& run : site.runs)
        if (!run.series.empty()) runs.push_back(&run);
    PageData page;
    page.set("title", "Compare");
    page.set("report", site.title);
    page.set("groups", groups(site));
    const auto plots = chosen_plots(site);
    page.set("quantities", quantities(plots));
    // Sets of the gallery have other sizes.
    page.set("has_gallery_curves", site.gallery_use == Gallery::laid_behind);
    page.set("several_quantities", plots.size() > 1);
    page.set("both_dimensions", has_dimension(runs, 2) && has_dimension(runs, 3));
    page.set("json", site_json(site, plots));
    const auto folder = site.has_several_runs() ? site.out : site.runs.front().root;
    page.set("overlays", overlays(site.overlays, series_of(site), {folder, site.out}));
    page.set("overlaid", !site.overlays.empty());
    return render_in_frame(
        site,
        {site.out / compare_page, "Compare · " + site.title, {"compare_chart.js", "compare.js", "compare_hands.js"}},
        "compare", page);
}

}
