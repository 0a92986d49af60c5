// Words for values that are numbers with decimal commas.
#pragma once

#include "host/settings/config_tree.hpp"

#include <string>

namespace poissonlab {

/// The end of a message about a value that is such a number, see decimal_comma_words(); empty for any other, where
/// an integer is `allowed` (in "1,000" points the comma is none of decimals), and where `allowed` has these words
/// already.
std::string comma_words(const ConfigNode& node, const std::string& allowed);

}
