// The OpenCL C sources that were embedded at build time.
#pragma once

#include <string>
#include <string_view>

namespace poissonlab {

/// The text of an embedded file, named from the root of the project ("kernels/common/philox.clh"); empty when there is
/// none.
std::string_view embedded_kernel_file(std::string_view name);

/// The text of `name` with every `#include "..."` of another embedded file replaced by its text, once each (whatever
/// #if is around the first), and #line directives so that build logs name the right file and line.
std::string kernel_source(std::string_view name);

}
