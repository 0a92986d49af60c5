// Words, numbers and files about points in regions: their curves, and minimum distances that vary.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/regions/plane_region.hpp"
#include "host/distribution/regions/region_darts.hpp"
#include "results/pictures/distribution_files.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// A sentence that says which distances points keep, and how near the nearest two of all pairs are.
std::string words_of_varied(const VariedSet& set);

/// Scale, slope, distances, and what was found in all pairs.
void append_varied_numbers(const VariedSet& set, DistributionNumbers& numbers);

/// The distance at each point, in units of the region: a NumPy array of doubles.
void write_distances(const std::filesystem::path& file, const VariedSet& set);

/// Adds region.csv, as analyses have it, and the numbers that say how it was made: of two points or more, up to
/// 300,000; up to 5,000, with the bands of random sets. Points are in the region's units.
void add_region_curves(const PlaneRegion& region, const PointSet& points, DistributionFiles& files,
                       DistributionResult& result);

}
