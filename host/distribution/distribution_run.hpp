// Makes what the tables [[distribution]], [[texture]] and [[packing]] of a config ask for: points, objects and tiles
// with their pictures and measures.
#pragma once

#include "host/config/distributions/distribution_config.hpp"
#include "host/distribution/distribution_place.hpp"
#include "host/distribution/even_points.hpp"
#include "results/pictures/distribution_files.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// Makes one distribution and writes its files. The result has no name and no label; names of files are without folder.
/// Throws InputError where it cannot be made, and StorageError.
DistributionResult make_distribution(const DistributionConfig& config, const DistributionPlace& place,
                                     DistributionFiles& files);

/// The density that a config's choice says; formulas are over a square.
Density chosen_density(const DensityChoice& choice);

/// The method of even points that it says. Reads the tile set's file.
EvenMethod chosen_method(const EvenMethodChoice& choice);

/// "corner-tiles" or the file's name, for facts.
std::string method_words(const EvenMethodChoice& choice);

// One function a kind, each in a file of the folder runs.
DistributionResult make_texture(const TextureSettings& settings, const DistributionPlace& place,
                                DistributionFiles& files);
DistributionResult make_packing(const PackingSettings& settings, DistributionFiles& files);

}
