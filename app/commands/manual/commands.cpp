// The command that writes the documentation.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> manual_commands(const ProgramContext& context)
{
    return {{"", manual_command(context.all_commands)}};
}

}
