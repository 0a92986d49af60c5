// The recommendations of the dissertation's chapter 6: section 6.16.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace poissonlab {
namespace {

using Recommendation = std::optional<ClaimOutcome>;
using Values = std::vector<double>;

/// A tenth of a second feels immediate: Miller, Response time in man-computer conversational transactions, 1968.
constexpr double interactive_seconds = 0.1;

/// A frame at 60 Hz.
constexpr double real_time_seconds = 1.0 / 60;

using Quality = std::optional<double> (*)(const ReportSeries&);

/// The qualities of all series of 2D methods that have them, of some 16,384 points.
Values qualities(const ClaimSeries& report, const std::vector<const char*>& samplers, Quality quality)
{
    Values values;
    for (const char* sampler : samplers)
        for (const ReportSeries* series : report.all({.sampler = sampler, .points = usual_points}))
            if (const auto value = quality(*series)) values.push_back(*value);
    return values;
}

std::optional<double> smallest_radius(const ReportSeries& series)
{
    if (!series.stored->relative_radius) return std::nullopt;
    return series.stored->relative_radius->min;
}

std::optional<double> excess_anisotropy(const ReportSeries& series)
{
    if (series.curve.bins.empty() || (series.stored->realizations < 2 && !series.stored->deterministic))
        return std::nullopt;
    if (tiles_of_set(series) == 1) return std::nullopt; // a lattice: beside its peaks there is no power at all
    return mean_excess_anisotropy(series);
}

std::optional<double> deviation_at_seams(const ReportSeries& series)
{
    const auto found = series.stored->measures.numbers.find("seam_density");
    if (found == series.stored->measures.numbers.end()) return std::nullopt;
    return found->second.value;
}

double best(const Values& values) { return *std::ranges::max_element(values); }
double least(const Values& values) { return *std::ranges::min_element(values); }

Agreement judged(bool holds) { return holds ? Agreement::agrees : Agreement::disagrees; }

Agreement judged(bool first, bool second)
{
    return first && second ? Agreement::agrees : first || second ? Agreement::partly : Agreement::disagrees;
}

/// Median times of methods, each against a limit.
Recommendation judged_times(const ClaimSeries& report, const std::vector<const char*>& samplers, double limit,
                            bool should_be_below)
{
    Tally tally;
    std::vector<std::string> words;
    for (const char* sampler : samplers) {
        const Values seconds = qualities(report, {sampler}, median_seconds);
        if (seconds.empty()) continue;
        words.push_back(fmt::format("{} {}", sampler, format_seconds(least(seconds))));
        tally.add((least(seconds) < limit) == should_be_below);
    }
    if (tally.empty()) return std::nullopt;
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

Recommendation shade_has_seams(const ClaimSeries& report)
{
    const Values deviations = qualities(report, {"shade-tiles"}, deviation_at_seams);
    if (deviations.empty()) return std::nullopt;
    return ClaimOutcome{judged(least(deviations) > 0.2), fmt::format("{} near borders", range_words(deviations, 2))};
}

/// One method is better than another in radius and in anisotropy: best against best.
Recommendation is_better(const ClaimSeries& report, const char* better, const char* worse)
{
    const Values radii = qualities(report, {better}, smallest_radius),
                 other_radii = qualities(report, {worse}, smallest_radius);
    const Values power = qualities(report, {better}, excess_anisotropy),
                 other_power = qualities(report, {worse}, excess_anisotropy);
    if (radii.empty() || other_radii.empty() || power.empty() || other_power.empty()) return std::nullopt;
    return ClaimOutcome{judged(best(radii) > best(other_radii), least(power) < least(other_power)),
                        fmt::format("radius {} against {}, anisotropy {} against {} dB above chance",
                                    format_fixed(best(radii), 2), format_fixed(best(other_radii), 2),
                                    format_fixed(least(power), 2), format_fixed(least(other_power), 2))};
}

Recommendation less_anisotropic(const ClaimSeries& report, const char* better, const char* worse)
{
    const Values power = qualities(report, {better}, excess_anisotropy),
                 other = qualities(report, {worse}, excess_anisotropy);
    if (power.empty() || other.empty()) return std::nullopt;
    return ClaimOutcome{
        judged(least(power) < least(other)),
        fmt::format("{} against {} dB above chance", format_fixed(least(power), 2), format_fixed(least(other), 2))};
}

/// Corner tiles of fewer tiles than the smallest set of edge tiles that they beat.
Recommendation better_with_fewer(const ClaimSeries& report)
{
    Tally tally;
    for (const ReportSeries* edges : report.all({.sampler = "edge-tiles", .points = usual_points}))
        for (const ReportSeries* corners : report.all({.sampler = "corner-tiles", .points = usual_points})) {
            const auto edge_tiles = tiles_of_set(*edges), corner_tiles = tiles_of_set(*corners);
            const auto edge_power = excess_anisotropy(*edges), corner_power = excess_anisotropy(*corners);
            if (!edge_tiles || !corner_tiles || *corner_tiles > *edge_tiles || !edge_power || !corner_power) continue;
            if (number_parameter(*edges, "points_per_tile") != number_parameter(*corners, "points_per_tile")) continue;
            tally.add(*corner_power < *edge_power);
        }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), tally.words().empty() ? "in the one case there is" : tally.words()};
}

/// The least anisotropy of each method; the average one is the median.
Recommendation below_average(const ClaimSeries& report, const char* sampler)
{
    const Values own = qualities(report, {sampler}, excess_anisotropy);
    Values others;
    for (const char* other : {"dart-throwing", "relaxation-dart-throwing", "lloyd", "edge-tiles", "corner-tiles",
                              "template-tiles", "averaged-tiles", "shade-tiles", "sector-darts", "voronoi-darts"})
        if (const Values values = qualities(report, {other}, excess_anisotropy); !values.empty())
            others.push_back(least(values));
    if (own.empty() || others.size() < 2) return std::nullopt;
    std::ranges::sort(others);
    const double middle = others[others.size() / 2];
    return ClaimOutcome{judged(least(own) > middle),
                        fmt::format("{} dB above chance, the middle one of {} other methods has {}",
                                    format_fixed(least(own), 2), others.size(), format_fixed(middle, 2))};
}

Recommendation low_radius(const ClaimSeries& report)
{
    const Values radii = qualities(report, {"recursive-wang-tiles"}, smallest_radius);
    if (radii.empty()) return std::nullopt;
    return ClaimOutcome{judged(best(radii) < 0.5), range_words(radii, 3)};
}

constexpr const char* anisotropy_words = "less anisotropy above chance on average, best series against best";

}

std::vector<PaperClaim> recommendations()
{
    const std::vector<const char*> untiled{"dart-throwing", "relaxation-dart-throwing", "lloyd"};
    const std::vector<const char*> tiled{"edge-tiles", "corner-tiles", "template-tiles"};
    return {
        {"6.16-not-interactive", "6.16",
         "Dart throwing, relaxation dart throwing and Lloyd's method only suit applications that are not interactive.",
         "16,384 points take more than a tenth of a second",
         [=](const ClaimSeries& report) { return judged_times(report, untiled, interactive_seconds, false); }},
        {"6.16-interactive", "6.16",
         "The algorithms of Jones and of Dunbar and Humphreys suit interactive applications.",
         "16,384 points take less than a tenth of a second",
         [](const ClaimSeries& report) {
             return judged_times(report, {"voronoi-darts", "sector-darts"}, interactive_seconds, true);
         }},
        {"6.16-real-time", "6.16", "Tile-based approaches suit real-time applications.",
         "16,384 points take less than 1/60 second",
         [=](const ClaimSeries& report) { return judged_times(report, tiled, real_time_seconds, true); }},
        {"6.16-only-option", "6.16",
         "Dart throwing, relaxation dart throwing and Lloyd's method do not suit real-time applications.",
         "16,384 points take more than 1/60 second",
         [=](const ClaimSeries& report) { return judged_times(report, untiled, real_time_seconds, false); }},
        {"6.16-shade", "6.16", "Shade's tiles have major shortcomings and should not be used.",
         "near borders the density deviates by more than a fifth", shade_has_seams},
        {"6.16-averaged", "6.16",
         "Tiled blue noise samples are not recommended: edge-based tiles are better in radius and spectrum.",
         "a larger radius in the worst realization, and less anisotropy above chance, best series against best",
         [](const ClaimSeries& report) { return is_better(report, "edge-tiles", "averaged-tiles"); }},
        {"6.16-template", "6.16", "The border of template tiles brings too many artifacts into the spectrum.",
         std::string("corner-based tiles have ") + anisotropy_words,
         [](const ClaimSeries& report) { return less_anisotropic(report, "corner-tiles", "template-tiles"); }},
        {"6.16-corner", "6.16", "Corner-based tiles produce better spectra than edge-based ones even with fewer tiles.",
         "less anisotropy above chance with at most as many tiles, of as many points", better_with_fewer},
        {"6.16-penrose", "6.16", "The spectral properties of the method of Ostromoukhov et al. are below average.",
         "more anisotropy above chance than the middle one of the other methods",
         [](const ClaimSeries& report) { return below_average(report, "penrose"); }},
        {"6.16-recursive", "6.16", "The spectral properties of the method of Kopf et al. are below average, too.",
         "more anisotropy above chance than the middle one of the other methods",
         [](const ClaimSeries& report) { return below_average(report, "recursive-wang-tiles"); }},
        {"6.16-recursive-radius", "6.16", "The radius of the method of Kopf et al. is surprisingly low.",
         "below 0.5 in the worst realization", low_radius},
    };
}

}
