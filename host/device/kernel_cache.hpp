// Where PoCL keeps compiled kernels.
#pragma once

#include <string>

namespace poissonlab {

/// Whether this is the name of PoCL's platform.
bool is_pocl(const std::string& platform);

/// PoCL has no devices where it cannot make its folder, in $POCL_CACHE_DIR or the user's cache folder: read-only homes,
/// as those of services and containers are, would seem to be machines without OpenCL; and it ends the program where the
/// disk of that folder is full. This names another folder to it
/// there, in the folder for temporary files, that only this user can read and write. To be called before OpenCL is.
///
/// Returns what to say where neither can be used: PoCL must not be asked for devices then. Empty: all is well.
std::string provide_kernel_cache();

}
