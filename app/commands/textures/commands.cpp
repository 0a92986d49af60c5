// The commands of textures.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> textures_commands(const ProgramContext& /*context*/)
{
    return {{"texture", texture_advise_command()}, {"texture", texture_build_command()},
            {"texture", texture_verify_command()}, {"texture", texture_tile_command()},
            {"texture", texture_map_command()},    {"texture", texture_endless_command()},
            {"texture", texture_export_command()}, {"texture", texture_cells_command()},
            {"texture", texture_design_command()}};
}

}
