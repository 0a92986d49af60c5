// The commands that compare and write out results which are there.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> results_commands(const ProgramContext& /*context*/)
{
    return {{"", export_command()}, {"", diff_command()}};
}

}
