// Spectra as OpenEXR images of float32, frequency (0, 0) at pixel (size / 2, size / 2): 2D spectra as one
// channel "Y", of 3D ones the coordinate planes as three channels "xy.Y", "xz.Y" and "yz.Y" (layers, to
// viewers). Of a volume more than its planes would be 64 MiB a series.
#pragma once

#include "analysis/spectrum.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

/// Writes a 2D spectrum, or the coordinate planes of a 3D one. `metadata` (config, seed, label ...) goes into
/// the header as string attributes "poissonlab:meta:<name>", beside "poissonlab:points" and
/// "poissonlab:realizations". Writes to a temporary name, then renames. Throws StorageError.
void write_spectrum(const std::filesystem::path& path, const Spectrum& spectrum,
                    const std::map<std::string, std::string>& metadata);

/// Reads what write_spectrum wrote of a 2D spectrum. Throws InputError for files that are not such spectra.
Spectrum read_spectrum(const std::filesystem::path& path);

/// The same for either dimension: one plane of a 2D spectrum, three of a 3D one in the order of plane_names.
std::vector<Spectrum> read_spectrum_planes(const std::filesystem::path& path);

/// The metadata that write_spectrum was given. Throws InputError for files that are not such spectra.
std::map<std::string, std::string> read_spectrum_metadata(const std::filesystem::path& path);

}
