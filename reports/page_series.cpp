// One series' section of the page: panels, their captions, and the stored files.
#include "geometry/relative_radius.hpp"
#include "reports/embedding.hpp"
#include "reports/number_format.hpp"
#include "reports/page_parts.hpp"
#include "reports/radial_table.hpp"
#include "reports/series_pictures.hpp"
#include "reports/spectrum_image.hpp"

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

PageData points_panel(const ReportSeries& series, const std::filesystem::path& out)
{
    const auto& view = series.view;
    const auto side = format_significant(view.window, 2);
    std::string part = fmt::format("All {} points", format_count(view.total));
    if (view.shown() != view.total)
        part = fmt::format("{} of {} points", format_count(view.shown()), format_count(view.total));
    if (series.run->dimension == 3)
        part +=
            fmt::format(": a slab of the cube, z below {}, seen along z", format_significant(view.depth, 2));
    if (view.window < 1) part += fmt::format(": the window of {} × {} at the lower left", side, side);
    if (series.stored->realizations > 1)
        part += fmt::format(" (first of {} realizations)", series.stored->realizations);
    auto data = picture_panel(series, out, "points.svg", "points.png", "Points", part + ".");
    data.set("window", side);
    return data;
}

// Ticks at plus and minus the principal frequency, in percent of the picture's width.
PageData principal_ticks(const Curve& curve, int size)
{
    PageData ticks{PageData::type::list};
    if (!curve.principal_frequency || *curve.principal_frequency >= size / 2) return ticks;
    for (const double sign : {-1.0, 1.0})
        ticks << PageData(
            "percent",
            fmt::format("{:.2f}", 100 * (size / 2 + 0.5 + sign * *curve.principal_frequency) / size));
    return ticks;
}

std::string spectrum_caption(const ReportSeries& series)
{
    const int size = series.stored->spectrum_size;
    const auto side = format_count(static_cast<std::uint64_t>(size));
    const bool planes = series.run->dimension == 3;
    auto caption = series.stored->is_estimate
                       ? fmt::format("Mean of {} periodograms of", series.stored->realizations)
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

PageData spectrum_panel(const ReportSeries& series, const std::filesystem::path& out)
{
    if (series.stored->spectrum_file.empty()) return false;
    auto data = picture_panel(series, out, "spectrum-small.png", "spectrum.png", spectrum_word(series),
                              spectrum_caption(series));
    data.set("spectrum_axis", spectrum_axis(series));
    return data;
}

PageData cube_panel(const ReportSeries& series, const std::filesystem::path& out)
{
    if (series.run->dimension == 2 || series.stored->spectrum_file.empty()) return false;
    return picture_panel(series, out, "spectrum-cube.png", "spectrum-cube.png", "Cube of frequencies",
                         "x to the lower left, y to the lower right, z upwards; the eighth where all are positive is cut "
                         "away down to frequency 0.");
}

PageData slices_panel(const ReportSeries& series, const std::filesystem::path& out)
{
    if (series.run->dimension == 2 || series.stored->spectrum_file.empty()) return false;
    const auto slices = spectrum_slices(series);
    if (slices.empty()) return false;
    return picture_panel(series, out, "spectrum-slices.png", "spectrum-slices.png", "Slices",
                         fmt::format("Planes where the frequency along z is {}.", fmt::join(slices, ", ")));
}

PageData close_ups_panel(const ReportSeries& series, const std::filesystem::path& out)
{
    if (series.run->dimension == 2 || series.stored->spectrum_file.empty()) return false;
    const int reach = std::max(1, 5 * series.stored->spectrum_size / 16);
    return picture_panel(series, out, "spectrum-close-ups.png", "spectrum-close-ups.png", "Close-ups",
                         fmt::format("The middle of the planes through frequency 0, from {} to {}.",
                                     format_fixed(-reach, 0), format_fixed(reach - 1, 0)));
}

PageData radial_panel(const ReportSeries& series, const std::filesystem::path& out)
{
    const auto& curve = series.curve;
    const auto peak = peak_power(curve.bins);
    auto caption = fmt::format("Highest {} at frequency {}. ", format_significant(peak.power, 3),
                               format_exact(peak.frequency));
    if (!curve.principal_frequency)
        caption += "There is no principal frequency.";
    else
        caption += fmt::format("Principal frequency {}{}.", format_significant(*curve.principal_frequency, 4),
                               *curve.principal_frequency > curve.max_frequency ? ", beyond the axis" : "");
    return picture_panel(series, out, "radial.svg", "radial.png", "Radially averaged power", caption);
}

PageData anisotropy_panel(const ReportSeries& series, const std::filesystem::path& out)
{
    const auto& curve = series.curve;
    return picture_panel(
        series, out, "anisotropy.svg", "anisotropy.png", "Anisotropy",
        fmt::format("Dashed: what noise alone gives, −10 log₁₀ K = {} dB for K\u00a0=\u00a0{}.",
                    format_fixed(curve.background_db, 1), curve.realizations));
}

PageData pair_correlation_panel(const ReportSeries& series, const std::filesystem::path& out)
{
    if (series.pair_correlation.empty()) return false;
    const auto& bins = series.pair_correlation;
    const auto peak = *std::ranges::max_element(bins, {}, &PairCorrelationBin::value);
    const auto unit = max_min_distance(series.stored->points, series.run->dimension);
    const auto caption = fmt::format("Highest {} at {} of the largest possible minimum distance, {}.",
                                     format_significant(peak.value, 3), format_fixed(peak.distance / unit, 2),
                                     format_significant(unit, 4));
    return picture_panel(series, out, "pair-correlation.svg", "pair-correlation.png", "Pair correlation", caption);
}

PageData file_link(const std::string& text, const std::filesystem::path& out,
                   const std::filesystem::path& file)
{
    PageData data;
    data.set("text", text);
    data.set("link", relative_link(out, file));
    return data;
}

PageData file_group(const std::string& title, const std::vector<PageData>& links,
                    const std::string& more = {})
{
    PageData data;
    data.set("group", title);
    data.set("links", PageData(kainjow::mustache::list(links.begin(), links.end())));
    data.set("more", optional_text(more));
    return data;
}

// Pictures lie in the report's folder, stored results in the run's.
PageData file_groups(const ReportSeries& series, const std::filesystem::path& out)
{
    const auto& stored = *series.stored;
    const auto picture = [&](const std::string& text, const char* name) {
        return file_link(text, out, series.pictures / name);
    };
    const auto result = [&](const std::string& text, const std::string& name) {
        return file_link(text, out, series.run->folder / name);
    };
    const auto spectrum_links = [&] {
        std::vector<PageData> links = {result("exr", stored.spectrum_file), picture("png", "spectrum.png")};
        if (!stored.volume_file.empty()) links.push_back(result("volume exr", stored.volume_file));
        return links;
    };
    PageData groups{PageData::type::list};
    groups << file_group("Points", {picture("svg", "points.svg"), picture("png", "points.png")});
    if (!stored.spectrum_file.empty())
        groups << file_group(spectrum_word(series), spectrum_links());
    groups << file_group(
        "Radially averaged power",
        {result("csv", stored.radial_file), picture("svg", "radial.svg"), picture("png", "radial.png")});
    groups << file_group("Anisotropy", {result("csv", stored.radial_file), picture("svg", "anisotropy.svg"),
                                        picture("png", "anisotropy.png")});

    if (!stored.pair_correlation_file.empty())
        groups << file_group("Pair correlation", {result("csv", stored.pair_correlation_file),
                                                  picture("svg", "pair-correlation.svg"),
                                                  picture("png", "pair-correlation.png")});

    if (stored.iterations)
        groups << file_group("Iterations",
                             {result("csv", stored.iterations->file),
                              picture("relative radius svg", "relative-radius.svg"),
                              picture("png", "relative-radius.png"), picture("energy svg", "energy.svg"),
                              picture("png", "energy.png")});

    if (stored.zone_plate)
        groups << file_group(
            "Zone plate", {result("exr", stored.zone_plate->file), picture("png", "zone-plate.png"),
                           result("error csv", stored.zone_plate->error_file),
                           picture("svg", "zone-plate-error.svg"), picture("png", "zone-plate-error.png")});

    std::vector<PageData> sets;
    for (const auto& file : stored.point_files)
        if (sets.size() < most_point_files_linked)
            sets.push_back(result(std::to_string(sets.size() + 1), file));
    const auto hidden = stored.point_files.size() - sets.size();
    groups << file_group("Point sets", sets,
                         hidden > 0 ? fmt::format("and {} more", format_count(hidden)) : "");
    return groups;
}

}

PageData picture_panel(const ReportSeries& series, const std::filesystem::path& out, const std::string& shown,
                       const std::string& linked, const std::string& title, const std::string& caption)
{
    PageData data;
    data.set("title", title);
    data.set("caption", caption);
    data.set("alt", fmt::format("{}: {}. {}", series.label, title, caption));
    data.set("source", data_uri(series.pictures / shown));
    data.set("link", relative_link(out, series.pictures / linked));
    return data;
}

PageData series_section(const ReportSeries& series, std::size_t index, const std::filesystem::path& out)
{
    auto data = overview_row(series, index);
    data.set("points_panel", points_panel(series, out));
    data.set("spectrum_panel", spectrum_panel(series, out));
    data.set("cube_panel", cube_panel(series, out));
    data.set("slices_panel", slices_panel(series, out));
    data.set("close_ups_panel", close_ups_panel(series, out));
    data.set("radial_panel", radial_panel(series, out));
    data.set("anisotropy_panel", anisotropy_panel(series, out));
    data.set("pair_correlation_panel", pair_correlation_panel(series, out));
    data.set("relative_radius_panel", relative_radius_panel(series, out));
    data.set("energy_panel", energy_panel(series, out));
    data.set("zone_plate_panel", zone_plate_panel(series, out));
    data.set("zone_plate_error_panel", zone_plate_error_panel(series, out));
    data.set("measures", measures_list(series.stored->measures));
    data.set("file_groups", file_groups(series, out));
    return data;
}

}
