// Spectra as OpenEXR images of float32, frequency (0, 0) at pixel (size / 2, size / 2), lowest frequencies
// first.
//
// A 2D spectrum has the channel "Y", a 3D one a layer for each of shown_planes(): "xy.Y", "xy_32.Y" ...
// Spectra of several realizations have "variance" beside each "Y".
#pragma once

#include "analysis/spectra/spectrum.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

/// Writes a 2D spectrum, or the planes that stand for a 3D one. `metadata` (config, seed, label ...) goes
/// into the header as string attributes "poissonlab:meta:<name>", beside "poissonlab:points" and
/// "poissonlab:realizations". Writes to a temporary name, then renames. Throws StorageError.
void write_spectrum(const std::filesystem::path& path, const Spectrum& spectrum,
                    const std::map<std::string, std::string>& metadata);

/// Reads what write_spectrum wrote: a 2D spectrum as one plane, the planes of a 3D one in the order of shown_planes().
/// Throws InputError for files that are not such spectra.
std::vector<Spectrum> read_spectrum_planes(const std::filesystem::path& path);

/// Writes all frequencies of a 3D spectrum as one image of size x size^2 with the channel "Y": its slices
/// along z, lowest frequency first, one below the other. Attributes and errors as above.
void write_spectrum_volume(const std::filesystem::path& path, const Spectrum& volume,
                           const std::map<std::string, std::string>& metadata);

}
