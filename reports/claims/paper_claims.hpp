// Claims that chapter 6 of Lagae's Tile-Based Methods in Computer Graphics (2007) makes in words about the methods of
// this laboratory, judged by the results of a report.
//
// A claim is data: where it stands, what it says, a criterion that the reader sees, and a function of the report's
// series. Criteria are standard errors where there are some, and else numbers that are stated. Times of 2006 are shown
// beside today's and never judged.
#pragma once

#include "reports/claims/claim_series.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

enum class Agreement
{
    agrees,
    partly,
    disagrees,
    not_judged, ///< shown side by side
};

struct ClaimOutcome
{
    Agreement agreement = Agreement::not_judged;
    std::string measured;
};

struct PaperClaim
{
    std::string id;      ///< "6.3-radius", unique
    std::string section; ///< "6.3"
    std::string says;
    std::string criterion;
    std::function<std::optional<ClaimOutcome>(const ClaimSeries&)> measure; ///< empty: the report has no series for it
};

/// All claims, in the order of the sections.
const std::vector<PaperClaim>& paper_claims();

struct JudgedClaim
{
    const PaperClaim* claim = nullptr;
    ClaimOutcome outcome;
};

/// The claims that the series can answer. Throws InputError for pictures of the zone plate that cannot be read.
std::vector<JudgedClaim> judge_claims(const std::vector<const ReportSeries*>& series);

/// The claims about methods without tiles (6.2 to 6.5, 6.15) and with tiles (6.7 to 6.11, 6.15).
std::vector<PaperClaim> claims_about_untiled_sets();
std::vector<PaperClaim> claims_about_accelerated_darts();
std::vector<PaperClaim> claims_about_early_tiles();
std::vector<PaperClaim> claims_about_recursive_tiles();
std::vector<PaperClaim> claims_about_penrose_tilings();
std::vector<PaperClaim> claims_about_tiles();
std::vector<PaperClaim> claims_about_patterns();

/// What section 6.16 recommends.
std::vector<PaperClaim> recommendations();

/// Counts the cases in which a claim holds. All: it agrees; at least half: partly.
class Tally
{
public:
    void add(bool holds)
    {
        ++cases_;
        held_ += holds ? 1 : 0;
    }
    bool empty() const { return cases_ == 0; }
    Agreement agreement() const;
    /// "holds in 40 of 42 cases", or nothing where there is one.
    std::string words() const;

private:
    int cases_ = 0, held_ = 0;
};

}
