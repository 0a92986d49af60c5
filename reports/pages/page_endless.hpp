// A page for a tile set: the endless tiling, live, in any browser and from the disk; on its own, and of a series.
#pragma once

#include "reports/layout/site.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace poissonlab {

/// The page of a tile set in the plane, with all that it needs in it. `file`: the bytes of a binary tile set file;
/// `name`: how the file is called. Throws InputError, a line that starts with the name, for bytes that are none, and
/// for tiles in space.
std::string render_endless_page(std::string_view file, const std::string& name);

/// True for series of tilings with a tile set in the plane that is stored.
bool has_endless_page(const ReportSeries& series);

/// The page of a series that has one, and its file.
std::string render_endless_page(const Site& site, const ReportSeries& series);
std::filesystem::path endless_page_of(const ReportSeries& series);

}
