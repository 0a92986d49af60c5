// All commands of the program as one list, with those that only modules have that this program lacks.
#pragma once

#include "app/commands/command.hpp"
#include "host/modules/manifest.hpp"

#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// All commands, in the order of the manifest. `typed` is the whole command as the user would type it again. A command
/// that this program lacks has its name and summary, and Command::absent_module.
std::vector<Command> all_commands(const std::string& typed);

/// Throws MissingModule where the words after the program's name are those of a command that this program lacks.
void check_is_built(const std::vector<Command>& commands, std::span<const char* const> words);

/// The entries of the manifest for the commands of this program, each with its module.
std::vector<ManifestEntry> entries_of_commands();

}
