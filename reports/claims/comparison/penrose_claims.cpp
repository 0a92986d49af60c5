// The dissertation's claims about Penrose tilings: section 6.8.
#include "reports/claims/claim_words.hpp"

namespace poissonlab {
namespace {

using PenroseOutcome = std::optional<ClaimOutcome>;

/// The dissertation has Penrose tilings of the same density everywhere.
std::vector<const ReportSeries*> even_penrose(const ClaimSeries& report, SeriesQuery::Needs needs)
{
    return of_even_density(report, "penrose", needs);
}

PenroseOutcome radius_of_penrose(const ClaimSeries& report)
{
    Cases cases;
    std::vector<double> radii;
    for (const ReportSeries* series : even_penrose(report, SeriesQuery::Needs::anything)) {
        if (!series->stored->relative_radius) continue;
        const Statistic& radius = *series->stored->relative_radius;
        radii.insert(radii.end(), {radius.min, radius.max});
        const bool within = radius.min >= 0.65 && radius.max <= 0.75;
        const bool beyond = radius.max < 0.65 || radius.min > 0.75;
        cases.add(within ? Finding::holds : beyond ? Finding::fails : Finding::open);
    }
    return cases.outcome(range_words(radii, 3));
}

PenroseOutcome spikes_of_penrose(const ClaimSeries& report)
{
    return over(even_penrose(report, SeriesQuery::Needs::spectrum), peak_excess_anisotropy, above(10), 3,
                " dB above chance");
}

PenroseOutcome more_anisotropic_than_tiles(const ClaimSeries& report)
{
    Cases cases;
    std::vector<Estimate> of_penrose, of_tiles;
    for (const ReportSeries* series : even_penrose(report, SeriesQuery::Needs::spectrum))
        of_penrose.push_back(mean_excess_anisotropy(*series));
    for (const char* sampler : {"edge-tiles", "corner-tiles"})
        for (const ReportSeries* series : report.all({.sampler = sampler, .needs = SeriesQuery::Needs::spectrum}))
            of_tiles.push_back(mean_excess_anisotropy(*series));
    for (const Estimate& one : of_penrose)
        for (const Estimate& other : of_tiles) cases.add(is_above(difference_of(one, other), 1));
    return cases.outcome(joined_words(
        {range_words(of_penrose, 2) + " dB above chance on average", "tiles " + range_words(of_tiles, 2)}));
}

PenroseOutcome plate_of_penrose(const ClaimSeries& report)
{
    return false_plates(report, even_penrose(report, SeriesQuery::Needs::plate), true);
}

}

std::vector<PaperClaim> claims_about_penrose_tilings()
{
    return {
        {"6.8-radius", "6.8", "The relative radii of Penrose tilings vary between 0.65 and 0.75.",
         "the smallest and the largest of all realizations are within these limits, at a constant density; open where "
         "one "
         "of them is",
         radius_of_penrose},
        {"6.8-star", "6.8", "The periodogram of Penrose tilings has a star-like pattern of large spikes.",
         "in some ring the anisotropy is more than 10 dB above chance, by two standard errors", spikes_of_penrose},
        {"6.8-anisotropy", "6.8",
         "The anisotropy of Penrose tilings is significantly higher than that of edge-based and corner-based tiles.",
         "more than 1 dB higher on average over rings than that of every series of such tiles, by two standard errors",
         more_anisotropic_than_tiles},
        {"6.8-low", "6.8", "Penrose tilings reproduce the low-frequency region of the zone plate relatively well.",
         shown_plate_errors_criterion,
         [](const ClaimSeries& report) {
             return shown_plate_errors(report, even_penrose(report, SeriesQuery::Needs::plate));
         }},
        {"6.8-plate", "6.8", "The zone plate shows severe structured aliasing.", false_plates_criterion,
         plate_of_penrose},
        time_claim("6.8-time", "6.8", "16,384 points take 0.192 seconds.",
                   {{"", {.sampler = "penrose", .points = usual_points}}}),
    };
}

}
