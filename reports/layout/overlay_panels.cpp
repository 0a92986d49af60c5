#include "reports/layout/overlay_panels.hpp"

#include <map>

namespace poissonlab {

namespace {

std::string meaning_of(const std::string& integrand)
{
    static const std::map<std::string, std::string> meanings = {
        {"disk", "1 in a disk of radius 0.3, else 0"},
        {"ball", "1 in a ball of radius 0.3, else 0"},
        {"step", "1 on one side of a slanted line (3D: plane), else 0"},
        {"gaussian", "a bump of standard deviation 0.2 around the centre"},
        {"cosine", "product of 1 + cos 2πx, smooth across the borders as well"},
        {"bilinear", "x y, with a jump at the borders"},
        {"trilinear", "x y z, with a jump at the borders"},
    };
    const auto found = meanings.find(integrand);
    return found == meanings.end() ? "a function of the position" : found->second;
}

void add_frequency_panels(const SeriesList& series, std::vector<Panel>& panels)
{
    const auto curves = frequency_curves(series);
    const auto principal = principal_curves(series);
    const auto unit = common_unit(series);
    std::string over = "over frequency";
    if (unit == LengthUnit::spacing)
        over += ", in cycles per mean spacing of the points because the series have sets of different sizes";
    if (curves.size() > 1) {
        panels.push_back({"radial-all", together(power_plot(curves, unit)), "Radially averaged power", over,
                          "The dashed line, 1, is white noise: what random points give. A good set stays near 0 at low "
                          "frequencies, so that it adds no coarse noise to a picture, rises once around its principal "
                          "frequency, and settles at 1. The flatter it is after the rise, the less its errors form "
                          "patterns."});
        panels.push_back(
            {"structure-factor-all", together(structure_factor_plot(curves, unit)), "Structure factor",
             over + ", both axes logarithmic",
             "The same power where power laws are straight lines. A curve that goes on falling to the left "
             "is hyperuniform, one that falls off a cliff is stealthy, one that levels out keeps noise at "
             "all scales."});
        panels.push_back({"anisotropy-all", together(anisotropy_comparison(curves, unit)), "Anisotropy", over,
                          "Sets whose curve lies on the dashed line look the same in every direction, as far as "
                          "<i>K</i> sets can show. Where a curve rises above the line, directions differ, as they do "
                          "with a grid or with repeated tiles."});
    }
    if (principal.size() > 1)
        panels.push_back(
            {"radial-principal-all", together(power_plot(principal, LengthUnit::principal)), "Radially averaged power",
             "over frequency, in units of each series' principal frequency",
             "Each curve stretched so that its principal frequency, 1/d<sub>min</sub>, is at 1: what is "
             "left are differences in kind, not in distance. Series whose spectrum does not reach that far "
             "are left out."});
}

void add_pair_correlation_panel(const SeriesList& series, std::vector<Panel>& panels)
{
    const auto curves = pair_correlation_curves(series);
    if (curves.size() < 2) return;
    panels.push_back(
        {"pair-correlation-all", together(pair_correlation_plot(curves, packing_distance)), "Pair correlation",
         "over distance",
         "Distances are in units of the largest minimum distance that so many points could have, so that "
         "a curve leaves 0 at its relative radius. The dashed line, 1, is random points; a high and narrow "
         "first peak, and more peaks after it, are order."});
}

void add_number_variance_panel(const SeriesList& series, std::vector<Panel>& panels)
{
    const auto curves = number_variance_curves(series);
    if (curves.size() < 2) return;
    panels.push_back(
        {"number-variance-all", together(number_variance_plot(curves)), "Number variance",
         "over the radius, both axes logarithmic",
         "How much the number of points in a ball varies from place to place, over how much that of random "
         "points does (dashed). Curves that go on falling, by a factor of ten a decade at best, are "
         "hyperuniform; one that runs level has kept noise at all scales."});
}

void add_iteration_panels(const SeriesList& series, std::vector<Panel>& panels)
{
    const auto curves = iteration_curves(series);
    if (curves.size() < 2) return;
    panels.push_back({"relative-radius-all", together(relative_radius_plot(curves)), "Relative radius",
                      "over iterations",
                      "The higher, the further apart the nearest two points. A method that has found its balance runs "
                      "level; one that still climbs would gain from more iterations. Means over the sets that got so "
                      "far. Dots, of tiles, are of the nearest two points of one tile."});
    const auto energies = energy_curves(series, false);
    if (energies.size() < 2) return;
    panels.push_back({"energy-all", together(energy_plot(energies)), "Energy", "over iterations",
                      "How far a place is from its nearest point, squared, on average, in units of the mean spacing: "
                      "the lower, the more evenly the points serve all places. The dashed line is the perfect lattice; "
                      "a set that comes too near to it has rows."});
}

void add_zone_plate_panel(const SeriesList& series, std::vector<Panel>& panels)
{
    const auto curves = zone_plate_curves(series);
    if (curves.size() < 2) return;
    panels.push_back(
        {"zone-plate-error-all", together(zone_plate_plot(curves)), "Zone plate error",
         "over the frequency of the plate",
         "The further to the right a curve stays low, the finer the patterns that the set samples "
         "faithfully. Right of the dotted line the plate is too fine for the pixels, and what is above 0 is "
         "what a set adds: noise where the curve is level, false patterns where it has peaks."});
}

}

std::vector<Panel> overlay_panels(const SeriesList& series)
{
    std::vector<Panel> panels;
    if (series.size() > most_series_overlaid) return panels;
    const auto named = with_points_in_names(series);
    add_frequency_panels(named, panels);
    add_pair_correlation_panel(named, panels);
    add_number_variance_panel(named, panels);
    add_iteration_panels(named, panels);
    add_zone_plate_panel(named, panels);
    return panels;
}

std::vector<Panel> gallery_panels(const SeriesList& series, const std::vector<const GalleryMethod*>& gallery)
{
    auto curves = frequency_curves(series);
    if (curves.empty() || gallery.empty()) return {};
    for (std::size_t i = 0; i < gallery.size() && series.size() + i < most_series_overlaid; ++i)
        curves.push_back({series.size() + i, gallery[i]->label, &gallery[i]->curve});
    const std::string beside = "beside the gallery, over frequency in cycles per mean spacing of the points";
    const char* guide = "The first curves are those of the series, the others some of the gallery: the laboratory's "
                        "methods, measured in the same way. The compare page has all of them. Sets of different sizes "
                        "compare per mean spacing.";
    const LengthUnit unit = LengthUnit::spacing;
    return {{"radial-gallery", together(power_plot(curves, unit)), "Radially averaged power", beside, guide},
            {"structure-factor-gallery", together(structure_factor_plot(curves, unit)), "Structure factor",
             beside + ", both axes logarithmic", guide},
            {"anisotropy-gallery", together(anisotropy_comparison(curves, unit)), "Anisotropy", beside,
             std::string(guide) + " The mean of <i>K</i> spectra has −10 log₁₀ <i>K</i> dB by chance alone. Where "
                                  "<i>K</i> differs, curves are drawn relative to that level."}};
}

std::vector<Panel> integration_panels(const SeriesList& series)
{
    std::vector<Panel> panels;
    const auto curves = integration_curves(series);
    for (const auto& integrand : integrands_of(curves))
        panels.push_back({"integration-" + integrand, integration_error_plot(curves, integrand), integrand + ":",
                          meaning_of(integrand)});
    return panels;
}

}
