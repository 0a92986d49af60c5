// The command line of poissonlab: its commands, their options, help.
#pragma once

#include "app/commands/command.hpp"

#include <vector>

namespace poissonlab {

/// The actions that the arguments call for, in their order. Prints help and version, which call for nothing more.
/// Throws InputError for arguments that are wrong.
std::vector<Action> actions_called_for(int argc, const char* const* argv);

}
