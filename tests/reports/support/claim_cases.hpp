// Results for each claim of the papers that agree with it, that disagree, and that leave it open; and the series that
// they are made of.
#pragma once

#include "tests/reports/support/made_up_series.hpp"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace poissonlab::test {

/// The finding that made-up results should lead to.
enum class Told
{
    agreement,
    disagreement,
    nothing, ///< they leave it open
};

/// The value by which results agree, disagree, or leave a claim open.
template <class T>
T told(Told what, T agrees, T disagrees, T open)
{
    return what == Told::agreement ? agrees : what == Told::disagreement ? disagrees : open;
}

struct ClaimCase
{
    enum class Kind
    {
        judged,       ///< open results have the verdict "open"
        exact,        ///< what is counted has no errors: it is open where it was not counted, and the claim is left out
        only_refuted, ///< no result proves it
        shown,        ///< by all results
    };

    std::string id;
    std::function<void(MadeUpReport&, Told)> results;
    Kind kind = Kind::judged;
};

inline void PrintTo(const ClaimCase& claim, std::ostream* out) { *out << claim.id; }

/// The cases of all claims, by sections of the dissertation and by papers.
std::vector<ClaimCase> all_claim_cases();
std::vector<ClaimCase> cases_of_tilings();      ///< chapters 2, 3 and 8
std::vector<ClaimCase> cases_of_applications(); ///< 4.5, 4.7 and chapter 7
std::vector<ClaimCase> cases_of_textures();     ///< chapter 5
std::vector<ClaimCase> cases_of_untiled_sets(); ///< 6.2 to 6.4
std::vector<ClaimCase> cases_of_lloyd();        ///< 6.5
std::vector<ClaimCase> cases_of_early_tiles();  ///< 6.6 to 6.8
std::vector<ClaimCase> cases_of_edge_tiles();   ///< peaks of 6.7, and 6.9
std::vector<ClaimCase> cases_of_template_tiles();
std::vector<ClaimCase> cases_of_corner_tiles();
std::vector<ClaimCase> cases_of_accelerated_darts(); ///< 6.12 to 6.14
std::vector<ClaimCase> cases_of_spheres();           ///< 6.15
std::vector<ClaimCase> cases_of_recommendations();   ///< 6.16
std::vector<ClaimCase> cases_of_later_papers();

ReportSeries& darts(MadeUpReport& report, const std::string& rho, std::size_t points = 16384, int dimension = 2);
ReportSeries& full_darts(MadeUpReport& report, int dimension = 2);
ReportSeries& jones(MadeUpReport& report, std::size_t points = 16384);
ReportSeries& relaxation(MadeUpReport& report, const std::string& factor, const std::string& attempts,
                         std::size_t points = 16384, int dimension = 2);
ReportSeries& lloyd(MadeUpReport& report, int iterations, std::size_t points = 16384, int dimension = 2);
void set_number(ReportSeries& series, const std::string& key, double value);
void set_number(ReportSeries& series, const std::string& key, double value, double error);
void set_oscillation(ReportSeries& series, double value, double error = 0.01);
ReportSeries& with_target(MadeUpReport& report, const std::string& target, double nyquist);

/// Three tile sets, with peaks whose error is a twentieth. `speckle`: anisotropy between the peaks, in dB above chance.
ReportSeries& tiles(MadeUpReport& report, const std::string& kind, int set, int points_per_tile, double mean_peak,
                    double speckle = 1);
/// One tile set instead of three.
void have_one_set(ReportSeries& series);
void set_seconds(ReportSeries& series, double seconds);

/// Radii from `start` to `end`, there after so many of 128 iterations.
std::vector<double> relaxed(double start, double end, int settled, int iterations = 128);

}
