#include "reports/report.hpp"

#include "errors/errors.hpp"
#include "io/whole_file.hpp"
#include "reports/curves.hpp"
#include "reports/page.hpp"
#include "reports/report_layout.hpp"
#include "reports/series_pictures.hpp"
#include "reports/stored_results.hpp"

#include <tbb/parallel_for_each.h>
#include <tbb/parallel_invoke.h>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

void create_folders(const fs::path& out, const std::vector<ReportSeries>& series)
{
    try {
        fs::create_directories(out);
        for (const auto& entry : series) fs::create_directories(entry.pictures);
    } catch (const fs::filesystem_error& error) {
        throw StorageError(error.what());
    }
}

std::vector<GnuplotPicture> all_curves(const std::vector<ReportSeries>& series, const fs::path& out)
{
    std::vector<Curve> curves;
    for (const auto& entry : series) curves.push_back(entry.curve);
    const auto scales = common_scales(curves);

    std::vector<GnuplotPicture> pictures;
    for (std::size_t i = 0; i < series.size(); ++i) {
        pictures.push_back(plot_radial_power(curves[i], i, scales, series[i].pictures / "radial"));
        pictures.push_back(plot_anisotropy(curves[i], i, scales, series[i].pictures / "anisotropy"));
    }
    if (series.size() > 1) {
        pictures.push_back(overlay_radial_power(curves, scales, out / power_overlay));
        pictures.push_back(overlay_anisotropy(curves, scales, out / anisotropy_overlay));
    }
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
    for (auto& entry : series) read_curve(entry);
    create_folders(out, series);

    // gnuplot works in its own processes while this one draws the images.
    say("drawing pictures");
    tbb::parallel_invoke([&] { draw_with_gnuplot(all_curves(series, out)); },
                         [&] {
                             tbb::parallel_for_each(series, [](ReportSeries& entry) {
                                 draw_points_pictures(entry);
                                 draw_spectrum_picture(entry);
                             });
                         });

    say("writing the page");
    write_whole_file(out / "index.html", render_page(runs, series, out));
}

}
