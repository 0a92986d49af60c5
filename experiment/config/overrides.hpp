// `--set key=value`: changes to a config from the command line, before anything is checked.
#pragma once

#include "host/settings/config_tree.hpp"
#include "host/settings/sampler_registry.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// Applies overrides in order. Keys are dotted: `seed=2`, `analysis.points=4096`,
/// `method.0.relative_radius=0.7` (methods count from 0), `method.relative_radius=[0.6, 0.7]` (every method
/// whose sampler has that parameter), `method.0.start.relative_radius=0.7` (in a table). Values are TOML;
/// plain words need no quotes. Keys that are not in the config are added. Values say `--set key=value` as
/// their location. Throws InputError for what cannot be applied.
void apply_overrides(ConfigTable& config, const std::vector<std::string>& overrides,
                     const SamplerRegistry& registry = sampler_registry());

/// Refuses overrides that cannot apply to each config of a collection: of a method by its number, of the title, and of
/// what is included. Throws InputError.
void check_collection_overrides(const std::vector<std::string>& overrides);

}
