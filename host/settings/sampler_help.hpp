// Help on parameters, from the samplers' own descriptions.
#pragma once

#include "host/sampling/sampler.hpp"

#include <string>

namespace poissonlab {

/// Says what a parameter means, with its unit.
std::string meaning_of(const ParameterSpec& spec);

/// The help of a command on an option that gives a parameter: "Lloyd iterations of each piece:
/// an integer from 0 to 100000; default: 20".
std::string option_help(const ParameterSpec& spec);

/// The default as help says it: 0.75, random.
std::string default_text(const ParameterSpec& spec);

}
