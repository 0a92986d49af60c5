// The tables [[packing]] of a config: all tiles of a set on a torus, and what is made of them.
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/distributions/distribution_config.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The words for the key `method`, the default first.
const std::vector<std::string>& packing_words();

/// The words for the key `show`, the default first: "tiles"; "puzzle"; of rows of tiles "dominoes", "graph" and "row".
const std::vector<std::string>& packing_shows();

/// Reads and checks such tables. Throws InputError with the place of what is wrong.
std::vector<DistributionConfig> read_packings(const std::vector<ConfigNode>& tables, std::uint64_t seed);

}
