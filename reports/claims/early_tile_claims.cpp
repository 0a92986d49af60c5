// The dissertation's claims about tiles with points before Poisson disk tiles: sections 6.6 and 6.7.
#include "reports/claims/claim_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace poissonlab {
namespace {

using EarlyOutcome = std::optional<ClaimOutcome>;

/// Fewer points than elsewhere, or more, by a fifth and more somewhere near the borders of tiles.
constexpr double visible_seam = 0.2;

EarlyOutcome seams_of_darts(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> deviations;
    for (const ReportSeries* series : report.all({.sampler = "shade-tiles"})) {
        const auto& numbers = series->stored->measures.numbers;
        const auto found = numbers.find("seam_density");
        if (found == numbers.end()) continue;
        deviations.push_back(found->second.value);
        tally.add(found->second.value > visible_seam);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{
        tally.agreement(),
        joined_words({fmt::format("the density deviates by {}", range_words(deviations, 2)), tally.words()})};
}

/// Averaged tiles of as many iterations as the dissertation has.
std::vector<const ReportSeries*> averaged(const ClaimSeries& report)
{
    auto found = report.all({.sampler = "averaged-tiles"});
    std::erase_if(found, [](const ReportSeries* series) {
        return number_parameter(*series, "iterations").value_or(0) < 29 || !series->stored->relative_radius;
    });
    return found;
}

/// The relative radius of tilings is that across tiles, the smaller one.
EarlyOutcome small_radius_across(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> radii;
    for (const ReportSeries* series : averaged(report)) {
        radii.push_back(series->stored->relative_radius->min);
        tally.add(radii.back() <= 0.45);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(),
                        joined_words({range_words(radii, 2) + " in the worst realization", tally.words()})};
}

/// Over the last ten iterations it still changes by more than a hundredth.
EarlyOutcome does_not_converge(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> changes;
    for (const ReportSeries* series : averaged(report)) {
        if (!series->stored->iterations) continue;
        const std::vector<double>& values = series->stored->iterations->relative_radius.mean;
        if (values.size() < 30) continue;
        const auto [least, most] = std::ranges::minmax(std::span(values).last(10));
        changes.push_back(most - least);
        tally.add(changes.back() > 0.01);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(),
                        joined_words({range_words(changes, 2) + " in ten iterations", tally.words()})};
}

}

std::vector<PaperClaim> claims_about_early_tiles()
{
    return {
        {"6.6-flawed", "6.6",
         "Darts that keep away from all tiles that may lie beside leave too few points near edges and corners.",
         "somewhere near the borders of tiles the density deviates from its mean by more than a fifth", seams_of_darts},
        {"6.7-across", "6.7",
         "The relative radius across tiles that are relaxed in the mean of their surroundings is often 0.40 or less.",
         "the smallest one of all realizations is at most 0.45, after 29 iterations or more", small_radius_across},
        {"6.7-converges", "6.7", "Relaxation in the mean of all surroundings does not converge.",
         "within the last ten iterations the relative radius changes by more than 0.01", does_not_converge},
    };
}

}
