// The commands of points and objects that follow densities, and of masks.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> distributions_commands(const ProgramContext& /*context*/)
{
    return {{"distribute", distribute_warp_command()},     {"distribute", distribute_rank_command()},
            {"distribute", distribute_stipple_command()},  {"distribute", distribute_hatch_command()},
            {"distribute", distribute_icons_command()},    {"distribute", distribute_instances_command()},
            {"distribute", distribute_mri_mask_command()}, {"distribute", distribute_dither_mask_command()}};
}

}
