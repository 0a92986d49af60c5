#include "results/curve_tables.hpp"

#include "base/errors/errors.hpp"
#include "base/files/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

constexpr const char* radial_header = "frequency,power,anisotropy_db,samples,power_error";
constexpr const char* pair_correlation_header = "distance,pair_correlation,standard_error,pairs";
constexpr const char* number_variance_header = "radius,points,variance,standard_error";
constexpr const char* region_curves_header = "distance,k_isotropic,pair_correlation,pair_correlation_low,pair_"
                                             "correlation_high,k,k_low,k_high,nearest,nearest_low,"
                                             "nearest_high,empty_space,empty_space_low,empty_space_high,j,j_low,j_high";
constexpr const char* zone_plate_header = "distance,frequency,rms_error,pixels";

/// A line for each bin, with the numbers that `row` makes a tuple of.
template <class Bin, class Row>
std::string csv(const char* header, const std::vector<Bin>& bins, Row row)
{
    std::string text = fmt::format("{}\n", header);
    for (const Bin& bin : bins) text += fmt::format("{}\n", fmt::join(row(bin), ","));
    return text;
}

double finite(double number, const std::filesystem::path& path, std::size_t row, const char* column)
{
    if (!std::isfinite(number))
        throw InputError(fmt::format("{}:{}: {} = {}: must be finite", path.string(), row + 2, column, number));
    return number;
}

}

std::string radial_csv(const std::vector<RadialBin>& bins)
{
    return csv(radial_header, bins, [](const RadialBin& bin) {
        return std::tuple(bin.frequency, bin.power, bin.anisotropy_db, bin.samples, bin.power_error);
    });
}

std::string pair_correlation_csv(const std::vector<PairCorrelationBin>& bins)
{
    return csv(pair_correlation_header, bins, [](const PairCorrelationBin& bin) {
        return std::tuple(bin.distance, bin.value, bin.standard_error, bin.pairs);
    });
}

std::string number_variance_csv(const std::vector<NumberVarianceBin>& bins)
{
    return csv(number_variance_header, bins, [](const NumberVarianceBin& bin) {
        return std::tuple(bin.radius, bin.points, bin.variance, bin.standard_error);
    });
}

std::string region_curves_csv(const std::vector<RegionCurveRow>& rows)
{
    std::string text = fmt::format("{}\n", region_curves_header);
    for (const RegionCurveRow& row : rows) {
        text += fmt::format("{},{}", row.distance, row.k_isotropic);
        for (std::size_t f = 0; f < region_functions; ++f)
            text += fmt::format(",{},{},{}", row.value[f], row.low[f], row.high[f]);
        text += '\n';
    }
    return text;
}

std::string zone_plate_csv(const std::vector<ErrorBin>& bins)
{
    return csv(zone_plate_header, bins,
               [](const ErrorBin& bin) { return std::tuple(bin.distance, bin.frequency, bin.rms_error, bin.pixels); });
}

std::vector<RadialBin> read_radial_table(const std::filesystem::path& path)
{
    std::vector<RadialBin> bins;
    for (const auto& row : read_number_table(path, radial_header, "frequencies"))
        bins.push_back({row[0], row[1], row[2], table_count(row[3], path, bins.size(), "samples"), row[4]});
    return bins;
}

std::vector<PairCorrelationBin> read_pair_correlation_table(const std::filesystem::path& path)
{
    std::vector<PairCorrelationBin> bins;
    for (const auto& row : read_number_table(path, pair_correlation_header, "distances"))
        bins.push_back({row[0], row[1], finite(row[2], path, bins.size(), "standard_error"),
                        finite(row[3], path, bins.size(), "pairs")});
    return bins;
}

std::vector<NumberVarianceBin> read_number_variance_table(const std::filesystem::path& path)
{
    std::vector<NumberVarianceBin> bins;
    for (const auto& row : read_number_table(path, number_variance_header, "radii"))
        bins.push_back({row[0], finite(row[1], path, bins.size(), "points"),
                        finite(row[2], path, bins.size(), "variance"),
                        finite(row[3], path, bins.size(), "standard_error")});
    return bins;
}

std::vector<RegionCurveRow> read_region_curves(const std::filesystem::path& path)
{
    std::vector<RegionCurveRow> rows;
    for (const auto& numbers : read_number_table(path, region_curves_header, "distances")) {
        RegionCurveRow& row = rows.emplace_back();
        row.distance = numbers[0];
        row.k_isotropic = numbers[1];
        for (std::size_t f = 0; f < region_functions; ++f) {
            row.value[f] = numbers[2 + 3 * f];
            row.low[f] = numbers[3 + 3 * f];
            row.high[f] = numbers[4 + 3 * f];
        }
    }
    return rows;
}

std::vector<ErrorBin> read_zone_plate_table(const std::filesystem::path& path)
{
    std::vector<ErrorBin> bins;
    for (const auto& row : read_number_table(path, zone_plate_header, "distances"))
        bins.push_back({row[0], row[1], finite(row[2], path, bins.size(), "rms_error"),
                        table_count(row[3], path, bins.size(), "pixels")});
    return bins;
}

RadialBin peak_power(const std::vector<RadialBin>& bins)
{
    return *std::ranges::max_element(bins, {}, &RadialBin::power);
}

}
