// The point sets of a series, as an output folder has them.
#pragma once

#include "base/geometry/point_set.hpp"
#include "results/series.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// Reads a file of a series: sets in the unit square or cube or, where it is one in a region, in the region's units.
/// Throws InputError.
std::vector<PointSet> read_stored_points(const Series& series, const std::filesystem::path& file);

}
