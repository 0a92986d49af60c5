// Pictures of a 3D spectrum, of the planes that are stored of it. All have the tone mapping that they are given; a unit
// of the drawing is a pixel, which shows the mean of `block` x `block` frequencies, as for draw_spectrum.
#pragma once

#include "analysis/spectra/spectrum.hpp"
#include "reports/drawings/drawing.hpp"
#include "reports/images/tone_mapping.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The coordinate planes as two faces of a cube above a third: xz and yz in the upper row, z upwards in both;
/// xy below xz, with the same x. Each has its name above it. `planes` begin with these, as shown_planes()
/// does.
Drawing draw_spectrum_planes(const std::vector<Spectrum>& planes, const ToneMapping& tone_mapping, int block = 1);

/// Planes side by side, named. `planes` and `names` have the same size.
Drawing draw_plane_row(const std::vector<Spectrum>& planes, const std::vector<std::string>& names,
                       const ToneMapping& tone_mapping, int block = 1);

/// The middle of a 2D spectrum as a spectrum of its own, with five eighths of the frequencies along each axis
/// (an even number): the ring at the principal frequency and what is inside, for sets of the usual density.
Spectrum spectrum_close_up(const Spectrum& plane);

}
