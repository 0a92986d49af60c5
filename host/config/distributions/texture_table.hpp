// The tables [[texture]] of a config: texture tiles from a picture.
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/distributions/distribution_config.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The words for the key `show`, in the order in which they are shown.
const std::vector<std::string>& texture_shows();

/// Reads and checks such tables. Pictures are named relative to the config's folder. Throws InputError with the place
/// of what is wrong.
std::vector<DistributionConfig> read_textures(const std::vector<ConfigNode>& tables, std::uint64_t seed);

}
