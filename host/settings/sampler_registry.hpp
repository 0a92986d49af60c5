// All methods of making point sets that a config can name.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// All samplers, in the order in which help and errors list them; host/modules has what modules bring.
const SamplerRegistry& sampler_registry();

/// The sampler of that name, or null. Throws MissingModule where only a module has it that this program lacks.
const SamplerSpec* find_sampler(const std::string& name, const SamplerRegistry& registry = sampler_registry());

/// The description of a parameter of a sampler; both are there.
const ParameterSpec& parameter_of(const std::string& sampler, const std::string& key);

}
