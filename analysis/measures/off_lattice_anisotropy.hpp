// The anisotropy that tilings have between the peaks of their lattice.
//
// Few tiles make speckle: all realizations consist of the same tiles, so that averaging periodograms does not smooth
// the power between the peaks as it should. Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 6.10
// and 6.11 judge tile sets by how their spectra look; this is the part of it that is not in the peaks.
#pragma once

#include "analysis/spectra/spectrum.hpp"

#include <optional>

namespace poissonlab {

/// The height of the anisotropy (dissertation, equation 6.5) of rings without the multiples of `tiles` above that of
/// chance, -10 log10 K, in dB: the mean over all rings of at least 100 such samples. About 0 where tiles leave no
/// trace; of T template tiles, 10 log10(1 + K / (T - 1)). Nothing where no ring has as many, and for a single
/// realization.
std::optional<double> off_lattice_anisotropy_db(const Spectrum& spectrum, int tiles);

}
