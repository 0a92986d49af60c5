// What the lattice peaks up to the first ring are made of, set by set: their errors follow from how sets differ.
#pragma once

#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/spectra/half_spectrum.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace poissonlab {

/// All power up to where NearLatticePeaks end, then for each peak its own and the mean power of its ring. The list is
/// linear in periodograms, so that the measures of an average of spectra follow from that of such lists. Sets of a
/// series have lists of one length for one number of `points`. Throws InputError for fewer `tiles` than 2.
std::vector<double> near_lattice_powers(const HalfSpectrum& periodogram, std::size_t points, int tiles);

/// The measures of such a list, or of an average of lists; nothing where there are no peaks.
std::optional<NearLatticePeaks> near_lattice_peaks(const std::vector<double>& powers, std::size_t points);

}
