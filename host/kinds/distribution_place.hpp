// The place where distributions are made: the engine, its device, and who is told of long steps.
#pragma once

#include "host/sampling/sampler.hpp"

#include <functional>
#include <string>

namespace poissonlab {

struct DistributionPlace
{
    Engine engine = Engine::opencl;
    DeviceProvider device;
    std::function<void(const std::string& what)> on_step = {};
};

}
