// The curves of a series: radial.csv, pair-correlation.csv, number-variance.csv, region.csv and zone-plate.csv, numbers
// in their shortest exact form.
#pragma once

#include "analysis/measures/number_variance.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "analysis/regions/region_curve_row.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/zone_plate/zone_plate_error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Columns frequency,power,anisotropy_db,samples,power_error. Anisotropy may be inf or nan (an annulus without power).
std::string radial_csv(const std::vector<RadialBin>& bins);

/// Columns distance,pair_correlation,standard_error,pairs.
std::string pair_correlation_csv(const std::vector<PairCorrelationBin>& bins);

/// Columns radius,points,variance,standard_error.
std::string number_variance_csv(const std::vector<NumberVarianceBin>& bins);

/// Columns distance,k_isotropic, and of each of pair_correlation, k, nearest, empty_space and j the value and the
/// envelope, from _low to _high. Numbers other than the distance may be nan.
std::string region_curves_csv(const std::vector<RegionCurveRow>& rows);

/// Columns distance,frequency,rms_error,pixels.
std::string zone_plate_csv(const std::vector<ErrorBin>& bins);

/// These read what those wrote. Each throws InputError with file and line.
std::vector<RadialBin> read_radial_table(const std::filesystem::path& path);
std::vector<PairCorrelationBin> read_pair_correlation_table(const std::filesystem::path& path);
std::vector<NumberVarianceBin> read_number_variance_table(const std::filesystem::path& path);
std::vector<RegionCurveRow> read_region_curves(const std::filesystem::path& path);
std::vector<ErrorBin> read_zone_plate_table(const std::filesystem::path& path);

/// The bin of the highest power. `bins` must not be empty.
RadialBin peak_power(const std::vector<RadialBin>& bins);

}
