// Point sets in a region of the plane, made elsewhere, as an experiment of one series.
#pragma once

#include "analysis/regions/framed_region.hpp"
#include "base/points/point_file.hpp"
#include "experiment/series/experiment.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

// Sentences on what was made of the files of the regions of an experiment.

/// Sentences on unions and on planes that longitude and latitude were mapped to, each once.
std::vector<std::string> region_notes(const Experiment& experiment);

/// Reads files as import_points() does, with coordinates in the region's units. Throws InputError that names the file
/// where points lie outside.
Experiment import_region_points(const std::vector<std::filesystem::path>& files, const std::string& label,
                                const FramedRegion& region, const PointReading& how = {});

}
