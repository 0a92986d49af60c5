// Claims of section 6.2 about the methods of analysis themselves: spectra of random points and of Poisson disks, and
// what aliases.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using MethodologyOutcome = std::optional<ClaimOutcome>;

/// The probability that chance alone puts some ring as far from 1; empty: no error is stored.
struct FurthestRing
{
    double errors_away = -1;
    double p = 1;
};

FurthestRing furthest_ring(const ReportSeries& series)
{
    FurthestRing found;
    for (const RadialBin& bin : series.curve.bins)
        if (bin.power_error > 0)
            found.errors_away = std::max(found.errors_away, std::abs(bin.power - 1) / bin.power_error);
    if (found.errors_away < 0) return found;
    const boost::math::students_t distribution(series.stored->realizations - 1);
    found.p = std::min(1.0, 2 * boost::math::cdf(boost::math::complement(distribution, found.errors_away)) *
                                static_cast<double>(series.curve.bins.size()));
    return found;
}

MethodologyOutcome flat_spectrum(const ClaimSeries& report)
{
    constexpr double rejected = 0.001, doubted = 0.01;
    Cases cases;
    for (const ReportSeries* series : report.all({.sampler = "random", .needs = SeriesQuery::Needs::spectrum})) {
        if (series->stored->realizations < 2) continue;
        const FurthestRing furthest = furthest_ring(*series);
        if (furthest.errors_away < 0) continue;
        cases.add(furthest.p > doubted    ? Finding::holds
                  : furthest.p < rejected ? Finding::fails
                                          : Finding::open,
                  fmt::format("of {} rings the furthest from 1 is {} standard errors away, p = {}",
                              format_count(series->curve.bins.size()), format_fixed(furthest.errors_away, 1),
                              format_significant(furthest.p, 2)));
    }
    return cases.outcome();
}

/// The picture of regular points against that of jittered ones.
MethodologyOutcome aliasing_becomes_noise(const ClaimSeries& report)
{
    Cases cases;
    for (const auto* regular : report.all({.sampler = "regular", .needs = SeriesQuery::Needs::plate}))
        for (const auto* jittered : report.all({.sampler = "jittered", .needs = SeriesQuery::Needs::plate})) {
            const auto a = report.false_rings(*regular), b = report.false_rings(*jittered);
            if (!a || !b) continue;
            const double strong = std::max(a->strength, a->at_the_plate);
            cases.add(both(finding_if(strong >= 100 * std::max(b->strength, b->at_the_plate)),
                           opposite(*finds_false_plates(report, *jittered))),
                      fmt::format("{} times the noise around it, against {}; noise alone gives up to {}",
                                  format_significant(strong, 2), format_significant(b->strength, 2),
                                  format_significant(b->bound, 2)));
        }
    return cases.outcome();
}

}

std::vector<PaperClaim> claims_about_methodology()
{
    const auto spectra_of = [](const ClaimSeries& report, const char* sampler) {
        return report.all({.sampler = sampler, .needs = SeriesQuery::Needs::spectrum});
    };
    return {
        {"6.2.2-flat", "6.2.2", "The spectrum of a Poisson distribution is flat.",
         "no ring is further from 1 than chance makes it once in 100 (Student's t, corrected for the number of rings); "
         "open down to once in 1,000",
         flat_spectrum},
        {"6.2.2-poisson-anisotropy", "6.2.2",
         "The anisotropy of a Poisson distribution is close to −10 dB: radial symmetry.", low_anisotropy_criterion,
         [=](const ClaimSeries& report) { return has_low_anisotropy(spectra_of(report, "random")); }},
        {"6.2.2-disk-anisotropy", "6.2.2", "The anisotropy of a Poisson disk distribution is close to −10 dB as well.",
         low_anisotropy_criterion,
         [=](const ClaimSeries& report) { return has_low_anisotropy(spectra_of(report, "dart-throwing")); }},
        {"6.2.2-blue-noise", "6.2.2",
         "A Poisson disk distribution has little power at low frequencies, a sharp rise at the principal frequency, "
         "and is flatter beyond.",
         blue_noise_criterion, [](const ClaimSeries& report) { return all_blue_noise(darts_as_large(report, 0.75)); }},
        {"6.2.3-aliasing", "6.2.3",
         "A regular pattern aliases: false rings in the zone plate. A stratified one trades them for noise.",
         "the strongest false plate of regular points is at least 100 times as strong as that of jittered ones, of "
         "which none away from the origin is stronger than noise makes once in 100 pictures",
         aliasing_becomes_noise},
    };
}

}
