// The picture of a 3D spectrum: its three coordinate planes, unfolded and named.
#pragma once

#include "analysis/spectrum.hpp"
#include "reports/grey_image.hpp"
#include "reports/tone_mapping.hpp"

#include <vector>

namespace poissonlab {

/// The planes as two faces of a cube above a third: xz and yz in the upper row, z upwards in both; xy below
/// xz, with the same x. Each has its name above it. `planes` are in the order of plane_names; the other
/// parameters are those of draw_spectrum.
GreyImage draw_spectrum_planes(const std::vector<Spectrum>& planes, const ToneMapping& tone_mapping,
                               int block = 1);

}
