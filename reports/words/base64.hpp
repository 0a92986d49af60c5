// Bytes as text, for pages that have files inside.
#pragma once

#include <string>
#include <string_view>

namespace poissonlab {

std::string base64_of(std::string_view bytes);

}
