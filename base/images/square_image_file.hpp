// Square images, such as pictures of the zone plate, as OpenEXR images of float32, channel "Y".
//
// Unlike a spectrum's, the first line of the file is the highest y: viewers show the origin at the lower
// left, where the dissertation has it.
#pragma once

#include "base/images/square_image.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace poissonlab {

/// `metadata` (config, seed, label ...) goes into the header as string attributes "poissonlab:meta:<name>".
/// Writes to a temporary name, then renames. Throws StorageError.
void write_square_image(const std::filesystem::path& path, const SquareImage& image,
                        const std::map<std::string, std::string>& metadata);

/// Reads what write_zone_plate wrote. Throws InputError for files that are not such pictures.
SquareImage read_square_image(const std::filesystem::path& path);

}
