// The dissertation's claims about the method of Jones: section 6.12.
#include "reports/claims/claim_words.hpp"
#include "reports/claims/comparison/dart_comparisons.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

using DartOutcome = std::optional<ClaimOutcome>;
using DartNeeds = SeriesQuery::Needs;

/// Jones' darts and those of dart throwing, of as many points and the same relative radius.
using DartPair = std::pair<const ReportSeries*, const ReportSeries*>;

std::vector<DartPair> pairs_of_equal_radius(const ClaimSeries& report, std::optional<std::size_t> points,
                                            DartNeeds needs)
{
    std::vector<DartPair> pairs;
    for (const ReportSeries* voronoi : report.all({.sampler = "voronoi-darts", .points = points, .needs = needs})) {
        const auto radius = number_parameter(*voronoi, "relative_radius");
        if (!radius) continue;
        const ReportSeries* darts = report.one({.sampler = "dart-throwing",
                                                .numbers = {{"relative_radius", *radius}},
                                                .points = voronoi->stored->points,
                                                .needs = needs});
        if (darts) pairs.emplace_back(voronoi, darts);
    }
    return pairs;
}

/// Judges how far the method of Jones goes by its series of the largest radius.
DartOutcome jones_reaches_as_much(const ClaimSeries& report)
{
    auto own = report.all({.sampler = "voronoi-darts"});
    std::erase_if(own, [](const ReportSeries* series) { return !series->stored->relative_radius; });
    if (own.empty()) return std::nullopt;
    const auto largest = std::ranges::max_element(
        own, {}, [](const ReportSeries* series) { return series->stored->relative_radius->min; });
    return radii_beside({*largest}, report.all({.sampler = "dart-throwing"}));
}

DartOutcome same_spectra(const ClaimSeries& report)
{
    Cases cases;
    std::vector<Estimate> distances;
    for (const auto& [voronoi, darts] : pairs_of_equal_radius(report, usual_points, DartNeeds::spectrum)) {
        const auto distance = distance_of_curves(*voronoi, *darts);
        if (!distance) continue;
        cases.add(is_below(*distance, 0.03));
        distances.push_back(*distance);
    }
    return cases.outcome(range_words(distances, 2));
}

/// The sets of the dissertation end at the borders of the square, those of the laboratory do not.
DartOutcome lines_on_axes(const ClaimSeries& report)
{
    std::vector<Estimate> excess;
    for (const ReportSeries* series : report.all({.sampler = "voronoi-darts", .needs = DartNeeds::spectrum}))
        excess.push_back(mean_excess_anisotropy(*series));
    if (excess.empty()) return std::nullopt;
    return ClaimOutcome{Agreement::shown,
                        fmt::format("sets are toroidal here: {} dB above chance on average", range_words(excess, 2))};
}

/// Shows times beside those of dart throwing as it is here; the paper compares with the traditional algorithm.
DartOutcome times_beside_darts(const ClaimSeries& report)
{
    std::vector<double> ratios;
    for (const auto& [voronoi, darts] : pairs_of_equal_radius(report, usual_points, DartNeeds::anything)) {
        const auto ours = median_seconds(*voronoi), theirs = median_seconds(*darts);
        if (ours && theirs) ratios.push_back(*ours / *theirs);
    }
    if (ratios.empty()) return std::nullopt;
    return ClaimOutcome{Agreement::shown, range_words(ratios, 2) +
                                              " times the time of dart throwing here; in the paper "
                                              "1/10 and 1/77 of that of the traditional one"};
}

}

std::vector<PaperClaim> claims_about_jones()
{
    const auto jones = [](double radius) {
        return SeriesQuery{
            .sampler = "voronoi-darts", .numbers = {{"relative_radius", radius}}, .points = usual_points};
    };
    return {
        {"6.12-radius", "6.12", "In terms of radius, the method of Jones is very similar to dart throwing.",
         "the largest mean relative radius of a series is within 5 % of the largest that dart throwing has in all "
         "realizations of a series, full sets among them",
         jones_reaches_as_much},
        {"6.12-spectrum", "6.12",
         "The method of Jones has the same spectral properties as the traditional dart throwing algorithm.",
         "radial curves of sets of the same relative radius differ by less than 0.03 on average, by two standard "
         "errors",
         same_spectra},
        {"6.12-plate", "6.12", "The method of Jones has the same sampling performance as dart throwing.",
         plates_alike_criterion,
         [](const ClaimSeries& report) {
             return plates_alike(pairs_of_equal_radius(report, plate_points, DartNeeds::plate));
         }},
        {"6.12-lines", "6.12",
         "Sets of the method of Jones are not toroidal, which explains lines on the axes of the spectrum and "
         "anisotropy at low frequencies.",
         "shown: the anisotropy of sets that are toroidal", lines_on_axes},
        {"6.12-fast", "6.12", "The method of Jones is significantly faster than the traditional implementation.",
         "shown, as dart throwing here is not the traditional one: it does not draw darts that fall on covered cells",
         times_beside_darts},
        time_claim("6.12-time", "6.12", "16,384 points take 3.511 s for ρ = 0.70 and 3.403 s for ρ = 0.75.",
                   {{"ρ = 0.70", jones(0.70)}, {"ρ = 0.75", jones(0.75)}}),
    };
}

}
