// Pictures that commands write: a drawing as SVG or PNG, as the file's name says.
#pragma once

#include "app/commands/output_file.hpp"
#include "reports/drawings/drawing.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// A drawing's.
inline OutputFormats picture_formats() { return {{".svg", ".png"}}; }

/// Writes a drawing; as PNG so many pixels wide, 0: two a unit. Throws StorageError.
void write_picture_file(const std::filesystem::path& file, const Drawing& drawing, int pixels = 0);

}
