// Spectra as OpenEXR images: one float32 channel "Y", frequency (0, 0) at pixel (size / 2, size / 2).
#pragma once

#include "analysis/spectrum.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace poissonlab {

/// Writes a 2D spectrum. `metadata` (config, seed, label ...) goes into the header as string attributes
/// "poissonlab:meta:<name>", beside "poissonlab:points" and "poissonlab:realizations".
/// Writes to a temporary name, then renames. Throws StorageError.
void write_spectrum(const std::filesystem::path& path, const Spectrum& spectrum,
                    const std::map<std::string, std::string>& metadata);

/// Reads what write_spectrum wrote. Throws InputError for files that are not such spectra.
Spectrum read_spectrum(const std::filesystem::path& path);

/// The metadata that write_spectrum was given. Throws InputError for files that are not such spectra.
std::map<std::string, std::string> read_spectrum_metadata(const std::filesystem::path& path);

}
