// The keys of [[distribution]] with kind = "instances".
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/distributions/distribution_config.hpp"

#include <string>
#include <vector>

namespace poissonlab {

inline constexpr std::uint32_t most_models = 65'536;

/// The scenes that instances are for, the default first.
const std::vector<std::string>& instance_scenes();

/// Densities, models and looks of a scene, over one unit square.
InstanceSettings scene_settings(const std::string& scene);

/// Throws InputError, a sentence, where settings ask for more instances than a file should hold, or have a ring that is
/// none.
void check_instances(const InstanceSettings& settings);

/// Fills settings, inputs and, where it is empty, the label. Throws InputError.
void read_instances(const ConfigTable& table, DistributionConfig& config);

}
