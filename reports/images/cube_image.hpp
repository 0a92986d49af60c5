// The picture of a 3D spectrum as a cube from which one eighth is cut out (dissertation, figure 6.33 a).
#pragma once

#include "analysis/spectra/spectrum.hpp"
#include "base/images/grey_image.hpp"
#include "reports/images/tone_mapping.hpp"

#include <vector>

namespace poissonlab {

/// The cube of frequencies in parallel projection, seen from where x, y and z are positive: x to the lower
/// left, y to the lower right, z upwards. The eighth towards the viewer is cut away and shows the coordinate
/// planes. `planes` begin with the coordinate planes xy, xz, yz and the outer faces at -M/2, as
/// shown_planes() does (a set's spectrum is the same at f and -f). Edges are black, the rest is white. The
/// picture is about 1.5 M wide and 1.7 M high, with `scale` 2 twice that.
GreyImage draw_spectrum_cube(const std::vector<Spectrum>& planes, const ToneMapping& tone_mapping, double scale = 1);

}
