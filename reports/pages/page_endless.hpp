// A page for a tile set: the endless tiling, live, in any browser and from the disk; on its own, and of a series.
#pragma once

#include "reports/layout/site.hpp"

#include <string>
#include <string_view>

namespace poissonlab {

/// The page of a tile set in the plane, with all that it needs in it. `file`: the bytes of a binary tile set file;
/// `name`: how the file is called. Throws InputError, a line that starts with the name, for bytes that are none, and
/// for tiles in space.
std::string render_endless_page(std::string_view file, const std::string& name);

/// The page of a series that has_endless_page().
std::string render_endless_page(const Site& site, const ReportSeries& series);

}
