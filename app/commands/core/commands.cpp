// The commands of every program.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> core_commands(const ProgramContext& context)
{
    return {{"", run_command(context.typed)},
            {"", merge_command()},
            {"", analyze_command(context.typed)},
            {"", report_command()},
            {"", devices_command()},
            {"", samplers_command()},
            {"", kinds_command()},
            {"", completion_command(context.all_commands)}};
}

}
