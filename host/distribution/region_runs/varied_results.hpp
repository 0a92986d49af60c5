// Words, numbers and files about points whose minimum distance varies.
#pragma once

#include "host/distribution/regions/region_darts.hpp"
#include "results/pictures/distribution_result.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// A sentence that says which distances points keep, and how near the nearest two of all pairs are.
std::string words_of_varied(const VariedSet& set);

/// Scale, slope, distances, and what was found in all pairs.
void append_varied_numbers(const VariedSet& set, DistributionNumbers& numbers);

/// The distance at each point, in units of the region: a NumPy array of doubles.
void write_distances(const std::filesystem::path& file, const VariedSet& set);

}
