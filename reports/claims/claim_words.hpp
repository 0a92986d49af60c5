// Measured values in words, and claims of kinds that occur several times.
#pragma once

#include "reports/claims/paper_claims.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// "a; b; c" without empty parts.
std::string joined_words(const std::vector<std::string>& parts);

/// "0.12 to 0.34", or one number where both look the same. `values` must not be empty.
std::string range_words(const std::vector<double>& values, int digits);

/// "0.02 %" of a share.
std::string percent_words(double share);

/// "0.123 ± 0.004", or the value alone where its error is not known.
std::string with_error(const Estimate& estimate, int decimals);

/// Judges the strongest false plates of series against those that noise alone makes; `should_alias`: the claim says
/// that they are stronger. std::nullopt if no series has a picture.
std::optional<ClaimOutcome> false_plates(const ClaimSeries& report, const std::vector<const ReportSeries*>& series,
                                         bool should_alias);

/// True where points follow a density that is not the same everywhere: spectra are then those of the density as well.
bool follows_density(const ReportSeries& series);

/// The series of a method that have the same density everywhere.
std::vector<const ReportSeries*> of_even_density(const ClaimSeries& report, const std::string& sampler,
                                                 SeriesQuery::Needs needs);

/// A time of 2006, and the series whose time today stands beside it.
struct TimedSeries
{
    std::string name; ///< "ρ = 0.70"; empty where there is one
    SeriesQuery query;
};

/// Times then and now: shown with device and threads, not judged. Left out where no series has a time.
PaperClaim time_claim(const std::string& id, const std::string& section, const std::string& says,
                      const std::vector<TimedSeries>& series);

/// The claim that sets reach the relative radius that was asked for.
PaperClaim reach_claim(const std::string& id, const std::string& section, const std::string& says,
                       const SeriesQuery& query, double relative_radius);

/// The features of a blue noise radial curve: little power at low frequencies, a peak near the principal frequency,
/// and power about 1 beyond.
struct BlueNoise
{
    bool holds = false;
    std::string words;
};
BlueNoise blue_noise(const ReportSeries& series);
inline constexpr auto blue_noise_criterion = "mean power below 0.2 up to half the principal frequency 1/d_min; the "
                                             "highest power within a quarter of it; mean power "
                                             "within 0.1 of 1 from 1.5 times it on";

/// The median time of a set of a series; nothing where it is not timed.
std::optional<double> median_seconds(const ReportSeries& series);

}
