// Claims that papers make about the methods of this laboratory, judged by the results of a report: Lagae's Tile-Based
// Methods in Computer Graphics (2007), with the articles on texture tiles that it follows, the class notes of 2008, and
// papers that came after it.
//
// A claim is data: where it stands, what it says, a criterion that the reader sees, and a function of the report's
// series. A claim is judged only where results could refute it; what depends on the machine, such as times, and what
// follows from how tiles are made is shown. Criteria are standard errors where there are some, and else numbers that
// are stated. Values within two standard errors of a limit leave a claim open, and so do comparisons of tile sets where
// there is one of each: sets of the same parameters differ. tests/reports/claims has results for each claim that agree,
// that disagree, and that leave it open.
#pragma once

#include "reports/claims/claim_series.hpp"
#include "reports/claims/findings.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

struct ClaimOutcome
{
    Agreement agreement = Agreement::shown;
    std::string measured;
};

struct PaperClaim
{
    std::string id;      ///< "6.3-radius", unique among all papers
    std::string section; ///< "6.3"; empty: the paper as a whole
    std::string says;
    std::string criterion;                                                  ///< of claims that are shown: what is shown
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
    std::vector<std::string> samplers = {}; ///< of the methods that it looked for
};

/// The claims that series, distributions and schemes can answer, paper by paper. Throws InputError for pictures of the
/// zone plate that cannot be read.
std::vector<JudgedClaim> judge_claims(const std::vector<const ReportSeries*>& series,
                                      const std::vector<const DistributionResult*>& distributions = {});

/// All claims of the dissertation about tiles, tilings and what they are for, and the papers on tiles after it. In a
/// program without tiles a claim stands in for these, which asks for the module where results have tiles.
std::vector<PaperClaim> claims_about_tiles();
std::vector<Paper> papers_on_tiles();

/// The claims about tiles, tilings and hash functions (2.6, 3.2 to 3.5).
std::vector<PaperClaim> claims_about_tilings();

/// The claims about aperiodic sets (3.1, 8.3).
std::vector<PaperClaim> claims_about_aperiodic_sets();

/// The claims about methods of analysis (6.2), methods without tiles (6.3 to 6.5, 6.12, 6.13, 6.15), with tiles (6.6 to
/// 6.11, 6.14) and in space (6.15).
std::vector<PaperClaim> claims_about_methodology();
std::vector<PaperClaim> claims_about_darts();
std::vector<PaperClaim> claims_about_lloyd();
std::vector<PaperClaim> claims_about_spheres();
std::vector<PaperClaim> claims_about_jones();
std::vector<PaperClaim> claims_about_sector_darts();
std::vector<PaperClaim> claims_about_early_tiles();
std::vector<PaperClaim> claims_about_recursive_tiles();
std::vector<PaperClaim> claims_about_penrose_tilings();
std::vector<PaperClaim> claims_about_peaks();
std::vector<PaperClaim> claims_about_edge_tiles();
std::vector<PaperClaim> claims_about_template_tiles();
std::vector<PaperClaim> claims_about_corner_tiles();

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

/// Gabrielli and others (2008), about moments that tiles have in common.
Paper paper_on_even_tilings();

/// The effective Nyquist frequencies and oscillations of the series of a method: shown.
PaperClaim nyquist_and_oscillation(const char* id, const char* says, const char* criterion, const char* sampler);

/// The claims about spectra that sets are asked for (Heck and others 2013).
std::vector<PaperClaim> claims_about_controlled_aliasing();

}
