// The plots of all series of a run.
#include "reports/layout/plots.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

// `kind` is what the guide knows a plot by; `over` is its horizontal axis.
PageData overlay_panel(const OverlayPlace& place, const std::string& stem, const std::string& kind,
                       const std::string& title, const std::string& over, const std::vector<std::string>& labels)
{
    PageData data;
    data.set("title", title);
    data.set("over", over);
    data.set("guide_kind", guide_kind(kind));
    auto alt = fmt::format("{} of all series over {}: ", title, over);
    for (std::size_t i = 0; i < labels.size(); ++i) alt += (i > 0 ? ", " : "") + labels[i];
    data.set("alt", alt);
    data.set("source", relative_link(place.page_folder, place.plots / (stem + ".svg")));
    data.set("svg", relative_link(place.page_folder, place.plots / (stem + ".svg")));
    data.set("png", relative_link(place.page_folder, place.plots / (stem + ".png")));
    return data;
}

// The labels of the series that have a curve, in order.
template <class Curves>
std::vector<std::string> labels_of(const Curves& curves)
{
    std::vector<std::string> labels;
    for (const auto& curve : curves) labels.push_back(curve.label);
    return labels;
}

}

PageData region_panel(const std::vector<ReportSeries>& series, const OverlayPlace& place)
{
    const auto labels = labels_of(region_curves(series));
    if (labels.empty()) return false;
    return overlay_panel(place, region_plot, "is_regions", "Points in the regions of tiles",
                         "the number of points a tile", labels);
}

PageData overlays(const std::vector<ReportSeries>& series, const OverlayPlace& place)
{
    PageData list{PageData::type::list};
    if (!overlays_are_drawn(series)) return list;
    const auto add = [&](const std::string& stem, const char* kind, const char* title, const std::string& over,
                         const std::vector<std::string>& labels) {
        if (labels.size() > 1) list << overlay_panel(place, stem, kind, title, over, labels);
    };
    std::string over = "frequency";
    if (sizes_differ(series))
        over += ", in cycles per mean spacing of the points because the series have sets of different sizes";
    const auto frequencies = frequency_curves(series);
    const auto iterations = labels_of(iteration_curves(series));
    add(power_overlay, "is_power_overlay", "Radially averaged power", over, labels_of(frequencies));
    add(anisotropy_overlay, "is_anisotropy_overlay", "Anisotropy", over, labels_of(frequencies));
    add(principal_overlay, "is_principal_overlay", "Radially averaged power",
        "frequency, in units of each series' principal frequency", labels_of(principal_curves(frequencies)));
    add(pair_correlation_overlay, "is_pairs_overlay", "Pair correlation", "distance",
        labels_of(pair_correlation_curves(series)));
    add(radius_overlay, "is_radius_overlay", "Relative radius", "iterations", iterations);
    add(energy_overlay, "is_energy_overlay", "Energy", "iterations", iterations);
    add(zone_plate_overlay, "is_plate_overlay", "Zone plate error", "the frequency of the plate",
        labels_of(zone_plate_curves(series)));
    return list;
}

}
