// The tables of docs/gallery/, embedded at build time.
#pragma once

#include <string_view>

namespace poissonlab {

/// The text of a table, such as "curves.csv"; empty for unknown names.
std::string_view gallery_file(std::string_view name);

}
