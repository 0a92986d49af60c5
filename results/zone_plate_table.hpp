// zone-plate.csv: the error of a series' pictures of the zone plate, by distance from the origin.
#pragma once

#include "analysis/zone_plate/zone_plate_error.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// Reads columns distance,frequency,rms_error,pixels. Throws InputError with file and line.
std::vector<ErrorBin> read_zone_plate_table(const std::filesystem::path& path);

}
