// The command of points of several classes on meshes.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> surface_classes_commands(const ProgramContext& /*context*/)
{
    return {{"distribute", distribute_surface_classes_command()}};
}

}
