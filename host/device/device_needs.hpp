// These functions ask, before anything is built, whether a device has all that kernels need, and say in one line what
// it lacks.
#pragma once

#include "base/errors/errors.hpp"
#include "host/device/kernel_program.hpp"

#include <string>
#include <vector>

namespace poissonlab {

struct DeviceInfo;

/// The first need that a device does not meet, such as "double precision"; empty: it meets all.
std::string lacking(const KernelNeeds& needs, const DeviceInfo& device);

/// Returns true if a device can do work with these needs.
bool can_run(const KernelNeeds& needs, const DeviceInfo& device);

/// The error for `what`, a method or a command, that needs what a device lacks. It names one of `devices` that lacks
/// nothing: "lloyd needs double precision, which Arc A770 has not; --device 1 (pthread-EPYC) has it".
DeviceError lack_error(const std::string& what, const KernelNeeds& needs, const DeviceInfo& device,
                       const std::vector<DeviceInfo>& devices);

/// Throws lack_error(), with the devices of this machine, where the device does not meet the needs.
void check_needs(const std::string& what, const KernelNeeds& needs, const DeviceInfo& device);

}
