// The command of windows of endless recursive tilings.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> recursive_tiles_commands(const ProgramContext& /*context*/)
{
    return {{"distribute", distribute_recursive_command()}};
}

}
