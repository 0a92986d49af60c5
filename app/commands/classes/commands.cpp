// The command of points of several classes.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> classes_commands(const ProgramContext& /*context*/)
{
    return {{"distribute", distribute_classes_command()}};
}

}
