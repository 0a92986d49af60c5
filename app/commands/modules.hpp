// The commands that modules bring to the program.
#pragma once

#include "app/commands/command.hpp"

#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// A command that needs more than its own options takes it from the context.
struct ProgramContext
{
    std::string typed; ///< the whole command as the user would type it again
    std::function<std::vector<Command>()> all_commands;
};

/// A command and the group that it is in, such as "tiles"; empty: none.
struct GroupedCommand
{
    std::string group;
    Command command;
};

/// A module by its name, and the function that makes its commands.
struct CommandModule
{
    std::string name;
    std::vector<GroupedCommand> (*commands)(const ProgramContext& context);
};

// Each is in the file commands.cpp of its module's folder.
std::vector<GroupedCommand> core_commands(const ProgramContext& context);
std::vector<GroupedCommand> results_commands(const ProgramContext& context);
std::vector<GroupedCommand> tiles_commands(const ProgramContext& context);
std::vector<GroupedCommand> tilings_commands(const ProgramContext& context);
std::vector<GroupedCommand> textures_commands(const ProgramContext& context);
std::vector<GroupedCommand> regions_commands(const ProgramContext& context);
std::vector<GroupedCommand> distributions_commands(const ProgramContext& context);
std::vector<GroupedCommand> recursive_tiles_commands(const ProgramContext& context);
std::vector<GroupedCommand> surfaces_commands(const ProgramContext& context);
std::vector<GroupedCommand> classes_commands(const ProgramContext& context);
std::vector<GroupedCommand> surface_classes_commands(const ProgramContext& context);
std::vector<GroupedCommand> surface_textures_commands(const ProgramContext& context);
std::vector<GroupedCommand> large_sets_commands(const ProgramContext& context);
std::vector<GroupedCommand> manual_commands(const ProgramContext& context);

/// The modules of this program that have commands; CMake writes the list.
const std::vector<CommandModule>& built_command_modules();

}
