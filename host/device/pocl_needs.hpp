// A misfortune: PoCL ends the program, or has no devices, where the machine lacks what it needs.
#pragma once

#include <string>

namespace poissonlab {

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
