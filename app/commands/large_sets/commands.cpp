// The commands of sets of any size.
#include "app/commands/modules.hpp"

namespace poissonlab {

std::vector<GroupedCommand> large_sets_commands(const ProgramContext& /*context*/)
{
    return {{"points", points_dart_throwing_command()},
            {"points", points_lloyd_command()},
            {"points", points_gaussian_blue_noise_command()}};
}

}
