// The endings of point files that can be written.
#pragma once

#include <string>
#include <vector>

namespace poissonlab {

/// ".txt" and so on; see write_points(). A name without an ending is text.
const std::vector<std::string>& point_file_endings();

}
