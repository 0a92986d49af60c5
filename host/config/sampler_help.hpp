// What users are told of samplers and their parameters, from the samplers' own descriptions.
#pragma once

#include "host/sampling/parameters.hpp"

#include <string>

namespace poissonlab {

/// The default as help says it: "0.75", `random`; empty where no value can say it.
std::string default_text(const ParameterSpec& spec);

/// All samplers with their parameters, for a terminal.
std::string samplers_text();

/// The same as the table of README.md.
std::string samplers_markdown();

}
