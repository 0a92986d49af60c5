// The page of a series: panels, their captions, measures, and the stored files.
#include "base/geometry/relative_radius.hpp"
#include "reports/images/spectrum_image.hpp"
#include "reports/images/tone_mapping.hpp"
#include "reports/layout/series_pictures.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"
#include "reports/words/number_format.hpp"
#include "results/radial_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

constexpr std::size_t most_point_files_linked = 20;

const char* spectrum_word(const ReportSeries& series)
{
    return series.stored->is_estimate ? "Power spectrum estimate" : "Periodogram";
}

PageData points_panel(const ReportSeries& series)
{
    const auto& view = series.view;
    const auto side = format_significant(view.window, 2);
    std::string part = fmt::format("All {} points", format_count(view.total));
    if (view.shown() != view.total)
        part = fmt::format("{} of {} points", format_count(view.shown()), format_count(view.total));
    if (series.run->dimension == 3)
        part += fmt::format(": a slab of the cube, z below {}, seen along z", format_significant(view.depth, 2));
    if (view.window < 1) part += fmt::format(": the window of {} × {} at the lower left", side, side);
    if (series.stored->realizations > 1)
        part += fmt::format(" (first of {} realizations)", series.stored->realizations);
    auto data = picture_panel(series, {"points.svg", "points.png", "is_points", "ink framed"}, "Points", part + ".");
    data.set("window", side);
    return data;
}

// Ticks at plus and minus the principal frequency, in percent of the picture's width.
PageData principal_ticks(const Curve& curve, int size)
{
    PageData ticks{PageData::type::list};
    if (!curve.principal_frequency || *curve.principal_frequency >= size / 2) return ticks;
    for (const double sign : {-1.0, 1.0})
        ticks << PageData("percent",
                          fmt::format("{:.2f}", 100 * (size / 2 + 0.5 + sign * *curve.principal_frequency) / size));
    return ticks;
}

std::string spectrum_caption(const ReportSeries& series)
{
    const int size = series.stored->spectrum_size;
    const auto side = format_count(static_cast<std::uint64_t>(size));
    const bool planes = series.run->dimension == 3;
    auto caption = series.stored->is_estimate ? fmt::format("Mean of {} periodograms of", series.stored->realizations)
                                              : std::string("Of one set,");
    caption += fmt::format(" {} × {} frequencies", side, planes ? side + " × " + side : side);
    if (planes)
        caption += fmt::format(": the planes through frequency 0, from {} to {} along each axis",
                               format_fixed(-size / 2, 0), format_fixed(size / 2 - 1, 0));
    if (const int block = spectrum_page_block(size, series.run->dimension); block > 1)
        caption += fmt::format("; a pixel here is the mean of {0} × {0}, full size one click away", block);
    return caption + ".";
}

// Below a 2D spectrum; planes of a 3D one have no common axis.
PageData spectrum_axis(const ReportSeries& series)
{
    if (series.run->dimension == 3) return false;
    const int size = series.stored->spectrum_size;
    PageData data;
    data.set("lowest", format_fixed(-size / 2, 0));
    data.set("highest", format_fixed(size / 2 - 1, 0));
    data.set("ticks", principal_ticks(series.curve, size));
    return data;
}

PageData spectrum_panel(const ReportSeries& series)
{
    if (series.stored->spectrum_file.empty()) return false;
    auto data = picture_panel(series, {"spectrum-small.png", "spectrum.png", "is_spectrum", "framed"},
                              spectrum_word(series), spectrum_caption(series));
    data.set("spectrum_axis", spectrum_axis(series));
    return data;
}

PageData cube_panel(const ReportSeries& series)
{
    if (series.run->dimension == 2 || series.stored->spectrum_file.empty()) return false;
    return picture_panel(
        series, {"spectrum-cube.png", "spectrum-cube.png", "", ""}, "Cube of frequencies",
        "x to the lower left, y to the lower right, z upwards; the eighth where all are positive is cut "
        "away down to frequency 0.");
}

PageData slices_panel(const ReportSeries& series)
{
    if (series.run->dimension == 2 || series.stored->spectrum_file.empty()) return false;
    const auto slices = spectrum_slices(series);
    if (slices.empty()) return false;
    return picture_panel(series, {"spectrum-slices.png", "spectrum-slices.png", "", "", "row"}, "Slices",
                         fmt::format("Planes where the frequency along z is {}.", fmt::join(slices, ", ")));
}

PageData close_ups_panel(const ReportSeries& series)
{
    if (series.run->dimension == 2 || series.stored->spectrum_file.empty()) return false;
    const int reach = std::max(1, 5 * series.stored->spectrum_size / 16);
    return picture_panel(series, {"spectrum-close-ups.png", "spectrum-close-ups.png", "", "", "row"}, "Close-ups",
                         fmt::format("The middle of the planes through frequency 0, from {} to {}.",
                                     format_fixed(-reach, 0), format_fixed(reach - 1, 0)));
}

PageData radial_panel(const ReportSeries& series)
{
    if (!series.stored->has_spectrum()) return false;
    const auto& curve = series.curve;
    const auto peak = peak_power(curve.bins);
    auto caption =
        fmt::format("Highest {} at frequency {}. ", format_significant(peak.power, 3), format_exact(peak.frequency));
    if (!curve.principal_frequency)
        caption += "There is no principal frequency.";
    else
        caption += fmt::format("Principal frequency {}{}.", format_significant(*curve.principal_frequency, 4),
                               *curve.principal_frequency > curve.max_frequency ? ", beyond the axis" : "");
    return picture_panel(series, {"radial.svg", "radial.png", "is_radial"}, "Radially averaged power", caption);
}

PageData anisotropy_panel(const ReportSeries& series)
{
    if (!series.stored->has_spectrum()) return false;
    const auto& curve = series.curve;
    return picture_panel(series, {"anisotropy.svg", "anisotropy.png", "is_anisotropy"}, "Anisotropy",
                         fmt::format("Dashed: what noise alone gives, −10 log₁₀ K = {} dB for K\u00a0=\u00a0{}.",
                                     format_fixed(curve.background_db, 1), curve.realizations));
}

PageData pair_correlation_panel(const ReportSeries& series)
{
    if (series.pair_correlation.empty()) return false;
    const auto& bins = series.pair_correlation;
    const auto peak = *std::ranges::max_element(bins, {}, &PairCorrelationBin::value);
    const auto unit = max_min_distance(series.stored->points, series.run->dimension);
    const auto caption =
        fmt::format("Highest {} at {} of the largest possible minimum distance, {}.", format_significant(peak.value, 3),
                    format_fixed(peak.distance / unit, 2), format_significant(unit, 4));
    return picture_panel(series, {"pair-correlation.svg", "pair-correlation.png", "is_pairs"}, "Pair correlation",
                         caption);
}

PageData file_link(const std::string& text, const ReportSeries& series, const std::filesystem::path& file)
{
    PageData data;
    data.set("text", text);
    data.set("link", relative_link(series.pictures, file));
    return data;
}

PageData file_group(const std::string& title, const std::vector<PageData>& links, const std::string& more = {})
{
    PageData data;
    data.set("group", title);
    data.set("links", PageData(kainjow::mustache::list(links.begin(), links.end())));
    data.set("more", optional_text(more));
    return data;
}

// Pictures lie in the report's folder, stored results in the run's.
PageData file_groups(const ReportSeries& series)
{
    const auto& stored = *series.stored;
    const auto picture = [&](const std::string& text, const char* name) {
        return file_link(text, series, series.pictures / name);
    };
    const auto result = [&](const std::string& text, const std::string& name) {
        return file_link(text, series, series.run->folder / name);
    };
    const auto spectrum_links = [&] {
        std::vector<PageData> links = {result("exr", stored.spectrum_file), picture("png", "spectrum.png")};
        if (!stored.volume_file.empty()) links.push_back(result("volume exr", stored.volume_file));
        return links;
    };
    PageData groups{PageData::type::list};
    groups << file_group("Points", {picture("svg", "points.svg"), picture("png", "points.png")});
    if (series.cells) groups << file_group("Voronoi cells", {picture("svg", "cells.svg"), picture("png", "cells.png")});
    if (!stored.spectrum_file.empty()) groups << file_group(spectrum_word(series), spectrum_links());
    if (stored.has_spectrum()) {
        groups << file_group("Radially averaged power", {result("csv", stored.radial_file),
                                                         picture("svg", "radial.svg"), picture("png", "radial.png")});
        groups << file_group("Anisotropy", {result("csv", stored.radial_file), picture("svg", "anisotropy.svg"),
                                            picture("png", "anisotropy.png")});
    }

    if (!stored.pair_correlation_file.empty())
        groups << file_group("Pair correlation",
                             {result("csv", stored.pair_correlation_file), picture("svg", "pair-correlation.svg"),
                              picture("png", "pair-correlation.png")});

    if (stored.iterations)
        groups << file_group("Iterations", {result("csv", stored.iterations->file),
                                            picture("relative radius svg", "relative-radius.svg"),
                                            picture("png", "relative-radius.png"), picture("energy svg", "energy.svg"),
                                            picture("png", "energy.png")});

    if (stored.zone_plate)
        groups << file_group("Zone plate",
                             {result("exr", stored.zone_plate->file), picture("png", "zone-plate.png"),
                              result("error csv", stored.zone_plate->error_file),
                              picture("svg", "zone-plate-error.svg"), picture("png", "zone-plate-error.png")});

    std::vector<PageData> sets;
    for (const auto& file : stored.point_files)
        if (sets.size() < most_point_files_linked) sets.push_back(result(std::to_string(sets.size() + 1), file));
    const auto hidden = stored.point_files.size() - sets.size();
    groups << file_group("Point sets", sets, hidden > 0 ? fmt::format("and {} more", format_count(hidden)) : "");
    return groups;
}

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

PageData guide_kind(const std::string& kind)
{
    if (kind.empty()) return false;
    PageData data;
    data.set(kind, true);
    return data;
}

PageData picture_panel(const ReportSeries& series, const PanelPicture& picture, const std::string& title,
                       const std::string& caption)
{
    PageData data;
    data.set("title", title);
    data.set("caption", caption);
    data.set("alt", fmt::format("{}: {}. {}", series.label, title, caption));
    data.set("source", picture.shown);
    data.set("link", picture.linked);
    data.set("image_class", picture.image_class);
    data.set("figure_class", optional_text(picture.figure_class));
    data.set("guide_kind", guide_kind(picture.guide));
    for (const char* name : {"window", "spectrum_axis", "cell_key"}) data.set(name, false);
    return data;
}

namespace {

// The panels that a series has, in the order of the page.
PageData panels_of(const ReportSeries& series)
{
    PageData list{PageData::type::list};
    for (const auto panel :
         {points_panel, spectrum_panel, radial_panel, anisotropy_panel, pair_correlation_panel, cells_panel, cube_panel,
          slices_panel, close_ups_panel, relative_radius_panel, energy_panel, zone_plate_panel, zone_plate_error_panel})
        if (auto data = panel(series); !data.is_false()) list << data;
    return list;
}

PageData neighbour(const std::vector<ReportSeries>& all, std::size_t index, const std::filesystem::path& from)
{
    if (index >= all.size()) return false;
    PageData data;
    data.set("label", all[index].label);
    data.set("link", relative_link(from, page_of(all[index])));
    return data;
}

}

std::string render_series_page(const Site& site, const ReportRun& run, std::size_t index)
{
    const ReportSeries& series = run.series[index];
    auto data = series_identity(series, index);
    set_dimension_words(data, {&run});
    data.set("overview", relative_link(series.pictures, site.out / overview_page));
    data.set("run_link",
             site.has_several_runs() ? PageData(relative_link(series.pictures, page_of(run))) : PageData(false));
    data.set("previous", neighbour(run.series, index - 1, series.pictures)); // of the first there is none
    data.set("next", neighbour(run.series, index + 1, series.pictures));
    data.set("panels", panels_of(series));
    data.set("plate_reference", relative_link(series.pictures, run.root / zone_plate_reference_picture));
    data.set("tone_scale", series.stored->spectrum_file.empty() ? PageData(false) : tone_scale());
    data.set("relative_radius", shown_mean(series.stored->relative_radius, 4));
    data.set("min_distance", shown_mean(series.stored->min_distance, 4));
    data.set("measures", measures_list(series));
    data.set("file_groups", file_groups(series));
    set_provenance(data, *run.stored);
    return render_in_frame(site, {page_of(series), series.label + " · " + site.title, {}}, "series", data);
}

}
