#include "reports/site/report.hpp"

#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/programs/side_by_side.hpp"
#include "reports/claims/paper_claims.hpp"
#include "reports/images/picture_store.hpp"
#include "reports/images/zone_plate_image.hpp"
#include "reports/layout/draw_panels.hpp"
#include "reports/layout/site.hpp"
#include "reports/layout/thumbnails.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_endless.hpp"
#include "results/collection_file.hpp"
#include "results/own_files.hpp"
#include "results/run.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

static_assert(std::ranges::equal(
    own_pages, std::array{overview_page, compare_page, claims_page}, std::ranges::equal_to(),
    [](const char* name) { return std::string_view(name); }, [](const char* name) { return std::string_view(name); }));

/// Throws InputError where a page would take the place of one that another program has written.
void check_pages(const Site& site)
{
    for (const char* page : own_pages) check_own_page(site.out / page);
    for (const ReportRun& run : site.runs) {
        check_own_page(page_of(run));
        for (const ReportSeries& series : run.series) check_own_page(page_of(series));
    }
}

void create_folders(const Site& site)
{
    try {
        fs::create_directories(site.out / asset_folder);
        for (const auto& run : site.runs) {
            fs::create_directories(run.root);
            for (const auto& entry : run.series) fs::create_directories(entry.pictures);
            for (const auto& entry : run.tilings) fs::create_directories(entry.pictures);
            for (const auto& entry : run.constructions) fs::create_directories(entry.pictures);
            for (const auto* all : {&run.distributions, &run.schemes})
                for (const auto& entry : *all) fs::create_directories(entry.pictures);
        }
    } catch (const fs::filesystem_error& error) {
        throw StorageError(error.what());
    }
}

/// The file of keys of pictures, among the assets.
constexpr auto picture_keys = "pictures.txt";

//// Draws the plate as perfect sampling shows it, in the size of the run's first picture.
void draw_zone_plate_reference(const ReportRun& run)
{
    const auto curves = zone_plate_curves(series_of(run));
    if (curves.empty()) return;
    write_png(run.root / zone_plate_reference_picture, draw_zone_plate(zone_plate_reference(curves.front().size)));
}

std::vector<GnuplotPicture> all_plots(const Site& site)
{
    std::vector<GnuplotPicture> plots;
    for (const auto& run : site.runs) {
        for (const auto& series : run.series)
            for (const auto& panel : series.panels) add_plot(panel, series.pictures, plots);
        for (const auto& distribution : run.distributions)
            for (const auto& panel : distribution.curves) add_plot(panel, distribution.pictures, plots);
        for (const auto* panels : {&run.overlays, &run.integration, &run.regions, &run.tile_radii})
            for (const auto& panel : *panels) add_plot(panel, run.root, plots);
    }
    if (site.has_several_runs())
        for (const auto& panel : site.overlays) add_plot(panel, site.out, plots);
    return plots;
}

void draw_images(const ReportRun& run, PictureStore& store)
{
    for_each_side_by_side(run.series, [&](const ReportSeries& series) {
        for (const auto& panel : series.panels) draw_panel(panel, series.pictures, store);
    });
    for_each_side_by_side(run.tilings, [&](const auto& tiling) { draw_tiling_pictures(tiling, store); });
    for_each_side_by_side(run.constructions,
                          [&](const auto& construction) { draw_construction_picture(construction, store); });
    for (const auto* all : {&run.distributions, &run.schemes})
        for_each_side_by_side(*all, [&](const auto& distribution) { draw_distribution_pictures(distribution, store); });
    draw_zone_plate_reference(run);
    draw_run_thumbnail(run);
}

void write_pages(const Site& site, const std::vector<JudgedClaim>& claims)
{
    write_assets(site);
    write_whole_file(site.out / overview_page, render_overview_page(site));
    std::error_code ignored;
    if (!claims.empty())
        write_whole_file(site.out / claims_page, render_claims_page(site, claims));
    else
        fs::remove(site.out / claims_page, ignored);
    if (site.has_curves_to_compare())
        write_whole_file(site.out / compare_page, render_compare_page(site));
    else
        fs::remove(site.out / compare_page, ignored); // of an earlier report
    for (std::size_t i = 0; i < site.runs.size(); ++i) {
        const ReportRun& run = site.runs[i];
        if (site.has_several_runs()) write_whole_file(page_of(run), render_run_page(site, i));
        for (const ReportConstruction& construction : run.constructions)
            if (has_steps(construction))
                write_whole_file(steps_page_of(construction), render_steps_page(site, run, construction));
        for_all_side_by_side(run.series.size(), [&](std::size_t index) {
            const ReportSeries& series = run.series[index];
            write_whole_file(page_of(series), render_series_page(site, run, index));
            if (has_endless_page(series)) write_whole_file(endless_page_of(series), render_endless_page(site, series));
        });
    }
}

}

void write_report(const std::vector<fs::path>& result_folders, const fs::path& out,
                  const std::function<void(const std::string&)>& progress, PrintPictures print, Gallery gallery)
{
    const auto say = [&](const std::string& step) {
        if (progress) progress(step);
    };
    if (result_folders.empty()) throw InputError("a report needs at least one result folder");

    say("reading results");
    std::vector<Run> runs;
    for (const auto& folder : output_folders(result_folders)) runs.push_back(read_run(folder));
    const auto collection = result_folders.size() == 1 ? read_collection_file(result_folders.front()) : std::nullopt;
    auto site = make_site(runs, out, collection ? collection->title : std::string(), gallery);
    check_pages(site);
    create_folders(site);

    say("drawing pictures");
    PictureStore store(out, out / asset_folder / picture_keys);
    // gnuplot works in its own processes while this one draws the images.
    do_side_by_side([&] { draw_with_gnuplot(all_plots(site), print, &store); },
                    [&] { for_each_side_by_side(site.runs, [&](const auto& run) { draw_images(run, store); }); });
    store.save();

    const auto claims = judge_claims(site.series(), site.distributions());
    if (!claims.empty()) site.pages.push_back({claims_page, "The papers' claims"});

    say("writing the pages");
    write_pages(site, claims);
}

}
