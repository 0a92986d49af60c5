// Claims of sections 6.3 and 6.4 about dart throwing and relaxation dart throwing.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace poissonlab {
namespace {

using Needs = SeriesQuery::Needs;
using Outcome = std::optional<ClaimOutcome>;

SeriesQuery darts(double relative_radius, Needs needs = Needs::anything, std::size_t points = usual_points)
{
    return {.sampler = "dart-throwing",
            .numbers = {{"relative_radius", relative_radius}},
            .points = points,
            .needs = needs};
}

SeriesQuery plates_of(const std::string& sampler)
{
    return {.sampler = sampler, .points = plate_points, .needs = Needs::plate};
}

Outcome plate_better(const std::vector<const ReportSeries*>& good, const std::vector<const ReportSeries*>& other)
{
    Cases cases;
    for (const ReportSeries* a : good)
        for (const ReportSeries* b : other) {
            const double x = plate_error(*a, plate_middle, plate_end), y = plate_error(*b, plate_middle, plate_end);
            if (x == 0 || y == 0) continue;
            cases.add(compared_plates(x, y), fmt::format("{}: {}, {}: {}", a->label, format_significant(x, 3), b->label,
                                                         format_significant(y, 3)));
        }
    return cases.outcome();
}

std::vector<PaperClaim> dart_throwing_claims()
{
    return {
        reach_claim("6.3-radius", "6.3", "Dart throwing reaches relative radii of up to 0.75.",
                    {.sampler = "dart-throwing"}, 0.75),
        {"6.3-spectrum", "6.3", "The radially averaged power of dart throwing is that of blue noise.",
         std::string("of sets with a relative radius of 0.70 and more, as the dissertation shows, full ones among "
                     "them: ") +
             blue_noise_criterion,
         [](const ClaimSeries& report) { return all_blue_noise(darts_as_large(report, 0.70)); }},
        {"6.3-noise", "6.3", "In the zone plate, undersampling causes noise rather than aliasing.",
         no_false_plates_criterion,
         [](const ClaimSeries& report) { return false_plates(report, report.all(plates_of("dart-throwing")), false); }},
        {"6.3-plate", "6.3",
         "Dart throwing reproduces the zone plate significantly better at higher frequencies than a stratified pattern "
         "does.",
         better_plate_criterion,
         [](const ClaimSeries& report) {
             return plate_better(report.all(plates_of("dart-throwing")), report.all(plates_of("jittered")));
         }},
        time_claim("6.3-time", "6.3", "16,384 points take 35.0 s for ρ = 0.70 and 263.5 s for ρ = 0.75.",
                   {{"ρ = 0.70", darts(0.70)}, {"ρ = 0.75", darts(0.75)}}),
    };
}

// 6.4

struct RelaxationSetting
{
    double factor, attempts, relative_radius;
};
constexpr RelaxationSetting relaxation_settings[] = {{0.9, 100, 0.57}, {0.99, 1000, 0.68}, {0.999, 10000, 0.73}};

/// Widths of the rises of dart throwing, by the mean relative radius.
std::map<double, Estimate> rises_of_darts(const ClaimSeries& report)
{
    std::map<double, Estimate> rises;
    for (const ReportSeries* series : darts_as_large(report, 0))
        if (const auto rise = rise_width(*series)) rises[series->stored->relative_radius->mean] = *rise;
    return rises;
}

/// Interpolates between the two sets of dart throwing whose radii enclose this one; empty where there are none.
std::optional<Estimate> rise_at(const std::map<double, Estimate>& rises, double relative_radius)
{
    const auto above = rises.lower_bound(relative_radius);
    if (above == rises.end()) return std::nullopt;
    if (above->first == relative_radius) return above->second;
    if (above == rises.begin()) return std::nullopt;
    const auto below = std::prev(above);
    const double share = (relative_radius - below->first) / (above->first - below->first);
    const Estimate &low = below->second, &high = above->second;
    return Estimate{low.value + share * (high.value - low.value),
                    std::hypot((1 - share) * low.standard_error.value_or(0), share * high.standard_error.value_or(0))};
}

/// The rise gets steeper with the radius, so methods are compared at equal radii.
Outcome relaxation_steeper(const ClaimSeries& report)
{
    const std::map<double, Estimate> rises = rises_of_darts(report);
    Cases cases;
    for (const auto& setting : relaxation_settings)
        for (const auto* series : report.all(relaxation_darts(setting.factor, setting.attempts, Needs::spectrum))) {
            if (!series->stored->relative_radius) continue;
            const double radius = series->stored->relative_radius->mean;
            const auto rise = rise_width(*series), width = rise_at(rises, radius);
            if (!rise || !width) continue;
            cases.add(is_below(difference_of(*rise, *width), 0),
                      fmt::format("ρ = {}: {}, dart throwing {}", format_fixed(radius, 3), with_error(*rise, 3),
                                  with_error(*width, 3)));
        }
    return cases.outcome();
}

Outcome relaxation_radii(const ClaimSeries& report)
{
    Cases cases;
    for (const auto& setting : relaxation_settings)
        for (const auto* series : report.all(relaxation_darts(setting.factor, setting.attempts))) {
            const auto& radius = series->stored->relative_radius;
            if (!radius) continue;
            cases.add(is_radius_of_the_text(*radius, setting.relative_radius),
                      fmt::format("{} ({} to {})", format_fixed(radius->mean, 3), format_fixed(radius->min, 3),
                                  format_fixed(radius->max, 3)));
        }
    return cases.outcome();
}

/// The picture of the middle setting, as in the paper's figure, against dart throwing up to the radius of its figure.
Outcome relaxation_plate(const ClaimSeries& report)
{
    auto darts = report.all(plates_of("dart-throwing"));
    std::erase_if(darts, [](const ReportSeries* series) {
        const auto& radius = series->stored->relative_radius;
        return !radius || radius->min < 0.65 || radius->min > 0.71;
    });
    return plate_better(report.all(relaxation_darts(0.99, 1000, Needs::plate, plate_points)), darts);
}

std::vector<PaperClaim> relaxation_claims()
{
    std::vector<TimedSeries> timed;
    for (const auto& setting : relaxation_settings)
        timed.push_back({fmt::format("{} after {}", format_exact(setting.factor), format_exact(setting.attempts)),
                         relaxation_darts(setting.factor, setting.attempts)});
    return {
        {"6.4-radius", "6.4",
         "Relaxation dart throwing with factors 0.9, 0.99, 0.999 after 100, 1,000, 10,000 failures reaches 0.57, 0.68, "
         "0.73.",
         radius_of_the_text_criterion, relaxation_radii},
        {"6.4-steeper", "6.4", "The rise of the radial power is a bit steeper than that of dart throwing.",
         "narrower from power 0.25 to 0.75, in cycles per mean spacing, than between sets of dart throwing with a "
         "smaller and a larger relative radius, by two standard errors",
         relaxation_steeper},
        {"6.4-plate", "6.4", "The zone plate is reproduced even better at higher frequencies than by dart throwing.",
         std::string(better_plate_criterion) +
             "; dart throwing at relative radii of 0.65 to 0.70: that of the paper's figure, and that of these sets",
         relaxation_plate},
        time_claim("6.4-time", "6.4", "16,384 points take 0.020 s, 0.289 s, 11.733 s.", timed),
    };
}

}

SeriesQuery relaxation_darts(double factor, double attempts, Needs needs, std::size_t points)
{
    return {.sampler = "relaxation-dart-throwing",
            .numbers = {{"initial_radius", 0.15}, {"factor", factor}, {"attempts", attempts}},
            .points = points,
            .needs = needs};
}

Finding is_radius_of_the_text(const Statistic& measured, double printed)
{
    constexpr double half_of_the_last_digit = 0.005;
    const double off = std::abs(measured.mean - printed);
    if (off <= half_of_the_last_digit) return Finding::holds;
    if (measured.each.size() < 2) return Finding::open;
    const Estimate mean = mean_of_realizations(measured);
    const double deviation = *mean.standard_error * std::sqrt(static_cast<double>(measured.each.size()));
    return finding_if(off <= half_of_the_last_digit + 2 * deviation);
}

std::vector<PaperClaim> claims_about_darts()
{
    auto claims = dart_throwing_claims();
    std::ranges::move(relaxation_claims(), std::back_inserter(claims));
    return claims;
}

}
