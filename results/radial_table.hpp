// radial.csv: radially averaged power and anisotropy of a series.
#pragma once

#include "analysis/spectra/radial_statistics.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The text of the table, numbers in their shortest exact form.
std::string radial_csv(const std::vector<RadialBin>& bins);

/// Reads columns frequency,power,anisotropy_db,samples,power_error. Anisotropy may be inf or nan (an annulus without
/// power). Throws InputError with file and line.
std::vector<RadialBin> read_radial_table(const std::filesystem::path& path);

/// The bin of the highest power. `bins` must not be empty.
RadialBin peak_power(const std::vector<RadialBin>& bins);

}
