#include "reports/pages/ranking_columns.hpp"

#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

using Cell = std::optional<RankingCell>;

std::string plus_minus(const std::optional<double>& error)
{
    return error ? "± " + format_significant(*error, 2) : std::string();
}

Cell statistic(const std::optional<Statistic>& value)
{
    if (!value) return std::nullopt;
    return RankingCell{value->mean, format_significant(value->mean, 4), shown_range(*value, 4)};
}

Cell points(const ReportSeries& series)
{
    const auto& each = series.stored->points_each;
    std::string range;
    if (!each.empty()) {
        const auto [low, high] = std::ranges::minmax(each);
        range = format_count(low) + " to " + format_count(high);
    }
    return RankingCell{static_cast<double>(series.stored->points), format_count(series.stored->points), range};
}

Cell realizations(const ReportSeries& series)
{
    const auto count = static_cast<std::uint64_t>(series.stored->realizations);
    return RankingCell{static_cast<double>(count), format_count(count), ""};
}

Cell largest_empty(const ReportSeries& series)
{
    const auto& value = series.stored->measures.largest_empty_radius;
    if (!value) return std::nullopt;
    return RankingCell{*value, format_significant(*value, 4), ""};
}

Cell oscillation(const ReportSeries& series)
{
    const auto& value = series.stored->measures.oscillation;
    if (!value) return std::nullopt;
    return RankingCell{value->value, format_significant(value->value, 3), plus_minus(value->standard_error)};
}

Cell effective_nyquist(const ReportSeries& series)
{
    const auto& measures = series.stored->measures;
    if (!measures.effective_nyquist) return std::nullopt;
    return RankingCell{*measures.effective_nyquist, format_significant(*measures.effective_nyquist, 3),
                       plus_minus(measures.effective_nyquist_error)};
}

Cell peak_anisotropy(const ReportSeries& series)
{
    const auto& peak = series.stored->measures.peak_anisotropy;
    if (!peak) return std::nullopt;
    return RankingCell{peak->db, format_fixed(peak->db, 1), plus_minus(peak->standard_error_db)};
}

Cell lattice_peaks(const ReportSeries& series)
{
    const auto& peaks = series.stored->measures.lattice_peaks;
    if (!peaks) return std::nullopt;
    return RankingCell{peaks->mean_ratio, format_significant(peaks->mean_ratio, 3),
                       plus_minus(peaks->mean_ratio_error)};
}

Cell zone_plate_error(const ReportSeries& series)
{
    const auto& plate = series.stored->zone_plate;
    return plate ? statistic(plate->resolved_rms_error) : std::nullopt;
}

Cell build_time(const ReportSeries& series)
{
    const auto& set = series.stored->tile_set;
    if (!set || !set->build_seconds) return std::nullopt;
    return RankingCell{*set->build_seconds, format_seconds(*set->build_seconds), set->cached ? "earlier" : ""};
}

Cell sample_time(const ReportSeries& series)
{
    const auto& seconds = series.stored->sample_seconds;
    if (seconds.empty()) return std::nullopt;
    const auto [low, high] = std::ranges::minmax(seconds);
    const double middle = median(seconds);
    return RankingCell{middle, format_seconds(middle),
                       seconds.size() == 1 ? "" : format_seconds(low) + " to " + format_seconds(high)};
}

Cell points_per_second(const ReportSeries& series)
{
    const auto time = sample_time(series);
    if (!time || time->value <= 0) return std::nullopt;
    const double rate = static_cast<double>(series.stored->points) / time->value;
    return RankingCell{rate, format_significant(rate / 1e6, 3), ""};
}

}

const std::vector<RankingColumn>& ranking_columns()
{
    static const std::vector<RankingColumn> columns = {
        {"points", "Points N", "", Better::neither, false, "", points},
        {"realizations", "Sets K", "", Better::neither, false, "", realizations},
        {"relative_radius", "Relative radius ρ", "of the largest possible distance", Better::higher, false,
         "The smallest distance between two points, over the largest that so many points could keep: 0 for random "
         "points, 1 for a perfect lattice. Good sets reach 0.65 to 0.85; above that, points fall into rows. Dart "
         "throwing of many points cannot pass 0.777 in 2D and 0.804 in 3D. The mean over the K sets, and from the "
         "smallest to the largest.",
         [](const ReportSeries& series) { return statistic(series.stored->relative_radius); }},
        {"min_distance", "Minimum distance", "of the torus' side", Better::higher, false,
         "The same distance as it is: twice the radius of the disks (3D: spheres). It compares between sets of the "
         "same number of points.",
         [](const ReportSeries& series) { return statistic(series.stored->min_distance); }},
        {"largest_empty", "Largest empty circle", "radius, of the largest possible distance", Better::lower, false,
         "The largest circle (3D: ball) without a point inside, of the first realization: at least 0.577 in 2D. A gap "
         "above the relative radius has room for another point.",
         largest_empty},
        {"oscillation", "Oscillation", "power", Better::lower, false,
         "How much the power goes up and down beyond its first rise, with its standard error.", oscillation},
        {"effective_nyquist", "Effective Nyquist", "√N / 2 (3D: ∛N / 2)", Better::higher, false,
         "The frequency up to which the mean power stays below 0.1, with its standard error: what lies below it is "
         "sampled almost without noise.",
         effective_nyquist},
        {"peak_anisotropy", "Peak anisotropy", "dB", Better::lower, false,
         "The largest anisotropy of a ring of at least 100 samples, with its standard error: chance alone stays near "
         "−10 log₁₀ K dB, grids and repeated tiles rise far above it.",
         peak_anisotropy},
        {"lattice_peaks", "Lattice peaks", "power over that around", Better::lower, false,
         "Mean power at the frequencies at which tiles repeat, over the power around them, with its standard error: 1 "
         "where tiles leave no trace.",
         lattice_peaks},
        {"zone_plate_error", "Zone plate error", "RMS, white is 1", Better::lower, false,
         "The root mean square difference between the zone plate as the set samples it, one sample a pixel, and as it "
         "is with infinitely many samples, over the part that pixels can show. Errors do not tell noise from false "
         "patterns, which disturb more: regular points have small ones here, and rings that are not there in the "
         "picture.",
         zone_plate_error},
        {"build_time", "Time to build", "tile set", Better::lower, true,
         "What the tile set takes to build, once for all tilings. “Earlier”: it was built by an earlier run, and that "
         "time was kept.",
         build_time},
        {"sample_time", "Time to generate", "a set, median", Better::lower, true,
         "The median over the timed runs, without building kernels and tile sets, and from the shortest to the "
         "longest.",
         sample_time},
        {"points_per_second", "Points per second", "millions", Better::higher, true,
         "Points of a set over the median time.", points_per_second},
    };
    return columns;
}

std::vector<const RankingColumn*> columns_of(const std::vector<const ReportSeries*>& series)
{
    std::vector<const RankingColumn*> result;
    for (const auto& column : ranking_columns())
        if (std::ranges::any_of(series, [&](const auto* entry) { return column.cell(*entry).has_value(); }))
            result.push_back(&column);
    return result;
}

}
