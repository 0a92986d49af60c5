// Series in memory with known numbers, as the paper's claims ask for them.
#pragma once

#include "reports/claims/paper_claims.hpp"
#include "reports/layout/report_layout.hpp"
#include "tests/support/temporary_folder.hpp"

#include <deque>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab::test {

/// A radially averaged power that is `low` up to the principal frequency, where it rises to `peak` within `width` of
/// it, and 1 beyond; with an anisotropy this far above chance, and a ring of `spike` dB.
struct MadeUpCurve
{
    double low = 0.02, peak = 1.5, width = 0.1, beyond = 1;
    double anisotropy = 0;
    double spike = 0;    ///< dB above chance of one ring
    double scatter = 0;  ///< of anisotropy, up and down from ring to ring
    double error = 0.01; ///< of the power of each ring
};

/// Stored results are const to reports; those that are made up here are not.
Series& stored_of(ReportSeries& series);

/// Owns what it hands out.
class MadeUpReport
{
public:
    /// A series of K = 10 realizations. `parameters` are as stored.
    ReportSeries& add(const std::string& sampler, const NamedTexts& parameters, std::size_t points = 16384,
                      int dimension = 2);

    static void set_radius(ReportSeries& series, double radius);
    /// Sets the relative radius of each realization.
    static void set_radii(ReportSeries& series, const std::vector<double>& radii);
    static void set_curve(ReportSeries& series, const MadeUpCurve& curve);
    /// Sets the peaks of tilings with so many tiles along each axis; the error is a twentieth.
    static void set_peaks(ReportSeries& series, int tiles, double mean_ratio);
    /// Realizations lie alternately so much above and below the mean.
    static void set_iterations(ReportSeries& series, std::vector<double> mean_radius, double scatter = 0);
    /// The root mean square error below and above a quarter of a cycle per pixel.
    static void set_plate_error(ReportSeries& series, double low, double high);

    /// A picture of the zone plate with white noise and false rings of an amplitude.
    ReportSeries& add_plate(const std::string& sampler, const NamedTexts& parameters, double amplitude,
                            std::size_t points = 262144);

    /// A distribution or a scheme with these numbers, each with this error.
    DistributionResult& add_scheme(const std::string& kind, const std::map<std::string, double>& numbers,
                                   std::optional<double> error = {});

    std::vector<const ReportSeries*> series() const;
    std::vector<const DistributionResult*> schemes() const;

    /// The outcome of a claim; empty: the report has nothing for it.
    std::optional<ClaimOutcome> outcome(const std::string& claim) const;

private:
    std::deque<DistributionResult> schemes_;
    TemporaryFolder folder_; ///< of pictures
    std::mt19937_64 random_{1};
    std::deque<Run> runs_;
    std::deque<Series> stored_;
    std::deque<ReportSeries> series_;
};

}
