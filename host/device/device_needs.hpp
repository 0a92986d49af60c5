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

// Drivers that end loops early, without a word, are not used.

/// Mesa's driver for processors, llvmpipe, counts the iterations of all loops of a work-item together. After 65,535 of
/// them it lets each loop end with the iteration that it is in, whatever its condition is (LP_MAX_TGSI_LOOP_ITERATIONS
/// in Mesa 22.3). Points come out wrong then, or darts are never settled. Lanes of its vectors that have no work-item,
/// as in work-groups of one, run loops as well: they read zeros, and their iterations count.
bool ends_loops_early(const std::string& device_name);

/// Returns the reason for not using a device of this name; empty: it is used. POISSONLAB_SHORT_LOOPS in the environment
/// lets tests of small sets use it.
std::string why_loops_are_unreliable(const std::string& device_name);

// A misfortune: PoCL ends the program, or has no devices, where the machine lacks what it needs.

/// True for the name of PoCL's platform.
bool is_pocl(const std::string& platform);

/// Must be called before OpenCL is used. Returns a message if something is missing, and then PoCL must not be asked
/// for devices; "" if all is well.
///
/// A folder for compiled kernels: PoCL has no devices if it cannot make its own, in $POCL_CACHE_DIR or the user's
/// cache folder; read-only homes, such as those of services and containers, would seem to be machines without OpenCL.
/// It ends the program if the disk of that folder is full. In both cases it is given another folder, in the one for
/// temporary files, that only this user can read and write.
///
/// A linker: PoCL ends the program if no folder of PATH has one. If there is no PATH, one is set.
std::string provide_pocl_needs();

}
