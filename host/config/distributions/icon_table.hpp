// The keys of [[distribution]] with kind = "icons".
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/distributions/distribution_config.hpp"

namespace poissonlab {

/// Fills settings, inputs and, where it is empty, the label. Throws InputError.
void read_icons(const ConfigTable& table, DistributionConfig& config);

}
