// Parameters of methods and keys of kinds as JSON, for programs that make configs or commands.
#pragma once

#include "host/sampling/parameters.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace poissonlab {

/// Describes a key: its name, its meaning, its default, and what it may be; numbers have their range, words are all
/// listed.
nlohmann::ordered_json described_value(const ParameterSpec& spec, const std::string& allowed);

}
