// The table [[distribution]] of a config: points and objects that follow a density, and what they are made from.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapter 7 and section 4.7.
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/distributions/distribution_config.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The words for the key `kind`, the default first.
const std::vector<std::string>& distribution_kinds();

/// Reads and checks such tables. `seed`: of the config. Throws InputError with the place of what is wrong.
std::vector<DistributionConfig> read_distributions(const std::vector<ConfigNode>& tables, std::uint64_t seed);

/// The same for the tables [[scheme]]: see host/config/schemes.
std::vector<DistributionConfig> read_schemes(const std::vector<ConfigNode>& tables, std::uint64_t seed);

}
