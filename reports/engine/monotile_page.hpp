// A page for a file with hats or spectres: the tiling and its points, live, in any browser and from the disk.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// Returns the page, with all that it needs in it. `file`: the bytes of a tile set file, version 4, whose name is
/// `name`. `outline`: the corners of the tile in its own frame, numbers a + b z + c z^2 + d z^3 with z a twelfth of a
/// turn. Throws InputError, a line that starts with the name, for bytes that are no such file.
std::string render_monotile_page(std::string_view file, const std::string& name,
                                 const std::vector<std::array<std::int64_t, 4>>& outline);

}
