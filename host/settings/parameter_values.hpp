// Config values made into sampler parameters: types, ranges, and lists that stand for several series.
#pragma once

#include "host/settings/config_tree.hpp"
#include "host/settings/sampler_registry.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// A value of a parameter, and how names and labels show it.
struct ParameterChoice
{
    ParameterValue value;
    std::string shown; ///< numbers as they were typed, 0.70 and not 0.7
    SourceLocation location;
    std::string in_name; ///< how names of series show it; empty: as shown
};

/// The values that a parameter accepts, in the words of messages and the help: "a number greater than 0 and at most 1".
std::string allowed_values(const ParameterSpec& spec);

/// The values that a config key gives a parameter: one, or each item of a list. A list of paths is one value;
/// a table of a sampler is one value for each combination of the lists in it. `registry` has the samplers
/// that values can be, `depth` says how deep the key lies in their tables. Throws InputError for wrong types,
/// values out of range and empty lists.
std::vector<ParameterChoice> parameter_choices(const ParameterSpec& spec, const ConfigNode& node,
                                               const SamplerRegistry& registry = sampler_registry(), int depth = 0);

}
