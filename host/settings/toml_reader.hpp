// TOML text as a config tree. The only place that knows toml++.
#pragma once

#include "host/settings/config_tree.hpp"

#include <string>
#include <string_view>

namespace poissonlab {

/// Reads a TOML document. `file` is how messages name it. Throws InputError, `file:line: what is wrong`.
ConfigTable read_toml(std::string_view text, const std::string& file);

/// Reads one value, as it stands to the right of `=`, for example `[0.6, 0.7]`. What is not TOML but a plain
/// word, such as `reference`, is a string: command lines lose their quotes. `origin` is where messages say it
/// was written. Throws InputError for broken lists, tables and quoted strings.
ConfigNode read_toml_value(const std::string& text, const SourceLocation& origin);

}
