// The share of a tiling's power that lies on the lattice of its tiles' frequencies: what repeats with the tiles.
#pragma once

#include "analysis/spectra/half_spectrum.hpp"

namespace poissonlab {

/// Throws MissingModule if this program was built without measures of tiled sets. Long work on such sets calls this
/// function first.
void need_tile_measures();

/// The power at all frequencies f = M (a, b[, c]) but 0 over that at all frequencies but 0, of those below half of the
/// spectrum's size along each axis. `tiles` is M, at least 1: with one tile it is 1. Random points have about M^-d.
///
/// A point that two places of a tiling have in common with probability s, wherever it is, adds s to this share, so that
/// tiles whose shared points are random have s + (1 - s) M^-d. Throws InputError for fewer tiles than 1.
double lattice_share(const HalfSpectrum& periodogram, int tiles);

}
