// All samplers and their parameters, printed from their own descriptions by programs that have all modules.
#pragma once

#include "host/sampling/sampler.hpp"

#include <string>

namespace poissonlab {

/// The text with what is in braces as code of Markdown, which takes braces at the end of a cell for attributes of it
/// and leaves them out.
std::string braces_as_code(const std::string& text);

/// All samplers with their parameters, for a terminal.
std::string samplers_text(const SamplerRegistry& all, const SamplerRegistry& in_regions);

/// Lists all samplers as the table of docs/samplers.md does.
std::string samplers_markdown(const SamplerRegistry& samplers);

/// The parameters of one sampler, as a table.
std::string parameters_markdown(const SamplerSpec& sampler);

}
