// The tables of a series as they are stored: comma-separated, numbers in their shortest exact form.
#pragma once

#include "analysis/measures/pair_correlation.hpp"
#include "analysis/spectra/radial_statistics.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// radial.csv: frequency,power,anisotropy_db,samples,power_error
std::string radial_csv(const std::vector<RadialBin>& bins);

/// pair-correlation.csv: distance,pair_correlation,standard_error,pairs
std::string pair_correlation_csv(const std::vector<PairCorrelationBin>& bins);

}
