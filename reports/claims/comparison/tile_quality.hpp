// Judges spectra of tilings between the peaks of their lattice, and on it.
#pragma once

#include "reports/claims/comparison/tile_spectra.hpp"
#include "reports/claims/paper_claims.hpp"

#include <string>

namespace poissonlab {

/// Counts the series that lie within limits of anisotropy and of peaks, or beyond: shown, as the limits were chosen to
/// tell apart what the dissertation calls good and bad.
std::optional<ClaimOutcome> shown_spectra(const std::vector<SeriesPointer>& all, bool good,
                                          const std::function<bool(SeriesPointer)>& selected);
std::string calibration_criterion();

/// Every series that is selected against every one that is not: better in both, worse in both, or else open.
std::optional<ClaimOutcome> are_better(const std::vector<SeriesPointer>& all,
                                       const std::function<bool(SeriesPointer)>& selected);
std::string order_criterion();

}
