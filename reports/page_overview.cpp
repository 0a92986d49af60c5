// The overview table, and what identifies a series wherever it is mentioned.
#include "reports/number_format.hpp"
#include "reports/page_parts.hpp"
#include "reports/plot_style.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

enum class Notation
{
    fixed,
    significant
};

std::string format(double value, Notation notation, int digits)
{
    return notation == Notation::fixed ? format_fixed(value, digits) : format_significant(value, digits);
}

// A mean with its exact value for programs, and the range where realizations differ visibly.
PageData statistic(const std::optional<StoredStatistic>& value, Notation notation, int digits)
{
    if (!value) return false;
    PageData data;
    data.set("exact", format_exact(value->mean));
    data.set("mean", format(value->mean, notation, digits));
    const auto low = format(value->min, notation, digits);
    const auto high = format(value->max, notation, digits);
    data.set("range", low == high ? PageData(false) : PageData(low + " to " + high));
    return data;
}

PageData sample_time(const std::vector<double>& seconds)
{
    if (seconds.empty()) return false;
    const auto [low, high] = std::ranges::minmax(seconds);
    const double middle = median(seconds);
    PageData data;
    data.set("exact", format_exact(middle));
    data.set("median", format_seconds(middle));
    data.set("range", seconds.size() == 1 ? PageData(false)
                                          : PageData(format_seconds(low) + " to " + format_seconds(high)));
    return data;
}

std::string parameters_text(const NamedTexts& parameters)
{
    std::string text;
    for (const auto& [name, value] : parameters)
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, value);
    return text;
}

}

PageData optional_text(const std::string& text) { return text.empty() ? PageData(false) : PageData(text); }

/// "1,708 to 1,754" where realizations differ in size.
std::string points_range(const StoredSeries& series)
{
    if (series.points_each.empty()) return {};
    const auto [fewest, most] = std::ranges::minmax_element(series.points_each);
    return fmt::format("{} to {}", format_count(*fewest), format_count(*most));
}

PageData series_identity(const ReportSeries& series, std::size_t index)
{
    PageData data;
    data.set("label", series.label);
    data.set("anchor", fmt::format("series-{}", index + 1));
    data.set("color", curve_color(index));
    data.set("sampler", series.stored->sampler);
    data.set("parameters", optional_text(parameters_text(series.stored->parameters)));
    data.set("points", format_count(series.stored->points));
    data.set("points_range", optional_text(points_range(*series.stored)));
    data.set("realizations", format_count(static_cast<std::uint64_t>(series.stored->realizations)));
    data.set("device", optional_text(series.run->machine_member("device")));
    return data;
}

PageData overview_row(const ReportSeries& series, std::size_t index)
{
    auto data = series_identity(series, index);
    const auto& stored = *series.stored;
    data.set("relative_radius", statistic(stored.relative_radius, Notation::fixed, 4));
    data.set("min_distance", statistic(stored.min_distance, Notation::significant, 4));
    data.set("covered_fraction", statistic(stored.covered_fraction, Notation::fixed, 4));
    const auto plate = stored.zone_plate.value_or(StoredZonePlate{});
    data.set("plate_error",
             stored.zone_plate ? statistic(plate.rms_error, Notation::fixed, 4) : PageData(false));
    data.set("plate_resolved_error", statistic(plate.resolved_rms_error, Notation::fixed, 4));
    data.set("sample_time", sample_time(stored.sample_seconds));
    if (stored.relative_radius)
        data.set("radius_percent",
                 fmt::format("{:.1f}", 100 * std::clamp(stored.relative_radius->mean, 0.0, 1.0)));
    return data;
}

}
