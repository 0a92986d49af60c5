// Damage of PNG files, by the lengths and check sums of their chunks: libpng would tell of it on standard error, with a
// line of its own before that of the program.
#pragma once

#include <filesystem>
#include <string>

namespace poissonlab {

/// The words for what is wrong with a PNG file: it is cut off, or a chunk's check sum is not that of its bytes (PNG
/// specification, third edition, 5.3). Empty where all chunks up to the last one are whole, and for other files.
std::string png_damage(const std::filesystem::path& path);

/// Checks only the chunks before the pixels, which are all that a header is read from: a whole large file takes a
/// moment.
std::string png_header_damage(const std::filesystem::path& path);

}
