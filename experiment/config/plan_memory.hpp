// The check, before work starts, that the device has memory for a plan.
#pragma once

#include "experiment/config/plan.hpp"
#include "host/device/device.hpp"

#include <vector>

namespace poissonlab {

/// Throws InputError for the first series that does not fit on the device: which one, what it needs, what the device
/// has, and how many points would fit. Point sets that come from files and programs may turn out larger than was asked
/// for: their size is checked when they are there.
void check_device_memory(const std::vector<SeriesPlan>& plan, const DeviceInfo& device);

}
