// Claims of the SIGGRAPH 2008 class notes about sampling with polyominoes: section 9.4 of their second part, on
// substitution tilings.
#include "reports/claims/claim_words.hpp"

namespace poissonlab {
namespace {

using PolyominoOutcome = std::optional<ClaimOutcome>;

constexpr double spike_db = 10; ///< above chance, as for the star of Penrose tilings

/// The height of the most anisotropic ring of each series above chance, in dB.
std::vector<Estimate> strongest_rings(const ClaimSeries& report, const char* sampler)
{
    std::vector<Estimate> rings;
    for (const ReportSeries* series : of_even_density(report, sampler, SeriesQuery::Needs::spectrum))
        rings.push_back(peak_excess_anisotropy(*series));
    return rings;
}

PolyominoOutcome have_no_spikes(const ClaimSeries& report)
{
    return over(of_even_density(report, "polyominoes", SeriesQuery::Needs::spectrum), peak_excess_anisotropy,
                below(spike_db), 3, " dB above chance");
}

/// Every series of polyominoes beside every Penrose tiling.
PolyominoOutcome have_weaker_spikes(const ClaimSeries& report)
{
    const std::vector<Estimate> rings = strongest_rings(report, "polyominoes");
    const std::vector<Estimate> of_penrose = strongest_rings(report, "penrose");
    Cases cases;
    for (const Estimate& ring : rings)
        for (const Estimate& other : of_penrose) cases.add(is_below(difference_of(ring, other), -1));
    return cases.outcome(
        joined_words({range_words(rings, 3) + " dB above chance", "Penrose tilings " + range_words(of_penrose, 3)}));
}

/// Shows the times of polyominoes beside those of dart throwing, for some 16,384 points.
PolyominoOutcome are_fast(const ClaimSeries& report)
{
    if (of_even_density(report, "polyominoes", SeriesQuery::Needs::anything).empty()) return std::nullopt;
    return shown_times(report, {"polyominoes", "dart-throwing"});
}

}

std::vector<PaperClaim> claims_about_polyominoes()
{
    return {
        {"notes-2008-fast", "9.4", "Substitution tilings give sampling patterns fast.", shown_times_criterion,
         are_fast},
        {"notes-2008-blue-noise", "9.4", "Sampling patterns of substitution tilings have blue noise properties.",
         blue_noise_criterion,
         [](const ClaimSeries& report) {
             return all_blue_noise(of_even_density(report, "polyominoes", SeriesQuery::Needs::spectrum));
         }},
        {"notes-2008-no-artifacts", "9.4", "Polyominoes avoid artifacts in the frequency domain.",
         "in no ring the anisotropy is more than 10 dB above chance, which is how the star of Penrose tilings is "
         "known, by "
         "two standard errors",
         have_no_spikes},
        {"notes-2008-penrose", "9.4", "Polyominoes avoid the artifacts that arose in the use of Penrose tiles.",
         "the most anisotropic ring lies more than 1 dB lower than that of every Penrose tiling, by two standard "
         "errors",
         have_weaker_spikes},
    };
}

}
