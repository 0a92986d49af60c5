// Results for each claim of the papers, as the paper has them or not, and the series that they are made of.
#pragma once

#include "tests/reports/support/made_up_series.hpp"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace poissonlab::test {

struct ClaimCase
{
    std::string id;
    std::function<void(MadeUpReport&, bool agrees)> results;
};

inline void PrintTo(const ClaimCase& claim, std::ostream* out) { *out << claim.id; }

/// Cases of chapter 6: methods without tiles, and with tiles; and of later papers.
std::vector<ClaimCase> untiled_claim_cases();
std::vector<ClaimCase> tile_claim_cases();
std::vector<ClaimCase> later_claim_cases();
ReportSeries& darts(MadeUpReport& report, const std::string& rho, std::size_t points = 16384, int dimension = 2);
ReportSeries& jones(MadeUpReport& report, std::size_t points = 16384);
ReportSeries& relaxation(MadeUpReport& report, const std::string& factor, const std::string& attempts,
                         std::size_t points = 16384, int dimension = 2);
ReportSeries& lloyd(MadeUpReport& report, int iterations, std::size_t points = 16384, int dimension = 2);
void set_number(ReportSeries& series, const std::string& key, double value);
void set_oscillation(ReportSeries& series, double value);
ReportSeries& with_target(MadeUpReport& report, const std::string& target, double nyquist);
void saturated(MadeUpReport& report, int dimension, double intercept);

/// `speckle`: anisotropy between the peaks, in dB above chance.
ReportSeries& tiles(MadeUpReport& report, const std::string& kind, int set, int points_per_tile, double mean_peak,
                    double speckle = 1);
void set_seconds(ReportSeries& series, double seconds);

/// A method beside three others: more anisotropic than they are, or not.
void among_others(MadeUpReport& report, const std::string& sampler, bool is_worse);

/// Radii from `start` to `end`, there after so many of 128 iterations.
std::vector<double> relaxed(double start, double end, int settled);

}
