// The sequential twins of the core's kernels, each of which stands beside its kernel's host side.
#pragma once

namespace poissonlab {

/// Throws MissingModule if this program was built without the twins. Code that plans work for them calls this function
/// first.
void need_reference_engine();

}
