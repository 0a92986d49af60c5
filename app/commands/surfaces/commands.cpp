// The command of points on surfaces.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> surfaces_commands(const ProgramContext& /*context*/)
{
    return {{"distribute", distribute_surface_command()}};
}

}
