// zone-plate.csv: the error of a series' pictures of the zone plate, by distance from the origin.
#pragma once

#include "analysis/zone_plate/zone_plate_error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The text of the table, numbers in their shortest exact form.
std::string zone_plate_csv(const std::vector<ErrorBin>& bins);

/// Reads columns distance,frequency,rms_error,pixels. Throws InputError with file and line.
std::vector<ErrorBin> read_zone_plate_table(const std::filesystem::path& path);

}
