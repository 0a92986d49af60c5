// poissonlab samplers: what a [[method]] table can say, from the samplers' own descriptions.
#include "app/commands/commands.hpp"
#include "host/config/sampler_help.hpp"

#include <fmt/format.h>

namespace poissonlab {

void samplers_command(bool markdown) { fmt::print("{}", markdown ? samplers_markdown() : samplers_text()); }

}
