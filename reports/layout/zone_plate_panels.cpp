// The pictures of the sampling test: the zone plate that a set sees, and its error.
#include "reports/layout/series_panels.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

/// "0.3035", and "(0.3021 to 0.3049)" where realizations differ visibly.
std::string with_range(const Statistic& value)
{
    const auto low = format_fixed(value.min, 4);
    const auto high = format_fixed(value.max, 4);
    const auto mean = format_fixed(value.mean, 4);
    return low == high ? mean : fmt::format("{} ({} to {})", mean, low, high);
}

Panel plate_panel(const ReportRun& run, const ReportSeries& series)
{
    const auto& plate = *series.stored->zone_plate;
    const auto file = series.run->folder / plate.file;
    const auto reference = (run.root / zone_plate_reference_picture).lexically_relative(series.pictures);
    return {.stem = "zone-plate",
            .picture = ZonePlatePicture{file, plate.size},
            .title = "Zone plate",
            .caption =
                fmt::format("{0} × {0} pixels, {1} samples{2}.", format_count(static_cast<std::uint64_t>(plate.size)),
                            format_count(series.stored->points_of_first()), first_of_several(series)),
            .guide = fmt::format(
                "Rings that become finer with the distance from the lower left corner, sampled by the set. A "
                "good set keeps the rings clear far out, and shows even grey noise beyond. Rings around "
                "other places are aliases, which regular sets produce. Compare with <a href=\"{}\">what "
                "perfect sampling gives</a>. A picture that is shown smaller than it is has false rings as "
                "well; full size is one click away.",
                reference.generic_string()),
            .stored = {{"exr", file}},
            .thumbnail = Thumbnail{"plate", "Zone plate"},
            .image_class = "plate framed",
            .figure_class = "wide"};
}

Panel plate_error_panel(const ReportSeries& series, std::size_t index, const RunPlots& plots)
{
    const auto& plate = *series.stored->zone_plate;
    auto caption = fmt::format("RMS error {} over the picture", with_range(plate.rms_error));
    if (plate.resolved_rms_error)
        caption += fmt::format(", {} up to half a cycle per pixel", with_range(*plate.resolved_rms_error));
    return {.stem = "zone-plate-error",
            .picture = zone_plate_alone(*plots.plate, index, plate.size),
            .title = "Zone plate error",
            .caption = caption + ".",
            .guide = "The root mean square difference from perfect sampling, against the fineness of the rings. The "
                     "curve leaves 0 where the set begins to fail; half a cycle per pixel (dotted) is the finest that "
                     "pixels can show. Values are means over the <i>K</i> sets.",
            .stored = {{"csv", series.run->folder / plate.error_file}}};
}

}

void add_zone_plate_panels(const ReportRun& run, std::size_t index, const RunPlots& plots, std::vector<Panel>& panels)
{
    const ReportSeries& series = run.series[index];
    if (!series.stored->zone_plate) return;
    panels.push_back(plate_panel(run, series));
    panels.push_back(plate_error_panel(series, index, plots));
}

}
