// The commands of points in regions.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> regions_commands(const ProgramContext& /*context*/)
{
    return {{"distribute", distribute_darts_command()}, {"distribute", distribute_points_command()}};
}

}
