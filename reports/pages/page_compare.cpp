// The compare page: curves of all series as data for its script, and what works without it.
#include "reports/layout/plots.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace poissonlab {

namespace {

using Json = nlohmann::json;

constexpr std::size_t most_shown_at_first = 12;

// The number of points in the middle of all: curves of far fewer or more would not lie over the others.
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

// The numbers of the series that are shown at first: all of a few; of many, the first estimate by each method, of about
// as many points as most; of many by one method, some from all over the list.
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

// Numbers with five digits, each on its own so that none is written with more; null where there is no number.
std::string short_number(double value) { return std::isfinite(value) ? fmt::format("{:.5g}", value) : "null"; }

template <class Bins, class Value>
std::string short_numbers(const Bins& bins, const Value& value)
{
    std::string text;
    for (const auto& bin : bins) text += (text.empty() ? "" : ",") + short_number(std::invoke(value, bin));
    return "[" + text + "]";
}

// Series share their frequencies and distances, mostly: each list is written once.
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

// A JSON text that may stand in HTML.
std::string quoted(const std::string& text)
{
    std::string result;
    for (const char c : Json(text).dump()) result += c == '<' ? "\\u003c" : std::string(1, c);
    return result;
}

std::string series_json(const Site& site, const ReportSeries& series, std::size_t run, Abscissae& abscissae)
{
    const Curve& curve = series.curve;
    auto text =
        fmt::format("{{\"label\":{},\"run\":{},\"dimension\":{},\"points\":{},\"page\":{}", quoted(series.label), run,
                    curve.dimension, curve.points, quoted(relative_link(site.out, page_of(series))));
    if (curve.principal_frequency) text += ",\"principal\":" + short_number(*curve.principal_frequency);
    if (!curve.bins.empty())
        text += fmt::format(",\"frequencies\":{},\"background\":{},\"power\":{},\"anisotropy\":{}",
                            abscissae.number_of(short_numbers(curve.bins, &RadialBin::frequency)),
                            short_number(curve.background_db), short_numbers(curve.bins, &RadialBin::power),
                            short_numbers(curve.bins, &RadialBin::anisotropy_db));
    if (const auto& pairs = series.pair_correlation; !pairs.empty())
        text += fmt::format(",\"distances\":{},\"pairs\":{}",
                            abscissae.number_of(short_numbers(pairs, &PairCorrelationBin::distance)),
                            short_numbers(pairs, &PairCorrelationBin::value));
    return text + "}";
}

std::string site_json(const Site& site)
{
    Abscissae abscissae;
    std::vector<std::string> series;
    std::vector<std::string> runs;
    for (std::size_t i = 0; i < site.runs.size(); ++i) {
        runs.push_back(quoted(site.runs[i].stored->title));
        for (const auto& entry : site.runs[i].series) series.push_back(series_json(site, entry, i, abscissae));
    }
    return fmt::format("{{\"runs\":[{}],\n\"series\":[\n{}],\n\"abscissae\":{}}}", fmt::join(runs, ","),
                       fmt::join(series, ",\n"), abscissae.text());
}

// The boxes to tick, a group a run.
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
            PageData box;
            box.set("number", std::to_string(number));
            box.set("checked", checked.contains(number));
            box.set("label", series.label);
            boxes << box;
            ++number;
        }
        PageData group;
        group.set("run", std::to_string(i));
        group.set("title", run.stored->title);
        group.set("boxes", boxes);
        list << group;
    }
    return list;
}

// What there are curves of.
PageData quantities(const Site& site)
{
    PageData list{PageData::type::list};
    const auto add = [&](const char* value, const char* text, const auto& has) {
        const auto series = site.series();
        if (!std::ranges::any_of(series, has)) return;
        PageData quantity;
        quantity.set("value", value);
        quantity.set("text", text);
        list << quantity;
    };
    const auto has_spectrum = [](const ReportSeries* series) { return series->stored->has_spectrum(); };
    add("power", "Radially averaged power", has_spectrum);
    add("anisotropy", "Anisotropy", has_spectrum);
    add("pairs", "Pair correlation", [](const ReportSeries* series) { return !series->pair_correlation.empty(); });
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
    page.set("quantities", quantities(site));
    page.set("both_dimensions", has_dimension(runs, 2) && has_dimension(runs, 3));
    page.set("json", site_json(site));
    set_dimension_words(page, runs);
    const auto series = all_series_with_full_labels(site);
    const auto plots = site.has_several_runs() ? site.out : site.runs.front().root;
    page.set("overlays", overlays(series, {plots, site.out}));
    page.set("overlaid", overlays_are_drawn(series));
    return render_in_frame(site, {site.out / compare_page, "Compare · " + site.title, {"compare.js"}}, "compare", page);
}

}
