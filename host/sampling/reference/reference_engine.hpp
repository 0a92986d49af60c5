// The sequential twins of the core's kernels, each of which stands beside its kernel's host side.
#pragma once

namespace poissonlab {

/// Throws MissingModule where this program was built without the twins. Whoever plans work for them calls this function
/// first.
void need_reference_engine();

}
