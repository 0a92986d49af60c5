#include "reports/report.hpp"

#include "analysis/zone_plate_reference.hpp"
#include "errors/errors.hpp"
#include "io/whole_file.hpp"
#include "reports/page.hpp"
#include "reports/report_layout.hpp"
#include "reports/series_pictures.hpp"
#include "reports/stored_results.hpp"
#include "reports/zone_plate_image.hpp"

#include <tbb/parallel_for_each.h>
#include <tbb/parallel_invoke.h>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

void create_folders(const fs::path& out, const std::vector<ReportSeries>& series,
                    const std::vector<ReportTiling>& tilings,
                    const std::vector<ReportConstruction>& constructions)
{
    try {
        fs::create_directories(out);
        for (const auto& entry : series) fs::create_directories(entry.pictures);
        for (const auto& entry : tilings) fs::create_directories(entry.pictures);
        for (const auto& entry : constructions) fs::create_directories(entry.pictures);
    } catch (const fs::filesystem_error& error) {
        throw StorageError(error.what());
    }
}

// Radially averaged power and anisotropy of every series, and of all.
void add_frequency_plots(const std::vector<ReportSeries>& series, const fs::path& out,
                         std::vector<GnuplotPicture>& pictures)
{
    const auto curves = frequency_curves(series);
    const auto scales = common_scales(curves);
    for (std::size_t i = 0; i < series.size(); ++i) {
        pictures.push_back(plot_radial_power(curves[i], scales, series[i].pictures / "radial"));
        pictures.push_back(plot_anisotropy(curves[i], scales, series[i].pictures / "anisotropy"));
    }
    if (series.size() > 1) {
        pictures.push_back(overlay_radial_power(curves, scales, out / power_overlay));
        pictures.push_back(overlay_anisotropy(curves, scales, out / anisotropy_overlay));
    }
    if (const auto principal = principal_curves(curves); principal.size() > 1)
        pictures.push_back(overlay_principal_power(principal, scales, out / principal_overlay));
}

// The pair correlation of every series, and of all.
void add_pair_correlation_plots(const std::vector<ReportSeries>& series, const fs::path& out,
                                std::vector<GnuplotPicture>& pictures)
{
    const auto curves = pair_correlation_curves(series);
    const auto scales = common_pair_correlation_scales(curves);
    for (const auto& curve : curves)
        pictures.push_back(
            plot_pair_correlation(curve, scales, series[curve.index].pictures / "pair-correlation"));
    if (curves.size() > 1)
        pictures.push_back(overlay_pair_correlation(curves, scales, out / pair_correlation_overlay));
}

// Errors of integrals against the number of points, a plot an integrand.
void add_integration_plots(const std::vector<ReportSeries>& series, const fs::path& out,
                           std::vector<GnuplotPicture>& pictures)
{
    const auto curves = integration_curves(series);
    for (const auto& integrand : integrands_of(curves))
        pictures.push_back(plot_integration_error(curves, integrand, out / (integration_prefix + integrand)));
}

// Relative radius and energy of every series that has iterations, and of all of these.
void add_iteration_plots(const std::vector<ReportSeries>& series, const fs::path& out,
                         std::vector<GnuplotPicture>& pictures)
{
    const auto curves = iteration_curves(series);
    if (curves.empty()) return;
    const auto scales = common_iteration_scales(curves);
    for (const auto& curve : curves) {
        const auto& folder = series[curve.index].pictures;
        pictures.push_back(plot_relative_radius(curve, scales, folder / "relative-radius"));
        pictures.push_back(plot_energy(curve, scales, folder / "energy"));
    }
    if (curves.size() > 1) {
        pictures.push_back(overlay_relative_radius(curves, scales, out / radius_overlay));
        pictures.push_back(overlay_energy(curves, scales, out / energy_overlay));
    }
}

// The error of the zone plate of every series that has sampled it, and of all of these.
void add_zone_plate_plots(const std::vector<ReportSeries>& series, const fs::path& out,
                          std::vector<GnuplotPicture>& pictures)
{
    const auto curves = zone_plate_curves(series);
    if (curves.empty()) return;
    const auto scales = common_zone_plate_scales(curves);
    for (const auto& curve : curves)
        pictures.push_back(
            plot_zone_plate_error(curve, scales, series[curve.index].pictures / "zone-plate-error"));
    if (curves.size() > 1)
        pictures.push_back(overlay_zone_plate_error(curves, scales, out / zone_plate_overlay));
}

// What perfect sampling makes of the plate, in the size of the first picture.
void draw_zone_plate_reference(const std::vector<ReportSeries>& series, const fs::path& out)
{
    const auto curves = zone_plate_curves(series);
    if (curves.empty()) return;
    write_png(out / zone_plate_reference_picture, draw_zone_plate(zone_plate_reference(curves.front().size)));
}

std::vector<GnuplotPicture> all_plots(const std::vector<ReportSeries>& series, const fs::path& out)
{
    std::vector<GnuplotPicture> pictures;
    if (series.empty()) return pictures;
    add_frequency_plots(series, out, pictures);
    add_pair_correlation_plots(series, out, pictures);
    add_integration_plots(series, out, pictures);
    add_iteration_plots(series, out, pictures);
    add_zone_plate_plots(series, out, pictures);
    return pictures;
}

}

void write_report(const std::vector<fs::path>& result_folders, const fs::path& out,
                  const std::function<void(const std::string&)>& progress)
{
    const auto say = [&](const std::string& step) {
        if (progress) progress(step);
    };
    if (result_folders.empty()) throw InputError("a report needs at least one result folder");

    say("reading results");
    std::vector<StoredRun> runs;
    for (const auto& folder : result_folders) runs.push_back(read_stored_run(folder));
    auto series = lay_out(runs, out);
    for (auto& entry : series) read_curves(entry);
    const auto tilings = lay_out_tilings(runs, out);
    const auto constructions = lay_out_constructions(runs, out);
    create_folders(out, series, tilings, constructions);

    // gnuplot works in its own processes while this one draws the images.
    say("drawing pictures");
    tbb::parallel_invoke([&] { draw_with_gnuplot(all_plots(series, out)); },
                         [&] {
                             tbb::parallel_for_each(series, [](ReportSeries& entry) {
                                 draw_points_pictures(entry);
                                 draw_spectrum_pictures(entry);
                                 draw_zone_plate_picture(entry);
                             });
                             tbb::parallel_for_each(tilings, draw_tiling_pictures);
                             tbb::parallel_for_each(constructions, draw_construction_picture);
                             draw_zone_plate_reference(series, out);
                         });

    say("writing the page");
    write_whole_file(out / "index.html", render_page(runs, series, tilings, constructions, out));
}

}
