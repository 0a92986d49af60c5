// A config as an experiment: its plan, and the OpenCL device that its samplers share.
#pragma once

#include "experiment/config/config.hpp"
#include "experiment/series/experiment.hpp"

#include <string>

namespace poissonlab {

/// The experiment that a config describes. `device` selects the OpenCL device as Device::open does, empty:
/// the default; `threads` restricts a CPU device, 0: all. Nothing runs yet, but a device that is named is
/// opened, so that a wrong name shows at once; otherwise it is opened by the first series that needs one.
/// Throws InputError for impossible plans, DeviceError for devices that are not there.
Experiment make_experiment(const Config& config, const std::string& device, unsigned threads);

}
