// Completion for shells, from the same descriptions of commands as the parser and the manual page.
#pragma once

#include "app/commands/command.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The shells that there is a script for.
const std::vector<std::string>& completed_shells();

/// The script of such a shell: it completes commands, options, and the words that options know; else names of files.
std::string completion_script(const std::string& shell, const std::vector<Command>& commands);

}
