// The planes of a 3D spectrum that are stored and shown.
#pragma once

#include "analysis/spectra/spectrum.hpp"

#include <string>
#include <vector>

namespace poissonlab {

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
