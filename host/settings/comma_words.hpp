// Words for values that are numbers with decimal commas.
#pragma once

#include "host/settings/config_tree.hpp"

#include <string>

namespace poissonlab {

/// The end of a message about a value that is such a number, see decimal_comma_words(); empty for any other.
std::string comma_words(const ConfigNode& node);

}
