// The dissertation's claims about accelerated dart throwing: sections 6.12 and 6.13.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

DartOutcome same_spectra(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> distances;
    for (const auto& [voronoi, darts] : pairs_of_equal_radius(report, usual_points, DartNeeds::spectrum)) {
        const auto distance = distance_of_curves(*voronoi, *darts);
        if (!distance) continue;
        tally.add(*distance < 0.03);
        distances.push_back(*distance);
    }
    if (distances.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(distances, 3), tally.words()})};
}

DartOutcome same_plates(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    for (const auto& [voronoi, darts] : pairs_of_equal_radius(report, plate_points, DartNeeds::plate)) {
        const double ours = plate_error(*voronoi, 0, 1), theirs = plate_error(*darts, 0, 1);
        if (ours == 0 || theirs == 0) continue;
        ratios.push_back(ours / theirs);
        tally.add(std::abs(ours / theirs - 1) < 0.02);
    }
    if (ratios.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(ratios, 3), tally.words()})};
}

/// The sets of the dissertation end at the borders of the square, those of the laboratory do not.
DartOutcome lines_on_axes(const ClaimSeries& report)
{
    std::vector<double> excess;
    for (const ReportSeries* series : report.all({.sampler = "voronoi-darts", .needs = DartNeeds::spectrum}))
        excess.push_back(mean_excess_anisotropy(*series));
    if (excess.empty()) return std::nullopt;
    return ClaimOutcome{Agreement::not_judged,
                        fmt::format("sets are toroidal here: {} dB above chance on average", range_words(excess, 2))};
}

DartOutcome faster_than_darts(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> ratios;
    for (const auto& [voronoi, darts] : pairs_of_equal_radius(report, usual_points, DartNeeds::anything)) {
        const auto ours = median_seconds(*voronoi), theirs = median_seconds(*darts);
        if (!ours || !theirs) continue;
        tally.add(*ours < *theirs);
        ratios.push_back(*ours / *theirs);
    }
    if (ratios.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(),
                        joined_words({range_words(ratios, 2) + " times the time of dart throwing, which does not draw "
                                                               "darts that fall on covered cells here",
                                      tally.words()})};
}

const ReportSeries* sector_darts(const ClaimSeries& report, const std::string& variant)
{
    for (const ReportSeries* series : report.all({.sampler = "sector-darts", .needs = SeriesQuery::Needs::spectrum}))
        if (text_parameter(*series, "variant") == variant) return series;
    return nullptr;
}

/// Dart throwing until nothing fits, as sector darts are.
const ReportSeries* full_darts(const ClaimSeries& report)
{
    for (const ReportSeries* series : report.all({.sampler = "dart-throwing", .needs = SeriesQuery::Needs::spectrum}))
        if (text_parameter(*series, "stop") == "saturation") return series;
    return nullptr;
}

DartOutcome like_dart_throwing(const ClaimSeries& report)
{
    const ReportSeries *logarithmic = sector_darts(report, "logarithmic"), *darts = full_darts(report);
    if (!logarithmic || !darts) return std::nullopt;
    const auto distance = distance_of_curves(*logarithmic, *darts);
    if (!distance) return std::nullopt;
    return ClaimOutcome{*distance < 0.05 ? Agreement::agrees : Agreement::disagrees,
                        fmt::format("{} on average", format_significant(*distance, 2))};
}

/// The power around twice the principal frequency, where the second peak of radial curves is.
std::optional<double> second_peak(const ReportSeries& series) { return mean_power(series, 1.9, 2.3); }

DartOutcome larger_peaks(const ClaimSeries& report, const std::string& variant, double factor)
{
    const ReportSeries *series = sector_darts(report, variant), *darts = full_darts(report);
    if (!series || !darts) return std::nullopt;
    const auto power = second_peak(*series), other = second_peak(*darts);
    if (!power || !other) return std::nullopt;
    return ClaimOutcome{*power > factor * *other ? Agreement::agrees : Agreement::disagrees,
                        fmt::format("{} around the second peak, dart throwing {}", format_significant(*power, 3),
                                    format_significant(*other, 3))};
}

DartOutcome is_skew(const ClaimSeries& report)
{
    const ReportSeries* linear = sector_darts(report, "linear");
    if (!linear) return std::nullopt;
    const double excess = mean_excess_anisotropy(*linear);
    return ClaimOutcome{excess > 0.5 ? Agreement::agrees : Agreement::disagrees,
                        fmt::format("{} dB above chance on average", format_fixed(excess, 2))};
}

std::optional<double> seconds_of(const ClaimSeries& report, const std::string& variant)
{
    for (const ReportSeries* series : report.all({.sampler = "sector-darts"})) {
        const auto seconds = median_seconds(*series);
        if (text_parameter(*series, "variant") == variant && seconds) return seconds;
    }
    return std::nullopt;
}

DartOutcome boundary_is_fast(const ClaimSeries& report)
{
    const auto logarithmic = seconds_of(report, "logarithmic"), linear = seconds_of(report, "linear"),
               boundary = seconds_of(report, "boundary");
    if (!logarithmic || !linear || !boundary) return std::nullopt;
    const bool is_fast = *logarithmic > 3 * *boundary, is_alike = *linear > *logarithmic / 2;
    return ClaimOutcome{is_fast && is_alike   ? Agreement::agrees
                        : is_fast || is_alike ? Agreement::partly
                                              : Agreement::disagrees,
                        fmt::format("logarithmic {}, linear {}, boundary {}", format_seconds(*logarithmic),
                                    format_seconds(*linear), format_seconds(*boundary))};
}

}

std::vector<PaperClaim> claims_about_accelerated_darts()
{
    const auto jones = [](double radius) {
        return SeriesQuery{
            .sampler = "voronoi-darts", .numbers = {{"relative_radius", radius}}, .points = usual_points};
    };
    return {
        reach_claim("6.12-radius", "6.12", "In terms of radius, the method of Jones is very similar to dart throwing.",
                    {.sampler = "voronoi-darts", .points = usual_points}, 0.75),
        {"6.12-spectrum", "6.12",
         "The method of Jones has the same spectral properties as the traditional dart throwing algorithm.",
         "radial curves of sets of the same relative radius differ by less than 0.03 on average", same_spectra},
        {"6.12-plate", "6.12", "The method of Jones has the same sampling performance as dart throwing.",
         "the root mean square errors of the zone plate differ by less than 2 %", same_plates},
        {"6.12-lines", "6.12",
         "Sets of the method of Jones are not toroidal, which explains lines on the axes of the spectrum and "
         "anisotropy at low frequencies.",
         "the anisotropy of sets that are toroidal: not judged", lines_on_axes},
        {"6.12-fast", "6.12", "The method of Jones is significantly faster than the traditional implementation.",
         "faster than the sampler dart-throwing at the same relative radius", faster_than_darts},
        time_claim("6.12-time", "6.12", "16,384 points take 3.511 s for ρ = 0.70 and 3.403 s for ρ = 0.75.",
                   {{"ρ = 0.70", jones(0.70)}, {"ρ = 0.75", jones(0.75)}}),
        {"6.13-logarithmic", "6.13", "The logarithmic algorithm has the spectrum of dart throwing.",
         "radial curves of full sets differ by less than 0.05 on average", like_dart_throwing},
        {"6.13-linear", "6.13",
         "The peaks of the linear algorithm at multiples of the principal frequency are slightly larger.",
         "more power between 1.9 and 2.3 times the principal frequency than dart throwing of full sets has",
         [](const ClaimSeries& report) { return larger_peaks(report, "linear", 1); }},
        {"6.13-skew", "6.13", "The spectrum of the linear algorithm seems to be a bit skew.",
         "anisotropy more than 0.5 dB above chance on average", is_skew},
        {"6.13-boundary", "6.13",
         "The boundary algorithm has significantly larger peaks at multiples of the principal frequency.",
         "more power by a fifth between 1.9 and 2.3 times the principal frequency than dart throwing of full sets has",
         [](const ClaimSeries& report) { return larger_peaks(report, "boundary", 1.2); }},
        {"6.13-fast", "6.13",
         "The linear algorithm is not much faster than the logarithmic one, the boundary algorithm is: 7.911 s, 7.002 "
         "s, 0.137 s.",
         "the logarithmic one takes more than three times as long as the boundary one, and at most twice as long as "
         "the linear one",
         boundary_is_fast},
    };
}

}
