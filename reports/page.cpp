#include "reports/page.hpp"

#include "reports/embedding.hpp"
#include "reports/number_format.hpp"
#include "reports/page_parts.hpp"
#include "reports/page_template.hpp"
#include "reports/tone_mapping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace poissonlab {

namespace {

std::string engine_words(const std::string& engine)
{
    return engine == "opencl" ? "OpenCL" : engine == "reference" ? "the sequential reference" : engine;
}

// "16,384", or "256 to 16,384" where series differ.
template <typename Value>
std::string range_of(const std::vector<ReportSeries>& series, Value StoredSeries::*member)
{
    const auto values = [&](const ReportSeries& entry) { return entry.stored->*member; };
    const auto [low, high] = std::ranges::minmax(series, {}, values);
    const auto from = format_count(static_cast<std::uint64_t>(values(low)));
    const auto to = format_count(static_cast<std::uint64_t>(values(high)));
    return from == to ? from : from + " to " + to;
}

// The devices of all runs, each once.
std::string devices(const std::vector<StoredRun>& runs)
{
    std::string text;
    std::set<std::string> seen;
    for (const auto& run : runs) {
        const auto device = run.machine_member("device");
        if (!device.empty() && seen.insert(device).second) text += (text.empty() ? "" : "; ") + device;
    }
    return text;
}

std::string title_of(const std::vector<StoredRun>& runs)
{
    std::string title = runs.size() > 1 ? "Comparison: " : "";
    for (std::size_t i = 0; i < runs.size(); ++i) title += (i > 0 ? "; " : "") + runs[i].title;
    return title;
}

bool has_dimension(const std::vector<StoredRun>& runs, int dimension)
{
    return std::ranges::any_of(runs, [&](const auto& run) { return run.dimension == dimension; });
}

// What things are called in the dimensions that a report has.
void set_dimension_words(PageData& page, const std::vector<StoredRun>& runs)
{
    const bool plane = has_dimension(runs, 2);
    const bool space = has_dimension(runs, 3);
    const auto words = [&](const std::string& name, const std::string& in_plane,
                           const std::string& in_space) {
        page.set(name, plane && space ? in_plane + " (3D: " + in_space + ")" : plane ? in_plane : in_space);
    };
    words("disk", "disk", "sphere");
    words("disks", "disks", "spheres");
    words("ring", "ring", "shell");
    words("rings", "rings", "spherical shells");
    words("lattice", "hexagonal lattice", "face-centred cubic lattice");
    page.set("space", space);
}

std::string tilings_summary(const std::vector<ReportTiling>& tilings)
{
    const auto sets = static_cast<std::size_t>(
        std::ranges::count_if(tilings, [](const auto& tiling) { return !tiling.stored->set.empty(); }));
    const auto counted = [](std::size_t count, const char* one) {
        return count == 0 ? std::string() : fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
    };
    const auto first = counted(sets, "tile set"), second = counted(tilings.size() - sets, "tiling");
    if (tilings.empty()) return {};
    return first + (first.empty() || second.empty() ? "" : " and ") + second + ".";
}

std::string summary_of(const std::vector<StoredRun>& runs, const std::vector<ReportSeries>& series,
                       const std::vector<ReportTiling>& tilings,
                       const std::vector<ReportConstruction>& constructions)
{
    auto tiles = tilings_summary(tilings);
    if (!constructions.empty())
        tiles += fmt::format("{}{} of the construction of Poisson tiles.", tiles.empty() ? "" : " ",
                             constructions.size() == 1 ? "A picture" : format_count(constructions.size()) + " pictures");
    if (series.empty()) return tiles;
    const auto realizations = range_of(series, &StoredSeries::realizations);
    const bool mixed = has_dimension(runs, 2) && has_dimension(runs, 3);
    const auto dimension = mixed ? "2D and 3D" : fmt::format("{}D", runs.front().dimension);
    auto text = fmt::format("{} series of {} points on the unit torus in {}, {} realization{}{}",
                            series.size() == 1 ? "One" : format_count(series.size()),
                            range_of(series, &StoredSeries::points), dimension, realizations,
                            realizations == "1" ? "" : "s", series.size() == 1 ? "" : " each");
    const auto& engine = runs.front().engine;
    const bool one_engine = std::ranges::all_of(runs, [&](const auto& run) { return run.engine == engine; });
    if (!engine.empty() && one_engine) text += fmt::format(", made with {}", engine_words(engine));
    return text + "." + (tiles.empty() ? "" : " " + tiles);
}

// `kind` is the flag that the template knows a plot by; `over` is its horizontal axis.
PageData overlay_panel(const std::filesystem::path& out, const std::string& stem, const std::string& kind,
                       const std::string& title, const std::string& over,
                       const std::vector<std::string>& labels)
{
    PageData data;
    data.set("title", title);
    data.set("over", over);
    data.set(kind, true);
    auto alt = fmt::format("{} of all series over {}: ", title, over);
    for (std::size_t i = 0; i < labels.size(); ++i) alt += (i > 0 ? ", " : "") + labels[i];
    data.set("alt", alt);
    data.set("source", data_uri(out / (stem + ".svg")));
    data.set("svg", stem + ".svg");
    data.set("png", stem + ".png");
    return data;
}

PageData overlays(const std::vector<ReportSeries>& series, const std::filesystem::path& out)
{
    PageData list{PageData::type::list};
    if (series.size() < 2) return list;
    std::vector<std::string> labels;
    for (const auto& entry : series) labels.push_back(entry.label);
    std::string over = "frequency";
    if (sizes_differ(frequency_curves(series)))
        over += ", in cycles per mean spacing of the points because the series have sets of different sizes";
    list << overlay_panel(out, power_overlay, "is_power", "Radially averaged power", over, labels);
    list << overlay_panel(out, anisotropy_overlay, "is_anisotropy", "Anisotropy", over, labels);

    const auto labels_of = [](const auto& curves) {
        std::vector<std::string> names;
        for (const auto& curve : curves) names.push_back(curve.label);
        return names;
    };
    if (const auto principal = labels_of(principal_curves(frequency_curves(series))); principal.size() > 1)
        list << overlay_panel(out, principal_overlay, "is_principal", "Radially averaged power",
                              "frequency, in units of each series' principal frequency", principal);
    if (const auto pairs = labels_of(pair_correlation_curves(series)); pairs.size() > 1)
        list << overlay_panel(out, pair_correlation_overlay, "is_pairs", "Pair correlation", "distance", pairs);
    if (const auto iterative = labels_of(iteration_curves(series)); iterative.size() > 1) {
        list << overlay_panel(out, radius_overlay, "is_radius", "Relative radius", "iterations", iterative);
        list << overlay_panel(out, energy_overlay, "is_energy", "Energy", "iterations", iterative);
    }
    if (const auto plates = labels_of(zone_plate_curves(series)); plates.size() > 1)
        list << overlay_panel(out, zone_plate_overlay, "is_plate", "Zone plate error",
                              "the frequency of the plate", plates);
    return list;
}

}

PageData provenance(const StoredRun& run)
{
    PageData facts{PageData::type::list};
    const auto add = [&](const std::string& name, const std::string& value) {
        if (value.empty()) return;
        PageData fact;
        fact.set("name", name);
        fact.set("value", value);
        facts << fact;
    };
    add("Program", "poissonlab " + run.version);
    add("Seed", run.seed);
    add("Engine", engine_words(run.engine));
    for (const auto& [name, value] : run.machine) {
        auto words = name;
        std::ranges::replace(words, '_', ' ');
        words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
        add(words, value);
    }
    std::string overrides;
    for (const auto& text : run.overrides) overrides += (overrides.empty() ? "" : "  ") + text;
    add("Overrides", overrides);

    PageData data;
    data.set("run_title", run.title);
    data.set("command", optional_text(run.command));
    data.set("config", optional_text(run.config));
    data.set("facts", facts);
    return data;
}

PageData tone_scale()
{
    PageData ticks{PageData::type::list};
    for (const double power : {0.01, 0.1, 1.0, 10.0}) {
        PageData tick;
        tick.set("power", format_exact(power));
        tick.set("percent", fmt::format("{:.2f}", 100 * report_tone_mapping.position(power)));
        ticks << tick;
    }
    PageData data;
    data.set("scale_ticks", ticks);
    data.set("black_power", format_exact(report_tone_mapping.black_power));
    data.set("white_power", format_exact(report_tone_mapping.white_power));
    return data;
}

std::string render_page(const std::vector<StoredRun>& runs, const std::vector<ReportSeries>& series,
                        const std::vector<ReportTiling>& tilings,
                        const std::vector<ReportConstruction>& constructions, const std::filesystem::path& out)
{
    PageData page;
    page.set("style", std::string(page_template_file("templates/report.css")));
    page.set("title", title_of(runs));
    page.set("summary", summary_of(runs, series, tilings, constructions));
    page.set("tone_scale", tone_scale());
    set_dimension_words(page, runs);

    PageData rows{PageData::type::list};
    PageData sections{PageData::type::list};
    for (std::size_t i = 0; i < series.size(); ++i) {
        rows << overview_row(series[i], i);
        sections << series_section(series[i], i, out);
    }
    PageData tiling_sections{PageData::type::list};
    for (std::size_t i = 0; i < tilings.size(); ++i) tiling_sections << tiling_section(tilings[i], i, out);
    page.set("tilings", tiling_sections);
    page.set("has_tilings", !tilings.empty());
    PageData construction_sections{PageData::type::list};
    for (std::size_t i = 0; i < constructions.size(); ++i)
        construction_sections << construction_section(constructions[i], i, out);
    page.set("constructions", construction_sections);
    page.set("has_constructions", !constructions.empty());
    page.set("has_series", !series.empty());
    page.set("rows", rows);
    page.set("sections", sections);
    page.set("several_devices", runs.size() > 1);
    page.set("devices", optional_text(devices(runs)));

    page.set("compared", series.size() > 1);
    page.set("overlays", overlays(series, out));
    page.set("integration", integration_panels(series, out));
    page.set("integrated", !integration_curves(series).empty());
    page.set("pairs", !pair_correlation_curves(series).empty());
    page.set("iterative", !iteration_curves(series).empty());
    page.set("zone_plate", zone_plate_reference_panel(series, out));

    PageData sources{PageData::type::list};
    for (const auto& run : runs) sources << provenance(run);
    page.set("provenance", sources);

    kainjow::mustache::mustache text{std::string(page_template_file("templates/report.mustache"))};
    return text.render(page);
}

}
