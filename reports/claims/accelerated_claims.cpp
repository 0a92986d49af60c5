// The dissertation's claims about accelerated dart throwing: section 6.13.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

using SectorOutcome = std::optional<ClaimOutcome>;

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

SectorOutcome like_dart_throwing(const ClaimSeries& report)
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

SectorOutcome larger_peaks(const ClaimSeries& report, const std::string& variant, double factor)
{
    const ReportSeries *series = sector_darts(report, variant), *darts = full_darts(report);
    if (!series || !darts) return std::nullopt;
    const auto power = second_peak(*series), other = second_peak(*darts);
    if (!power || !other) return std::nullopt;
    return ClaimOutcome{*power > factor * *other ? Agreement::agrees : Agreement::disagrees,
                        fmt::format("{} around the second peak, dart throwing {}", format_significant(*power, 3),
                                    format_significant(*other, 3))};
}

SectorOutcome is_skew(const ClaimSeries& report)
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
        std::vector<double> seconds = series->stored->sample_seconds;
        if (text_parameter(*series, "variant") != variant || seconds.empty()) continue;
        std::ranges::sort(seconds);
        return seconds[seconds.size() / 2];
    }
    return std::nullopt;
}

SectorOutcome boundary_is_fast(const ClaimSeries& report)
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
    return {
        {"6.13-logarithmic", "6.13", "The logarithmic algorithm has the spectrum of dart throwing.",
         "radial curves of full sets differ by less than 0.05 on average", like_dart_throwing},
        {"6.13-linear", "6.13",
         "The peaks of the linear algorithm at multiples of the principal frequency are slightly larger.",
         "more power between 1.9 and 2.3 times the principal frequency than dart throwing of full sets has",
         [](const ClaimSeries& report) { return larger_peaks(report, "linear", 1); }},
        {"6.13-skew", "6.13", "The spectrum of the linear algorithm seems to be a bit skew.",
         "anisotropy more than 0.5 dB above chance on average", is_skew},
        {"6.13-boundary", "6.13", "The boundary algorithm has significantly larger peaks there.",
         "the same, a fifth more", [](const ClaimSeries& report) { return larger_peaks(report, "boundary", 1.2); }},
        {"6.13-fast", "6.13",
         "The linear algorithm is not much faster than the logarithmic one, the boundary algorithm is: 7.911 s, 7.002 "
         "s, "
         "0.137 s.",
         "the logarithmic one takes more than three times as long as the boundary one, and at most twice as long as "
         "the "
         "linear one",
         boundary_is_fast},
    };
}

}
