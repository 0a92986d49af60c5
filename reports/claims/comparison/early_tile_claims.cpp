// The dissertation's claims about tiles with points before Poisson disk tiles: sections 6.6 and 6.7.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/tile_spectra.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace poissonlab {
namespace {

using EarlyOutcome = std::optional<ClaimOutcome>;

/// Judges whether Shade's tiles have fewer points near their borders than elsewhere, not only more or fewer: the points
/// of later papers crowd there.
EarlyOutcome too_few_at_borders(const ClaimSeries& report)
{
    constexpr double noticeably_lower = 0.9;
    Cases cases;
    std::vector<double> densities;
    for (const ReportSeries* series : report.all({.sampler = "shade-tiles"}))
        if (const Estimate* density = estimate_of(*series, "border_density")) {
            densities.push_back(density->value);
            cases.add(density->value < noticeably_lower ? Finding::holds
                      : density->value < 1              ? Finding::open
                                                        : Finding::fails);
        }
    return cases.outcome(range_words(densities, 2) + " of the mean density");
}

/// Tiles that move by the mean of all surroundings, as Hiller and others have them; not by one at a time.
std::vector<const ReportSeries*> averaged(const ClaimSeries& report,
                                          SeriesQuery::Needs needs = SeriesQuery::Needs::anything)
{
    auto found = report.all({.sampler = "averaged-tiles", .needs = needs});
    std::erase_if(found,
                  [](const ReportSeries* series) { return text_parameter(*series, "variant") == "one-surrounding"; });
    return found;
}

/// Finds the averaged tiles of as many iterations as the dissertation has.
std::vector<const ReportSeries*> averaged_as_in_the_paper(const ClaimSeries& report)
{
    auto found = averaged(report);
    std::erase_if(found, [](const ReportSeries* series) {
        return number_parameter(*series, "iterations") != 29 || !series->stored->relative_radius;
    });
    return found;
}

/// The relative radius of tilings is that across tiles, the smaller one.
EarlyOutcome small_radius_across(const ClaimSeries& report)
{
    constexpr std::size_t fewest = 3;
    constexpr double small = 0.40;
    std::vector<double> radii;
    for (const ReportSeries* series : averaged_as_in_the_paper(report))
        radii.push_back(series->stored->relative_radius->min);
    if (radii.empty()) return std::nullopt;
    const auto held = static_cast<std::size_t>(std::ranges::count_if(radii, [](double r) { return r <= small; }));
    const std::string words = fmt::format("{} in the worst realization; at most {} in {} of {} series",
                                          range_words(radii, 2), format_exact(small), held, radii.size());
    if (radii.size() < fewest) return ClaimOutcome{Agreement::open, words};
    return ClaimOutcome{2 * held >= radii.size()   ? Agreement::agrees
                        : 4 * held >= radii.size() ? Agreement::partly
                                                   : Agreement::disagrees,
                        words};
}

/// Points of one tile alone.
EarlyOutcome large_radius_within(const ClaimSeries& report)
{
    return over(averaged_as_in_the_paper(report), measured("relative_radius_within_tiles"), within(0.75, 0.85), 2);
}

/// Thirty iterations, as the dissertation has, do not tell whether it settles: longer ones refute it.
EarlyOutcome does_not_converge(const ClaimSeries& report)
{
    constexpr std::size_t iterations_that_tell = 500, last_of_few = 10;
    constexpr double settled = 0.002;
    Tally tally;
    std::vector<std::string> words;
    std::vector<double> few; ///< changes of series that do not tell
    const auto change_in_last = [](const std::vector<double>& values, std::size_t count) {
        const auto [least, most] = std::ranges::minmax(std::span(values).last(count));
        return most - least;
    };
    for (const ReportSeries* series : averaged(report, SeriesQuery::Needs::iterations)) {
        const std::vector<double>& values = series->stored->iterations->relative_radius.mean;
        if (values.size() <= last_of_few) continue;
        if (values.size() <= iterations_that_tell) {
            few.push_back(change_in_last(values, last_of_few));
            continue;
        }
        const double change = change_in_last(values, values.size() / 4);
        // Between these it may settle still.
        tally.add(change > 5 * settled ? Finding::holds : change > settled ? Finding::open : Finding::fails);
        words.push_back(fmt::format("{}: {} after {} iterations, {} up and down in the last quarter", series->label,
                                    format_fixed(values.back(), 3), values.size() - 1, format_significant(change, 2)));
    }
    if (tally.empty() && few.empty()) return std::nullopt;
    if (!few.empty())
        words.push_back(
            fmt::format("{} up and down in the last {} of few iterations", range_words(few, 2), last_of_few));
    if (!tally.empty()) words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

/// Every series of averaged tiles against every one of the methods before it in the text.
EarlyOutcome spectra_are_bad(const ClaimSeries& report)
{
    using Needs = SeriesQuery::Needs;
    Cases cases;
    std::vector<Estimate> own, others;
    for (const ReportSeries* series : averaged(report, Needs::spectrum)) own.push_back(mean_excess_anisotropy(*series));
    for (const char* sampler : {"dart-throwing", "relaxation-dart-throwing", "lloyd"})
        for (const ReportSeries* series :
             report.all({.sampler = sampler, .points = usual_points, .needs = Needs::spectrum}))
            others.push_back(mean_excess_anisotropy(*series));
    for (const Estimate& one : own)
        for (const Estimate& other : others) cases.add(is_above(difference_of(one, other), 0));
    return cases.outcome(
        joined_words({range_words(own, 2) + " dB above chance", "methods without tiles " + range_words(others, 2)}));
}

std::vector<const ReportSeries*> averaged_plates(const ClaimSeries& report)
{
    return averaged(report, SeriesQuery::Needs::plate);
}

EarlyOutcome low_frequencies(const ClaimSeries& report) { return shown_plate_errors(report, averaged_plates(report)); }

}

std::vector<PaperClaim> claims_about_early_tiles()
{
    return {
        {"6.6-flawed", "6.6",
         "Darts that keep away from all tiles that may lie beside leave too few points near edges and corners.",
         "within a disk's radius of the borders of tiles the density is below 0.9 of its mean; open up to 1",
         too_few_at_borders},
        {"6.7-within", "6.7",
         "The relative radius within tiles that are relaxed in the mean of their surroundings is about 0.80.",
         "from 0.75 to 0.85 after the paper's 29 iterations, for each number of points a tile", large_radius_within},
        {"6.7-across", "6.7",
         "The relative radius across tiles that are relaxed in the mean of their surroundings is often 0.40 or less.",
         "the smallest one of all realizations is at most 0.40 in half of the series, after the paper's 29 iterations; "
         "partly: in a quarter; open with fewer than three numbers of points a tile",
         small_radius_across},
        {"6.7-converges", "6.7",
         "The relative radius across tiles that are relaxed in the mean of all surroundings does not seem to converge.",
         "within the last quarter of more than 500 iterations it changes by more than 0.01; refuted by a change of at "
         "most "
         "0.002. The paper's 29 iterations leave it open, since what still changes then may settle",
         does_not_converge},
        {"6.7-spectra", "6.7",
         "The spectra of averaged tiles are relatively bad, compared with those of the methods without tiles.",
         "more anisotropy above chance on average over rings of at least 100 samples than dart throwing, relaxation "
         "dart throwing and Lloyd relaxation, series by series, by two standard errors",
         spectra_are_bad},
        {"6.7-low", "6.7", "Averaged tiles reproduce the low-frequency region of the zone plate relatively well.",
         shown_plate_errors_criterion, low_frequencies},
        {"6.7-plate", "6.7",
         "Averaged tiles show severe structured aliasing in the high-frequency region of the zone plate.",
         false_plates_criterion,
         [](const ClaimSeries& report) { return false_plates(report, averaged_plates(report), true); }},
    };
}

}
