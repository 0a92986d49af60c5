#include "host/device/loop_limit.hpp"

#include <cstdlib>

namespace poissonlab {

bool ends_loops_early(const std::string& device_name) { return device_name.starts_with("llvmpipe"); }

std::string why_loops_are_unreliable(const std::string& device_name)
{
    if (!ends_loops_early(device_name) || std::getenv("POISSONLAB_SHORT_LOOPS")) return {};
    return "its driver ends the loops of a work-item after 65,535 iterations, so that sets would be wrong "
           "(POISSONLAB_SHORT_LOOPS=1 uses it all the same)";
}

}
