// Where PoCL keeps compiled kernels.
#pragma once

namespace poissonlab {

/// PoCL has no devices where it cannot make its folder, in $POCL_CACHE_DIR or the user's cache folder: read-only homes,
/// as those of services and containers are, would seem to be machines without OpenCL; and it ends the program where the
/// disk of that folder is full. This names another folder to it
/// there, in the folder for temporary files, that only this user can read and write. To be called before OpenCL is.
void provide_kernel_cache();

}
