// Masks of samples as files.
#pragma once

#include "host/distribution/masks/sampling_mask.hpp"

#include <filesystem>

namespace poissonlab {

/// Writes .npy (uint8, shape (rows, columns), 1: a sample), .cfl and the .hdr beside it (BART: complex floats,
/// dimensions 1, rows, columns) or .png (samples are white). Throws StorageError.
void write_mask(const std::filesystem::path& file, const SamplingMask& mask);

}
