// Parameters of methods and keys of kinds as JSON, for programs that make configs or commands.
#pragma once

#include "host/sampling/parameters.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace poissonlab {

/// What it is called, means and may be; numbers have their range, words all that there are.
nlohmann::ordered_json described_value(const ParameterSpec& spec, const std::string& allowed);

}
