// Checks of the headers of square OpenEXR images, made before anything is allocated for their pixels.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <cstddef>
#include <filesystem>
#include <string>

namespace poissonlab {

/// Sees that a file begins with a header of one plain image, and that it is long enough for its attributes and pixels:
/// OpenEXR takes as much memory for each as it says that it has. Throws std::runtime_error, without the file's name.
void check_header_fits(const std::filesystem::path& file);

/// True if an image has this channel, as a float32 for each pixel.
bool has_float_channel(const Imf::Header& header, const std::string& name);

/// Width and height of an image with its corner at (0, 0). Throws std::runtime_error, without the file's name, for
/// other images.
int checked_square_size(const Imf::Header& header);

}
