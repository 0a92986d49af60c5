// Help on samplers and their parameters, printed from the samplers' own descriptions.
#pragma once

#include "host/sampling/sampler.hpp"

#include <string>

namespace poissonlab {

/// Says what a parameter means, with its unit.
std::string meaning_of(const ParameterSpec& spec);

/// The text with what is in braces as code of Markdown, which takes braces at the end of a cell for attributes of it
/// and leaves them out.
std::string braces_as_code(const std::string& text);

/// The help of a command on an option that gives a parameter: "Lloyd iterations of each piece:
/// an integer from 0 to 100000; default: 20".
std::string option_help(const ParameterSpec& spec);

/// All samplers with their parameters, for a terminal.
std::string samplers_text(const SamplerRegistry& all, const SamplerRegistry& in_regions);

/// Lists all samplers as the table of docs/samplers.md does.
std::string samplers_markdown(const SamplerRegistry& samplers);

/// The parameters of one sampler, as a table.
std::string parameters_markdown(const SamplerSpec& sampler);

}
