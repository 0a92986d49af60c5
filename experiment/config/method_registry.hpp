// The samplers that a [[method]] table can name, and the keys that each of these tables can have.
#pragma once

#include "host/settings/config_tree.hpp"
#include "host/settings/sampler_registry.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The keys of a [[method]] beside its sampler's parameters.
const std::vector<std::string>& method_keys();

/// True if [analysis] of a config, or one of its methods, has a region.
bool analysis_has_region(const ConfigTable& config);
bool some_method_has_region(const ConfigTable& config);

/// The samplers of a method: those in regions where the method or [analysis] has one, else those of `torus`.
const SamplerRegistry& registry_of(const ConfigTable& method, bool analysis_has_region, const SamplerRegistry& torus);

}
