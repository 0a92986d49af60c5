// The stored manifest as part of the binary.
#pragma once

#include <string_view>

namespace poissonlab {

/// The text of "manifest.tsv".
std::string_view manifest_file(std::string_view name);

}
