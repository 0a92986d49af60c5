// Methods that other programs have: commands that write point sets.
#include "host/modules/laboratory.hpp"
#include "host/sampling/classics/command_sampler.hpp"

namespace poissonlab {

void add_own_methods(Laboratory& laboratory)
{
    SamplerSpec command = command_sampler();
    laboratory.samplers.push_back(command);
    command.dimensions = {2};
    laboratory.region_samplers.push_back(command);
}

}
