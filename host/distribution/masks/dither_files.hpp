// Masks of thresholds as files.
#pragma once

#include "host/distribution/masks/dither_mask.hpp"

#include <filesystem>

namespace poissonlab {

/// Writes .png (8 bits where there are at most 256 thresholds, else 16) or .npy (uint32, the ranks of pixels). Throws
/// StorageError.
void write_dither_mask(const std::filesystem::path& file, const DitherMask& mask);

/// Pixels below some thresholds as black dots of a corner of the mask, side by side.
void write_threshold_strip(const std::filesystem::path& file, const DitherMask& mask);

}
