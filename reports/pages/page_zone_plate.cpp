// The panels of the sampling test: the picture of the zone plate, and its error over frequency.
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

// "0.3035", and "(0.3021 to 0.3049)" where realizations differ visibly.
std::string with_range(const Statistic& value)
{
    const auto low = format_fixed(value.min, 4);
    const auto high = format_fixed(value.max, 4);
    const auto mean = format_fixed(value.mean, 4);
    return low == high ? mean : fmt::format("{} ({} to {})", mean, low, high);
}

}

PageData zone_plate_panel(const ReportSeries& series)
{
    if (!series.stored->zone_plate) return false;
    const auto side = format_count(static_cast<std::uint64_t>(series.stored->zone_plate->size));
    auto caption = fmt::format("{0} × {0} pixels, {1} samples", side, format_count(series.stored->points_of_first()));
    if (series.stored->realizations > 1)
        caption += fmt::format(" (first of {} realizations)", series.stored->realizations);
    return picture_panel(series, {"zone-plate.png", "zone-plate.png", "is_plate", "plate framed", "wide"}, "Zone plate",
                         caption + ".");
}

PageData zone_plate_error_panel(const ReportSeries& series)
{
    if (!series.stored->zone_plate) return false;
    const auto& plate = *series.stored->zone_plate;
    auto caption = fmt::format("RMS error {} over the picture", with_range(plate.rms_error));
    if (plate.resolved_rms_error)
        caption += fmt::format(", {} up to half a cycle per pixel", with_range(*plate.resolved_rms_error));
    return picture_panel(series, {"zone-plate-error.svg", "zone-plate-error.png", "is_plate_error"}, "Zone plate error",
                         caption + ".");
}

PageData zone_plate_reference_panel(const ReportRun& run, const std::filesystem::path& page_folder)
{
    const auto curves = zone_plate_curves(run.series);
    if (curves.empty()) return false;
    PageData data;
    const auto link = relative_link(page_folder, run.root / zone_plate_reference_picture);
    data.set("source", link);
    data.set("link", link);
    data.set("size", format_count(static_cast<std::uint64_t>(curves.front().size)));
    return data;
}

}
