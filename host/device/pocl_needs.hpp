// A misfortune: PoCL ends the program, or has no devices, where the machine lacks what it needs.
#pragma once

#include <string>

namespace poissonlab {

/// Whether this is the name of PoCL's platform.
bool is_pocl(const std::string& platform);

/// To be called before OpenCL is. Returns what to say where something is lacking: PoCL must not be asked for devices
/// then. Empty: all is well.
///
/// A folder for compiled kernels: PoCL has no devices where it cannot make its own, in $POCL_CACHE_DIR or the user's
/// cache folder; read-only homes, as those of services and containers are, would seem to be machines without OpenCL. It
/// ends the program where the disk of that folder is full. Another folder is named to it there, in the one for
/// temporary files, that only this user can read and write.
///
/// A linker: PoCL ends the program where no folder of PATH has one. Where there is no PATH, one is made.
std::string provide_pocl_needs();

}
