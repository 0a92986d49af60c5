// The keys that tables of configs can have, from the kinds' own descriptions.
#pragma once

#include "host/kinds/kind.hpp"

#include <string>

namespace poissonlab {

/// All kinds with their keys, for a terminal.
std::string kinds_text();

/// The keys of one, as a table of Markdown.
std::string keys_markdown(const Kind& kind);

/// All kinds with their keys as docs/kinds.md.
std::string kinds_markdown();

}
