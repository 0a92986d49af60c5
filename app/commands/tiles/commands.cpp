// The commands of Poisson disk tiles.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> tiles_commands(const ProgramContext& /*context*/)
{
    return {{"tiles", tiles_build_command()},
            {"tiles", tiles_points_command()},
            {"tiles", tiles_picture_command()},
            {"tiles", tiles_page_command()},
            {"tiles", tiles_verify_command()}};
}

}
