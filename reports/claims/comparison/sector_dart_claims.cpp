// The dissertation's claims about the darts of Dunbar and Humphreys: section 6.13.
#include "analysis/statistics/welch.hpp"
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/dart_comparisons.hpp"
#include "reports/claims/comparison/lloyd_series.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using DartOutcome = std::optional<ClaimOutcome>;
using DartNeeds = SeriesQuery::Needs;
using DartSeries = std::vector<const ReportSeries*>;
using DartPair = std::pair<const ReportSeries*, const ReportSeries*>;

DartSeries sector_darts(const ClaimSeries& report, const std::string& variant, DartNeeds needs)
{
    auto found = report.all({.sampler = "sector-darts", .needs = needs});
    std::erase_if(found, [&](const ReportSeries* series) { return text_parameter(*series, "variant") != variant; });
    return found;
}

/// Dart throwing until nothing fits, as sector darts are.
DartSeries full_darts(const ClaimSeries& report, DartNeeds needs)
{
    auto found = report.all({.sampler = "dart-throwing", .needs = needs});
    std::erase_if(found, [](const ReportSeries* series) { return text_parameter(*series, "stop") != "saturation"; });
    return found;
}

/// The logarithmic variant beside dart throwing of as many points: of any radius, since full sets have their own.
DartOutcome logarithmic_plates(const ClaimSeries& report)
{
    std::vector<DartPair> pairs;
    for (const ReportSeries* own : sector_darts(report, "logarithmic", DartNeeds::plate))
        for (const ReportSeries* darts :
             report.all({.sampler = "dart-throwing", .points = own->stored->points, .needs = DartNeeds::plate}))
            if (darts->stored->relative_radius && darts->stored->relative_radius->min > 0.745)
                pairs.emplace_back(own, darts);
    return plates_alike(pairs);
}

DartOutcome like_dart_throwing(const ClaimSeries& report)
{
    Cases cases;
    std::vector<Estimate> distances;
    for (const ReportSeries* own : sector_darts(report, "logarithmic", DartNeeds::spectrum))
        for (const ReportSeries* darts : full_darts(report, DartNeeds::spectrum))
            if (const auto distance = distance_of_curves(*own, *darts)) {
                distances.push_back(*distance);
                cases.add(is_below(*distance, 0.05));
            }
    return cases.outcome(range_words(distances, 2) + " on average");
}

/// The power around twice the principal frequency, where the second peak of radial curves is: of full sets, whose
/// minimum distance is the one that was asked for.
std::optional<Estimate> second_peak(const ReportSeries& series)
{
    const auto principal = series.curve.principal_frequency;
    return principal ? mean_power(series, 1.9 * *principal, 2.3 * *principal) : std::nullopt;
}

DartOutcome larger_peaks(const ClaimSeries& report, const std::string& variant, double factor)
{
    Cases cases;
    for (const ReportSeries* own : sector_darts(report, variant, DartNeeds::spectrum))
        for (const ReportSeries* darts : full_darts(report, DartNeeds::spectrum)) {
            const auto power = second_peak(*own), other = second_peak(*darts);
            if (!power || !other) continue;
            cases.add(is_above(ratio_of(*power, *other), factor),
                      fmt::format("{} around the second peak, dart throwing {}", with_error(*power, 3),
                                  with_error(*other, 3)));
        }
    return cases.outcome();
}

DartOutcome is_skew(const ClaimSeries& report)
{
    return over(sector_darts(report, "linear", DartNeeds::spectrum), mean_excess_anisotropy, above(0.5), 2,
                " dB above chance on average");
}

/// Ring by ring, how much nearer a curve is to a second one than to a third: the mean, with the scatter of rings.
std::optional<Estimate> nearer_to(const ReportSeries& own, const ReportSeries& second, const ReportSeries& third)
{
    std::vector<double> to_second = differences_of_curves(own, second), to_third = differences_of_curves(own, third);
    const std::size_t rings = std::min(to_second.size(), to_third.size());
    if (rings < 2) return std::nullopt;
    std::vector<double> nearer;
    for (std::size_t i = 0; i < rings; ++i) nearer.push_back(std::abs(to_third[i]) - std::abs(to_second[i]));
    const SampleMean mean = sample_mean(nearer);
    return Estimate{mean.value, mean.standard_error};
}

/// Relaxed sets of as many iterations as the dissertation shows, each against dart throwing of full sets.
DartOutcome boundary_is_like_lloyd(const ClaimSeries& report)
{
    constexpr double most_shown = 16;
    Cases cases;
    std::vector<Estimate> to_lloyd, to_darts;
    for (const ReportSeries* own : sector_darts(report, "boundary", DartNeeds::spectrum))
        for (const ReportSeries* lloyd : lloyd_of_darts(report, DartNeeds::spectrum))
            for (const ReportSeries* darts : full_darts(report, DartNeeds::spectrum)) {
                const double iterations = number_parameter(*lloyd, "iterations").value_or(0);
                if (iterations < 1 || iterations > most_shown) continue;
                const auto nearer = nearer_to(*own, *lloyd, *darts);
                if (!nearer) continue;
                cases.add(is_above(*nearer, 0));
                to_lloyd.push_back(*distance_of_curves(*own, *lloyd));
                to_darts.push_back(*distance_of_curves(*own, *darts));
            }
    return cases.outcome(fmt::format("{} from Lloyd relaxation on average, {} from dart throwing",
                                     range_words(to_lloyd, 2), range_words(to_darts, 2)));
}

constexpr std::array variants = {"logarithmic", "linear", "boundary"};

std::vector<std::string> times_of_variants(const ClaimSeries& report)
{
    std::vector<std::string> words;
    for (const char* variant : variants)
        for (const ReportSeries* series : sector_darts(report, variant, DartNeeds::anything)) {
            const auto seconds = median_seconds(*series);
            if (!seconds) continue;
            words.push_back(fmt::format("{} {} ({} points)", variant, format_seconds(*seconds),
                                        format_count(series->stored->points)));
        }
    return words;
}

DartOutcome shown_variants(const ClaimSeries& report)
{
    const auto words = times_of_variants(report);
    return words.empty() ? std::nullopt : std::optional(ClaimOutcome{Agreement::shown, joined_words(words)});
}

DartOutcome variants_beside_jones(const ClaimSeries& report)
{
    auto words = times_of_variants(report);
    const auto jones = shown_times(report, {"voronoi-darts"});
    if (words.empty() || !jones) return std::nullopt;
    words.push_back(jones->measured);
    return ClaimOutcome{Agreement::shown, joined_words(words)};
}

}

std::vector<PaperClaim> claims_about_sector_darts()
{
    return {
        {"6.13-radius", "6.13",
         "In terms of radius, the algorithms of Dunbar and Humphreys are similar to dart throwing.",
         "the mean relative radius of each variant is within 5 % of the largest that dart throwing of full sets has in "
         "all realizations of a series",
         [](const ClaimSeries& report) {
             return radii_beside(report.all({.sampler = "sector-darts"}), full_darts(report, DartNeeds::anything));
         }},
        {"6.13-logarithmic", "6.13", "The logarithmic algorithm has the spectrum of dart throwing.",
         "radial curves of full sets differ by less than 0.05 on average, by two standard errors", like_dart_throwing},
        {"6.13-plate", "6.13", "The logarithmic algorithm has the sampling performance of dart throwing.",
         fmt::format("against dart throwing at 0.75 and of full sets: {}", plates_alike_criterion), logarithmic_plates},
        {"6.13-linear", "6.13",
         "The peaks of the linear algorithm at multiples of the principal frequency are slightly larger.",
         "more power between 1.9 and 2.3 times the principal frequency than dart throwing of full sets has, by two "
         "standard errors",
         [](const ClaimSeries& report) { return larger_peaks(report, "linear", 1); }},
        {"6.13-skew", "6.13", "The spectrum of the linear algorithm seems to be a bit skew.",
         "anisotropy more than 0.5 dB above chance on average, by two standard errors", is_skew},
        {"6.13-boundary", "6.13",
         "The boundary algorithm has significantly larger peaks at multiples of the principal frequency.",
         "more power by a fifth between 1.9 and 2.3 times the principal frequency than dart throwing of full sets has, "
         "by two standard errors",
         [](const ClaimSeries& report) { return larger_peaks(report, "boundary", 1.2); }},
        {"6.13-lloyd", "6.13",
         "The spectrum of the boundary algorithm is somewhat similar to that of sets optimised by Lloyd relaxation.",
         "the radial curve is nearer to that of each relaxation of dart throwing by 1 to 16 iterations, as the "
         "dissertation shows, than to that of dart throwing of full sets, ring by ring on average, by two standard "
         "errors",
         boundary_is_like_lloyd},
        {"6.13-aliasing", "6.13", "The zone plate by the boundary algorithm shows some structured aliasing.",
         false_plates_criterion,
         [](const ClaimSeries& report) {
             return false_plates(report, sector_darts(report, "boundary", DartNeeds::plate), true);
         }},
        {"6.13-speed", "6.13",
         "The logarithmic and linear algorithms are comparable in speed with the method of Jones.",
         "shown: medians, which depend on the machine", variants_beside_jones},
        {"6.13-fast", "6.13",
         "The linear algorithm is not much faster than the logarithmic one, the boundary algorithm is: logarithmic "
         "7.002 s, linear 7.911 s, boundary 0.137 s.",
         "shown: medians, which depend on the machine", shown_variants},
    };
}

}
