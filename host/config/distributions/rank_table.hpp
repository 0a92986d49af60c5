// The keys of [[distribution]] with kind = "self-similar-tile" and "ranks".
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/distributions/distribution_config.hpp"

namespace poissonlab {

// Each fills settings, inputs and, where it is empty, the label, and throws InputError.
void read_self_similar_tile(const ConfigTable& table, DistributionConfig& config);
void read_ranks(const ConfigTable& table, DistributionConfig& config);

}
