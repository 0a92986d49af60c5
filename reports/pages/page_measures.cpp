// The measures of one series, each with its unit or scale and what it means.
#include "reports/pages/page_parts.hpp"
#include "reports/pages/ranking_columns.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

struct Measure
{
    std::string key;
    std::string name;
    std::string value;
    std::optional<double> exact = {};
    std::string error = {};
    std::string meaning = {};
};

PageData measure_data(const Measure& measure)
{
    PageData data;
    data.set("key", measure.key);
    data.set("name", measure.name);
    data.set("value", measure.value);
    data.set("exact", optional_text(measure.exact ? format_exact(*measure.exact) : ""));
    data.set("error", optional_text(measure.error));
    data.set("meaning", measure.meaning);
    return data;
}

// "disk 0.051, step 0.12"
std::string integrals_text(const std::vector<Measures::Integral>& integrals)
{
    std::string text;
    for (const auto& integral : integrals)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", integral.integrand,
                            format_significant(integral.relative_variance, 2));
    return text;
}

std::string plus_minus(double error) { return "± " + format_significant(error, 2); }

// The quantities that the ranking has as well, in the words that it has for them.
void add_ranked(const ReportSeries& series, PageData& list)
{
    for (const auto& column : ranking_columns()) {
        if (column.meaning.empty()) continue;
        const auto cell = column.cell(series);
        if (!cell) continue;
        const auto unit = column.unit.empty() ? "" : " (" + column.unit + ")";
        list << measure_data({column.key, column.title + unit, cell->shown, cell->value, cell->spread, column.meaning});
    }
}

void add_covered_fraction(const ReportSeries& series, PageData& list)
{
    const auto& covered = series.stored->covered_fraction;
    if (!covered) return;
    const bool space = series.run->dimension == 3;
    list << measure_data(
        {"covered_fraction", "Covered fraction", format_significant(covered->mean, 4), covered->mean,
         shown_range(*covered, 4),
         fmt::format("what {} around the points cover whose diameter is the minimum distance: at most {}",
                     space ? "balls" : "disks", space ? "0.740" : "0.907")});
}

void add_low_frequency_power(const Measures& measures, PageData& list)
{
    const auto& fit = measures.low_frequency_power;
    if (!fit) return;
    list << measure_data({"low_frequency_exponent", "Low-frequency exponent", format_fixed(fit->exponent, 3),
                          fit->exponent, plus_minus(fit->exponent_error),
                          "b in power ~ frequency^b: 0 for random points, above 0 errors of integrals fall faster"});
    list << measure_data({"low_frequency_intercept", "Power towards frequency 0", format_fixed(fit->intercept, 3),
                          fit->intercept, plus_minus(fit->intercept_error),
                          "1 for random points, 0.059 for saturated dart throwing: lower is better"});
}

void add_largest_peak(const Measures& measures, PageData& list)
{
    const auto& peaks = measures.lattice_peaks;
    if (!peaks) return;
    list << measure_data({"largest_lattice_peak", "Largest lattice peak", format_significant(peaks->max_ratio, 3),
                          peaks->max_ratio, "",
                          fmt::format("the largest of {} at multiples of frequency {}, over the power around it",
                                      format_count(static_cast<std::uint64_t>(peaks->peaks)), peaks->tiles)});
}

void add_plate_error(const ReportSeries& series, PageData& list)
{
    const auto& plate = series.stored->zone_plate;
    if (!plate) return;
    list << measure_data(
        {"zone_plate_rms_error", "Zone plate error, all of the picture (RMS, white is 1)",
         format_significant(plate->rms_error.mean, 4), plate->rms_error.mean, shown_range(plate->rms_error, 4),
         "most of the plate is finer than any set can follow, so that all sets have much the same error"});
}

void add_cells(const Measures& measures, PageData& list)
{
    const auto& cells = measures.voronoi;
    if (!cells) return;
    const auto& share = cells->neighbour_share;
    list << measure_data({"neighbours",
                          "Voronoi cells with 5, 6, 7 neighbours",
                          fmt::format("{} %, {} %, {} %", format_fixed(100 * share[1], 1),
                                      format_fixed(100 * share[2], 1), format_fixed(100 * share[3], 1)),
                          {},
                          "",
                          "100 % with 6 is a hexagonal lattice"});
    list << measure_data({"voronoi_area_variance", "Variance of Voronoi areas",
                          format_fixed(cells->relative_area_variance, 4), cells->relative_area_variance, "",
                          "over their squared mean: 0.280 for random points"});
}

}

PageData measures_list(const ReportSeries& series)
{
    const auto& measures = series.stored->measures;
    PageData list{PageData::type::list};
    add_ranked(series, list);
    add_covered_fraction(series, list);
    add_low_frequency_power(measures, list);
    add_largest_peak(measures, list);
    if (!measures.integration.empty())
        list << measure_data({"integration",
                              "Error of integrals",
                              integrals_text(measures.integration),
                              {},
                              "",
                              "mean squared error over that of as many random points: lower is better"});
    add_plate_error(series, list);
    add_cells(measures, list);
    return list;
}

}
