// Places in a density's rectangle as point files.
#pragma once

#include "host/sampling/warp/warp.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// Writes places as coordinates in units of `longest` pixels, y upwards; the comment begins with `domain 0:1`. Throws
/// StorageError.
void write_places(const std::filesystem::path& file, const PixelPlaces& places, std::uint32_t longest,
                  const std::string& comment);

}
