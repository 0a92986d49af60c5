// The tilings of a report whose spectra the papers' claims are about.
#pragma once

#include "reports/claims/claim_series.hpp"

#include <string>
#include <vector>

namespace poissonlab {

using SeriesPointer = const ReportSeries*;

double points_per_tile(const ReportSeries& series);

/// Tiles in the set, of series that have one.
double set_size(const ReportSeries& series);

/// The mean ratio of the lattice's peaks, of series that have some.
double mean_peak(const ReportSeries& series);

/// Anisotropy between the peaks, in dB above chance; 0: not measured.
double speckle(const ReportSeries& series);

bool has_chains(const ReportSeries& series);

/// Spectra of tilings with their lattice peaks, of usual points and of the papers' kind: without chains, without
/// relaxing all tiles together, without points left out.
std::vector<SeriesPointer> tiling_spectra(const ClaimSeries& report, const std::string& sampler);

/// Pairs of a series of each list with equal N.
template <typename Visit>
void for_equal_points(const std::vector<SeriesPointer>& first, const std::vector<SeriesPointer>& second,
                      const Visit& visit)
{
    for (SeriesPointer a : first)
        for (SeriesPointer b : second)
            if (points_per_tile(*a) == points_per_tile(*b)) visit(*a, *b);
}

}
