#include "reports/layout/plots.hpp"

namespace poissonlab {

namespace {

using AllSeries = std::vector<ReportSeries>;
using Pictures = std::vector<GnuplotPicture>;

// Whether a plot of several curves has something to compare.
template <class Curves>
bool several(const Curves& curves)
{
    return curves.size() > 1;
}

void add_frequency_plots(const AllSeries& series, Pictures& pictures)
{
    const auto curves = frequency_curves(series);
    const auto scales = common_scales(curves);
    for (const auto& curve : curves) {
        const auto& folder = series[curve.index].pictures;
        pictures.push_back(plot_radial_power(curve, scales, folder / "radial"));
        pictures.push_back(plot_anisotropy(curve, scales, folder / "anisotropy"));
    }
}

void add_frequency_overlays(const AllSeries& series, const std::filesystem::path& folder, Pictures& pictures)
{
    const auto curves = frequency_curves(series);
    const auto scales = common_scales(curves);
    if (several(curves)) {
        pictures.push_back(overlay_radial_power(curves, scales, folder / power_overlay));
        pictures.push_back(overlay_anisotropy(curves, scales, folder / anisotropy_overlay));
    }
    if (const auto principal = principal_curves(curves); several(principal))
        pictures.push_back(overlay_principal_power(principal, scales, folder / principal_overlay));
}

void add_pair_correlation_plots(const AllSeries& series, Pictures& pictures)
{
    const auto curves = pair_correlation_curves(series);
    const auto scales = common_pair_correlation_scales(curves);
    for (const auto& curve : curves)
        pictures.push_back(plot_pair_correlation(curve, scales, series[curve.index].pictures / "pair-correlation"));
}

void add_pair_correlation_overlay(const AllSeries& series, const std::filesystem::path& folder, Pictures& pictures)
{
    if (const auto curves = pair_correlation_curves(series); several(curves))
        pictures.push_back(overlay_pair_correlation(curves, common_pair_correlation_scales(curves),
                                                    folder / pair_correlation_overlay));
}

void add_iteration_plots(const AllSeries& series, Pictures& pictures)
{
    const auto curves = iteration_curves(series);
    if (curves.empty()) return;
    const auto scales = common_iteration_scales(curves);
    for (const auto& curve : curves) {
        const auto& folder = series[curve.index].pictures;
        pictures.push_back(plot_relative_radius(curve, scales, folder / "relative-radius"));
        pictures.push_back(plot_energy(curve, scales, folder / "energy"));
    }
}

void add_iteration_overlays(const AllSeries& series, const std::filesystem::path& folder, Pictures& pictures)
{
    const auto curves = iteration_curves(series);
    if (!several(curves)) return;
    const auto scales = common_iteration_scales(curves);
    pictures.push_back(overlay_relative_radius(curves, scales, folder / radius_overlay));
    pictures.push_back(overlay_energy(curves, scales, folder / energy_overlay));
}

void add_zone_plate_plots(const AllSeries& series, Pictures& pictures)
{
    const auto curves = zone_plate_curves(series);
    if (curves.empty()) return;
    const auto scales = common_zone_plate_scales(curves);
    for (const auto& curve : curves)
        pictures.push_back(plot_zone_plate_error(curve, scales, series[curve.index].pictures / "zone-plate-error"));
}

void add_zone_plate_overlay(const AllSeries& series, const std::filesystem::path& folder, Pictures& pictures)
{
    if (const auto curves = zone_plate_curves(series); several(curves))
        pictures.push_back(
            overlay_zone_plate_error(curves, common_zone_plate_scales(curves), folder / zone_plate_overlay));
}

void add_integration_plots(const AllSeries& series, const std::filesystem::path& folder, Pictures& pictures)
{
    const auto curves = integration_curves(series);
    for (const auto& integrand : integrands_of(curves))
        pictures.push_back(plot_integration_error(curves, integrand, folder / (integration_prefix + integrand)));
}

}

bool overlays_are_drawn(const AllSeries& series) { return series.size() > 1 && series.size() <= most_series_overlaid; }

Pictures series_plots(const AllSeries& series)
{
    Pictures pictures;
    add_frequency_plots(series, pictures);
    add_pair_correlation_plots(series, pictures);
    add_iteration_plots(series, pictures);
    add_zone_plate_plots(series, pictures);
    return pictures;
}

Pictures overlay_plots(const AllSeries& series, const std::filesystem::path& folder)
{
    Pictures pictures;
    add_integration_plots(series, folder, pictures);
    if (const auto curves = region_curves(series); !curves.empty())
        pictures.push_back(plot_region_points(curves, folder / region_plot));
    if (!overlays_are_drawn(series)) return pictures;
    add_frequency_overlays(series, folder, pictures);
    add_pair_correlation_overlay(series, folder, pictures);
    add_iteration_overlays(series, folder, pictures);
    add_zone_plate_overlay(series, folder, pictures);
    return pictures;
}

}
