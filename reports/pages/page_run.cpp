// The content of a run's page, which is a part of the overview if there is one run only.
#include "reports/layout/thumbnails.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

PageData card(const ReportSeries& series, std::size_t index, const std::filesystem::path& page_folder)
{
    const auto picture = small_pictures(series).front();
    auto data = series_identity(series, index);
    data.set("link", relative_link(page_folder, page_of(series)));
    data.set("source", relative_link(page_folder, series.pictures / picture.file));
    data.set("image_class", picture.image_class);
    data.set("alt", fmt::format("{}: {}", series.label, picture.name));
    std::string value = fmt::format("N = {}", format_count(series.stored->points));
    if (series.stored->relative_radius) value += ", " + radius_words(*series.stored, 3);
    data.set("value", value);
    return data;
}

PageData cards(const ReportRun& run, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (std::size_t i = 0; i < run.series.size(); ++i)
        if (!is_in_matrix(run.series[i])) list << card(run.series[i], i, page_folder);
    return list;
}

PageData tiling_sections(const ReportRun& run, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (std::size_t i = 0; i < run.tilings.size(); ++i) list << tiling_section(run.tilings[i], i, page_folder);
    return list;
}

PageData construction_sections(const ReportRun& run, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (std::size_t i = 0; i < run.constructions.size(); ++i)
        list << construction_section(run.constructions[i], i, page_folder);
    return list;
}

PageData zone_plate_reference_data(const ReportRun& run, const std::filesystem::path& page_folder)
{
    const auto curves = zone_plate_curves(series_of(run));
    if (curves.empty()) return false;
    PageData data;
    data.set("link", relative_link(page_folder, run.root / zone_plate_reference_picture));
    data.set("size", format_count(static_cast<std::uint64_t>(curves.front().size)));
    return data;
}

/// The link to the compare page with this run's series ticked.
PageData compare_link(const Site& site, const ReportRun& run, const std::filesystem::path& page_folder)
{
    if (!site.has_curves_to_compare()) return false;
    const auto page = relative_link(page_folder, site.out / compare_page);
    return site.has_several_runs() ? fmt::format("{}#run-{}", page, &run - site.runs.data()) : page;
}

PageData neighbour(const Site& site, std::size_t index, const std::filesystem::path& from)
{
    if (index >= site.runs.size()) return false;
    PageData data;
    data.set("label", site.runs[index].stored->title);
    data.set("link", relative_link(from, page_of(site.runs[index])));
    return data;
}

}

std::string render_run(const Site& site, const ReportRun& run, const std::filesystem::path& page_folder, PageData& page)
{
    const PlotPlace place{run.root, page_folder};
    set_dimension_words(page, {&run});
    page.set("matrices", matrices(run, page_folder));
    page.set("has_matrices", std::ranges::any_of(run.series, is_in_matrix));
    page.set("has_glance", has_glance(run));
    page.set("glance", glance(run, page_folder));
    page.set("has_cards", !has_glance(run) && !std::ranges::all_of(run.series, is_in_matrix));
    page.set("cards", cards(run, page_folder));
    page.set("compared", run.series.size() > 1 || site.gallery_use == Gallery::laid_behind);
    page.set("gallery", gallery_table(site, run));
    page.set("compare_link", compare_link(site, run, page_folder));
    page.set("overlays", overlays(run.overlays, series_of(run), place));
    page.set("integration", overlays(run.integration, {}, place));
    page.set("integrated", !run.integration.empty());
    page.set("regions", overlays(run.regions, {}, place));
    page.set("has_regions", !run.regions.empty());
    page.set("tile_radii", overlays(run.tile_radii, {}, place));
    page.set("has_tile_radii", !run.tile_radii.empty());
    page.set("plate", zone_plate_reference_data(run, page_folder));
    page.set("tilings", tiling_sections(run, page_folder));
    page.set("has_tilings", !run.tilings.empty());
    page.set("constructions", construction_sections(run, page_folder));
    page.set("has_constructions", !run.constructions.empty());
    set_textures(page, run, page_folder);
    set_distributions(page, run, page_folder);
    return render_template("run", page);
}

std::string render_run_page(const Site& site, std::size_t index)
{
    const ReportRun& run = site.runs[index];
    PageData parts;
    PageData page;
    page.set("content", render_run(site, run, run.root, parts));
    page.set("has_glance", has_glance(run));
    page.set("glance", glance(run, run.root));
    page.set("title", run.stored->title);
    page.set("summary", summary_of({&run}));
    page.set("missing", missing_in({&run}));
    page.set("overview", relative_link(run.root, site.out / overview_page));
    page.set("previous", neighbour(site, index - 1, run.root)); // of the first there is none
    page.set("next", neighbour(site, index + 1, run.root));
    set_provenance(page, *run.stored);
    return render_in_frame(site, {page_of(run), run.stored->title + " · " + site.title, {"matrix.js"}}, "figure", page);
}

}
