// Claims of the SIGGRAPH 2008 class notes about sampling with polyominoes: section 9.4 of their second part, on
// substitution tilings.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace poissonlab {
namespace {

using PolyominoOutcome = std::optional<ClaimOutcome>;

constexpr double spike_db = 10; ///< above chance, as for the star of Penrose tilings

/// The height of the most anisotropic ring of each series above chance, in dB.
std::vector<double> strongest_rings(const ClaimSeries& report, const char* sampler)
{
    std::vector<double> rings;
    for (const ReportSeries* series : of_even_density(report, sampler, SeriesQuery::Needs::spectrum))
        rings.push_back(peak_anisotropy(*series) - series->curve.background_db);
    return rings;
}

PolyominoOutcome have_no_spikes(const ClaimSeries& report)
{
    const std::vector<double> rings = strongest_rings(report, "polyominoes");
    if (rings.empty()) return std::nullopt;
    Tally tally;
    for (const double ring : rings) tally.add(ring <= spike_db);
    return ClaimOutcome{tally.agreement(), joined_words({range_words(rings, 3) + " dB above chance", tally.words()})};
}

/// Every series of polyominoes beside every Penrose tiling.
PolyominoOutcome have_weaker_spikes(const ClaimSeries& report)
{
    const std::vector<double> rings = strongest_rings(report, "polyominoes");
    const std::vector<double> of_penrose = strongest_rings(report, "penrose");
    if (rings.empty() || of_penrose.empty()) return std::nullopt;
    Tally tally;
    for (const double ring : rings)
        for (const double other : of_penrose) tally.add(ring < other - 1);
    return ClaimOutcome{tally.agreement(),
                        joined_words({range_words(rings, 3) + " dB above chance",
                                      "Penrose tilings " + range_words(of_penrose, 3), tally.words()})};
}

PolyominoOutcome are_blue_noise(const ClaimSeries& report)
{
    Tally tally;
    std::vector<std::string> words;
    for (const ReportSeries* series : of_even_density(report, "polyominoes", SeriesQuery::Needs::spectrum)) {
        const BlueNoise found = blue_noise(*series);
        tally.add(found.holds);
        if (std::ranges::find(words, found.words) == words.end()) words.push_back(found.words);
    }
    if (tally.empty()) return std::nullopt;
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

/// Against dart throwing of nearly as many points, in the same report and on the same machine.
PolyominoOutcome are_fast(const ClaimSeries& report)
{
    Tally tally;
    std::vector<std::string> words;
    for (const ReportSeries* series : of_even_density(report, "polyominoes", SeriesQuery::Needs::anything)) {
        const auto seconds = median_seconds(*series);
        for (const ReportSeries* darts : report.all({.sampler = "dart-throwing", .points = series->stored->points})) {
            const auto of_darts = median_seconds(*darts);
            if (!seconds || !of_darts) continue;
            tally.add(*seconds < *of_darts);
            words.push_back(fmt::format("{}: {} ms, dart throwing {} ms", series->label,
                                        format_significant(1000 * *seconds, 2),
                                        format_significant(1000 * *of_darts, 2)));
        }
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

}

std::vector<PaperClaim> claims_about_polyominoes()
{
    return {
        {"notes-2008-fast", "9.4", "Substitution tilings give sampling patterns fast.",
         "polyominoes take less time than dart throwing of as many points", are_fast},
        {"notes-2008-blue-noise", "9.4", "Sampling patterns of substitution tilings have blue noise properties.",
         blue_noise_criterion, are_blue_noise},
        {"notes-2008-no-artifacts", "9.4", "Polyominoes avoid artifacts in the frequency domain.",
         "in no ring the anisotropy is more than 10 dB above chance, which is how the star of Penrose tilings is known",
         have_no_spikes},
        {"notes-2008-penrose", "9.4", "Polyominoes avoid the artifacts that arose in the use of Penrose tiles.",
         "the most anisotropic ring lies more than 1 dB lower than that of a Penrose tiling", have_weaker_spikes},
    };
}

}
