// Pictures that commands write: a drawing as SVG or PNG, as the file's name says.
#pragma once

#include "reports/drawings/drawing.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// Throws InputError for a file that is neither .svg nor .png, in a folder that is not there, or a folder; `command` is
/// "isohedral draw" and so on.
void check_picture_file(const std::string& command, const std::filesystem::path& file);

/// Writes a drawing; as PNG so many pixels wide, 0: two a unit. Throws StorageError.
void write_picture_file(const std::filesystem::path& file, const Drawing& drawing, int pixels = 0);

}
