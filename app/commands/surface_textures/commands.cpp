// The commands of textures and objects on surfaces.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> surface_textures_commands(const ProgramContext& /*context*/)
{
    return {{"texture", texture_surface_command()}, {"distribute", distribute_objects_command()}};
}

}
