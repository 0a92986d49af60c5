// pair-correlation.csv: the pair correlation function of a series.
#pragma once

#include "analysis/measures/pair_correlation.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The text of the table, numbers in their shortest exact form.
std::string pair_correlation_csv(const std::vector<PairCorrelationBin>& bins);

/// Reads columns distance,pair_correlation,standard_error,pairs. Throws InputError with file and line.
std::vector<PairCorrelationBin> read_pair_correlation_table(const std::filesystem::path& path);

}
