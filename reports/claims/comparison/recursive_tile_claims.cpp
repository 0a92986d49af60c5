// The dissertation's claims about recursive Wang tiles: section 6.14.
#include "reports/claims/claim_words.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

using RecursiveOutcome = std::optional<ClaimOutcome>;

/// Series that draw each point once, of the same density everywhere; or those that draw levels twice.
std::vector<const ReportSeries*> recursive_series(const ClaimSeries& report, const std::string& drawing,
                                                  SeriesQuery::Needs needs = SeriesQuery::Needs::anything)
{
    auto found = of_even_density(report, "recursive-wang-tiles", needs);
    std::erase_if(found, [&](const ReportSeries* series) { return text_parameter(*series, "drawing") != drawing; });
    return found;
}

/// Tells whether most realizations have so small a radius. It is open where some have, and fewer than three are known.
Finding is_mostly_tiny(const Statistic& radius)
{
    constexpr double tiny = 0.001;
    if (radius.max < tiny) return Finding::holds;
    if (radius.min >= tiny) return Finding::fails;
    const auto few = std::ranges::count_if(radius.each, [](double r) { return r < tiny; });
    if (radius.each.size() < 3) return Finding::open;
    return finding_if(2 * static_cast<std::size_t>(few) >= radius.each.size());
}

/// The radius of sets drawn once, and beside it that of sets with points of two levels.
RecursiveOutcome radius_is_low(const ClaimSeries& report)
{
    Cases cases;
    std::vector<double> once, twice;
    for (const ReportSeries* series : recursive_series(report, "once"))
        if (const auto& radius = series->stored->relative_radius) {
            once.push_back(radius->min);
            cases.add(is_mostly_tiny(*radius));
        }
    for (const ReportSeries* series : recursive_series(report, "twice"))
        if (const auto& radius = series->stored->relative_radius) twice.push_back(radius->min);
    const std::string explained =
        twice.empty() ? "" : "with the points of two levels, some of which are the same, " + range_words(twice, 3);
    return cases.outcome(range_words(once, 2), explained);
}

RecursiveOutcome is_anisotropic(const ClaimSeries& report)
{
    return over(recursive_series(report, "once", SeriesQuery::Needs::spectrum), mean_excess_anisotropy, above(1), 1,
                " dB above chance");
}

RecursiveOutcome has_a_bad_spectrum(const ClaimSeries& report)
{
    Cases cases;
    for (const ReportSeries* series : recursive_series(report, "once", SeriesQuery::Needs::spectrum)) {
        const BlueNoise found = blue_noise(*series);
        cases.add(opposite(found.finding), found.words);
    }
    return cases.outcome();
}

}

std::vector<PaperClaim> claims_about_recursive_tiles()
{
    return {
        {"6.14-radius", "6.14",
         "The relative radius over a constant density is surprisingly low: 0.44 to less than 0.001, mostly the latter.",
         "below 0.001 in at least half of the realizations. The dissertation used the original tile set, these "
         "tiles are our own",
         radius_is_low},
        {"6.14-spectrum", "6.14", "The power spectrum is rather bad.",
         std::string("these features are not all there: ") + blue_noise_criterion, has_a_bad_spectrum},
        {"6.14-anisotropy", "6.14", "The anisotropy is rather high.",
         "more than 1 dB above chance on average over rings of at least 100 samples, by two standard errors",
         is_anisotropic},
        {"6.14-aliasing", "6.14", "The zone plate shows no structured aliasing artifacts.", no_false_plates_criterion,
         [](const ClaimSeries& report) {
             return false_plates(report, recursive_series(report, "once", SeriesQuery::Needs::plate), false);
         }},
        time_claim("6.14-time", "6.14", "Some 16,384 points take 1.005 s.",
                   {{"", {.sampler = "recursive-wang-tiles", .points = usual_points}}}),
    };
}

}
