// What the tables of configs can say, from the kinds' own descriptions.
#pragma once

#include <string>

namespace poissonlab {

/// All kinds with their keys, for a terminal.
std::string kinds_text();

/// The same as docs/kinds.md.
std::string kinds_markdown();

}
