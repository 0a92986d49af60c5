// Spectra as OpenEXR images of float32, frequency (0, 0) at pixel (size / 2, size / 2), lowest frequencies
// first.
//
// A 2D spectrum has the channel "Y", a 3D one a layer for each of shown_planes(): "xy.Y", "xy_32.Y" ...
// Spectra of several realizations have "variance" beside each "Y".
//
// The planes of a 3D spectrum that are stored and shown.
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

/// A plane perpendicular to `axis` (0 x, 1 y, 2 z) of a 3D spectrum, at a frequency along it.
struct PlanePlace
{
    int axis = 2;
    int frequency = 0;

    bool operator==(const PlanePlace&) const = default;
};

/// The axes of a plane, columns first: "xy", "xz" or "yz".
const char* plane_axes(const PlanePlace& place);

/// Its name: the axes, followed by the frequency unless that is 0: "xy", "xy_32", "yz_-128".
std::string plane_name(const PlanePlace& place);

/// The planes that stand for a volume of M^3 frequencies, each once, in this order: the coordinate planes xy,
/// xz, yz; the outer faces xy, xz, yz at frequency -M/2; slices xy at frequencies M/16, M/8 and 3/16 M, which cut
/// the ball inside of the principal frequency for sets of the usual density.
/// (Dissertation, figure 6.33.)
std::vector<PlanePlace> shown_planes(int size);

/// A plane as a 2D spectrum, with variances where the volume has them. The remaining axes keep their order:
/// columns are the first of them, rows the second. Throws std::invalid_argument for a 2D spectrum and places
/// outside of it.
Spectrum spectrum_plane(const Spectrum& volume, const PlanePlace& place);

}
