// The commands of tilings.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> tilings_commands(const ProgramContext& /*context*/)
{
    return {{"", tiling_command()},
            {"", packing_command()},
            {"aperiodic", aperiodic_sets_command()},
            {"aperiodic", aperiodic_convert_command()},
            {"aperiodic", aperiodic_verify_command()},
            {"aperiodic", aperiodic_tile_command()},
            {"aperiodic", aperiodic_tables_command()},
            {"isohedral", isohedral_list_command()},
            {"isohedral", isohedral_draw_command()}};
}

}
