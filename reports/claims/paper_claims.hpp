// Claims that papers make about the methods of this laboratory, judged by the results of a report: Lagae's Tile-Based
// Methods in Computer Graphics (2007), with the articles on texture tiles that it follows, the class notes of 2008, and
// papers that came after it.
//
// A claim is data: where it stands, what it says, a criterion that the reader sees, and a function of the report's
// series. Criteria are standard errors where there are some, and else numbers that are stated. Seconds of 2006 are
// shown beside today's and not judged; frames a second are, as the text promises them.
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

inline Agreement agreement_if(bool holds) { return holds ? Agreement::agrees : Agreement::disagrees; }

struct ClaimOutcome
{
    Agreement agreement = Agreement::not_judged;
    std::string measured;
};

struct PaperClaim
{
    std::string id;      ///< "6.3-radius", unique among all papers
    std::string section; ///< "6.3"; empty: the paper as a whole
    std::string says;
    std::string criterion;
    std::function<std::optional<ClaimOutcome>(const ClaimSeries&)> measure; ///< empty: the report has nothing for it
};

struct Paper
{
    std::string key;   ///< "lagae-2007", for links
    std::string title; ///< as HTML: authors, title, year
    std::vector<PaperClaim> claims;
};

/// All papers, the dissertation first, then those that it follows, with their claims in the order of the sections.
const std::vector<Paper>& papers();

struct JudgedClaim
{
    const Paper* paper = nullptr;
    const PaperClaim* claim = nullptr;
    ClaimOutcome outcome;
};

/// The claims that series, distributions and schemes can answer, paper by paper. Throws InputError for pictures of the
/// zone plate that cannot be read.
std::vector<JudgedClaim> judge_claims(const std::vector<const ReportSeries*>& series,
                                      const std::vector<const DistributionResult*>& distributions = {});

/// The claims about tiles, tilings and hash functions (2.6, 3.2 to 3.5).
std::vector<PaperClaim> claims_about_tilings();

/// The claims about aperiodic sets (3.1, 8.3).
std::vector<PaperClaim> claims_about_aperiodic_sets();

/// The claims about methods without tiles (6.2 to 6.5, 6.15) and with tiles (6.7 to 6.11, 6.15).
std::vector<PaperClaim> claims_about_untiled_sets();
std::vector<PaperClaim> claims_about_accelerated_darts();
std::vector<PaperClaim> claims_about_early_tiles();
std::vector<PaperClaim> claims_about_recursive_tiles();
std::vector<PaperClaim> claims_about_penrose_tilings();
std::vector<PaperClaim> claims_about_tiles();
std::vector<PaperClaim> claims_about_patterns();

/// The claims about how long tile sets and large sets take to make (4.5, 6.3).
std::vector<PaperClaim> claims_about_building();

/// The claims about what tiles are for (4.7 and chapter 7).
std::vector<PaperClaim> claims_about_applications();

/// The claims about texture tiles (5.3, 5.4), and the articles that chapter 5 follows.
std::vector<PaperClaim> claims_about_textures();
std::vector<Paper> papers_on_textures();

/// The claims of the class notes about polyominoes (9.4).
std::vector<PaperClaim> claims_about_polyominoes();

/// The recommendations of section 6.16.
std::vector<PaperClaim> recommendations();

/// Papers of 2006 and later about methods that optimise sets, and point sets that were published.
std::vector<Paper> later_papers();

/// The effective Nyquist frequencies and oscillations of the series of a method, not judged.
PaperClaim nyquist_and_oscillation(const char* id, const char* says, const char* criterion, const char* sampler);

/// The claims about spectra that sets are asked for (Heck and others 2013).
std::vector<PaperClaim> claims_about_controlled_aliasing();

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
