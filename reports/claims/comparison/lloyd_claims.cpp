// Claims of section 6.5 about Lloyd relaxation, and of section 6.15 about it in space.
#include "reports/claims/comparison/lloyd_series.hpp"

#include "analysis/statistics/welch.hpp"
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using Needs = SeriesQuery::Needs;
using Outcome = std::optional<ClaimOutcome>;

/// The times of the dissertation end with this iteration, and so does, presumably, the plot that it speaks of.
constexpr std::size_t last_of_the_paper = 32;

/// Twice the 32, to see what follows.
constexpr std::size_t iterations_that_tell = 64;

const std::vector<double>& radii(const ReportSeries& series) { return series.stored->iterations->relative_radius.mean; }

/// The first iteration from which on the mean relative radius stays within 0.02 of that of iteration 32.
std::size_t settled_at(const std::vector<double>& values)
{
    std::size_t settled = last_of_the_paper;
    while (settled > 0 && std::abs(values[settled - 1] - values[last_of_the_paper]) <= 0.02) --settled;
    return settled;
}

Outcome lloyd_converges(const ClaimSeries& report)
{
    Cases cases;
    for (const auto* series : lloyd_of_darts(report, Needs::iterations)) {
        const std::vector<double>& values = radii(*series);
        if (values.size() <= last_of_the_paper) continue;
        const auto settled = settled_at(values);
        const double gain = values.back() - values[last_of_the_paper];
        const bool in_time = settled >= 8 && settled <= 28;
        const Finding stays = std::abs(gain) > 0.01                   ? Finding::fails
                              : values.size() <= iterations_that_tell ? Finding::open
                                                                      : Finding::holds;
        cases.add(both(finding_if(in_time), stays),
                  fmt::format("N = {}: from iteration {} on, then {} more up to iteration {}",
                              format_count(series->stored->points), settled, format_fixed(gain, 3), values.size() - 1));
    }
    return cases.outcome();
}

/// The gain of each realization between two iterations.
Estimate gain_between(const ReportSeries& series, std::size_t from, std::size_t to)
{
    std::vector<double> gains;
    for (const auto& realization : series.iterations)
        if (realization.size() > to)
            gains.push_back(realization[to].relative_radius - realization[from].relative_radius);
    if (gains.size() < 2) return {radii(series)[to] - radii(series)[from], {}};
    const SampleMean mean = sample_mean(gains);
    return {mean.value, mean.standard_error};
}

/// Sets of dart throwing, whose radius is large to begin with and falls at first.
Outcome lloyd_increases(const ClaimSeries& report)
{
    Cases cases;
    for (const auto* series : lloyd_of_darts(report, Needs::iterations)) {
        const std::vector<double>& values = radii(*series);
        if (values.size() <= last_of_the_paper) continue;
        const Estimate gain = gain_between(*series, 0, last_of_the_paper);
        const auto least = std::ranges::min_element(values);
        cases.add(is_above(gain, 0), fmt::format("N = {}: {} at first, {} at iteration {}, {} at iteration {}",
                                                 format_count(series->stored->points), format_fixed(values.front(), 3),
                                                 format_fixed(*least, 3), least - values.begin(),
                                                 format_fixed(values[last_of_the_paper], 3), last_of_the_paper));
    }
    return cases.outcome();
}

/// Series of more iterations than the paper has, by number of points.
std::vector<const ReportSeries*> long_relaxations(const ClaimSeries& report)
{
    auto found = lloyd_of_darts(report, Needs::iterations);
    std::erase_if(found, [](const auto* series) { return radii(*series).size() <= iterations_that_tell; });
    std::ranges::stable_sort(found, {}, [](const auto* series) { return series->stored->points; });
    return found;
}

/// The relative radius after an iteration, with the error that realizations make.
Estimate radius_after(const ReportSeries& series, std::size_t iteration)
{
    std::vector<double> each;
    for (const auto& realization : series.iterations)
        if (realization.size() > iteration) each.push_back(realization[iteration].relative_radius);
    if (each.size() < 2) return {radii(series)[iteration], {}};
    const SampleMean mean = sample_mean(each);
    return {mean.value, mean.standard_error};
}

Outcome fewer_points_higher(const ClaimSeries& report)
{
    const auto found = long_relaxations(report);
    Cases cases;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::size_t last = radii(*found[i]).size() - 1;
        cases.say(fmt::format("N = {}: {}", format_count(found[i]->stored->points),
                              with_error(radius_after(*found[i], last), 3)));
        for (std::size_t k = 0; k < i; ++k) {
            const std::size_t common = std::min(last, radii(*found[k]).size() - 1);
            if (found[k]->stored->points == found[i]->stored->points) continue;
            cases.add(is_above(difference_of(radius_after(*found[k], common), radius_after(*found[i], common)), 0));
        }
    }
    return cases.outcome();
}

Outcome settles_high(const ClaimSeries& report)
{
    const auto last = [](const ReportSeries& series) { return radius_after(series, radii(series).size() - 1); };
    return over(long_relaxations(report), last, within(0.75, 0.85), 3);
}

/// Spectra after i = 0, 1, 2, ... iterations of the same starts.
std::vector<const ReportSeries*> relaxed_spectra(const ClaimSeries& report)
{
    auto found = lloyd_of_darts(report, Needs::spectrum);
    std::erase_if(found, [](const auto* series) {
        const auto iterations = number_parameter(*series, "iterations");
        return !iterations || *iterations > 32 || series->stored->points != usual_points;
    });
    std::ranges::stable_sort(found, {}, [](const auto* series) { return *number_parameter(*series, "iterations"); });
    return found;
}

std::string list_of(const std::vector<std::string>& parts)
{
    std::string text;
    for (const auto& part : parts) text += (text.empty() ? "" : ", ") + part;
    return text;
}

Outcome peaks_grow(const ClaimSeries& report)
{
    const auto found = relaxed_spectra(report);
    const auto height = [](const ReportSeries& series) {
        const RadialBin peak = power_peak(series);
        return Estimate{peak.power, peak.power_error};
    };
    Cases cases;
    std::vector<std::string> heights, widths;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto width = rise_width(*found[i]);
        heights.push_back(format_fixed(height(*found[i]).value, 2));
        if (width) widths.push_back(format_significant(width->value, 2));
        if (i == 0) continue;
        cases.add(is_above(difference_of(height(*found[i]), height(*found[i - 1])), 0));
        if (const auto before = rise_width(*found[i - 1]); before && width)
            cases.add(is_below(difference_of(*width, *before), 0));
    }
    return cases.outcome(joined_words({"peaks " + list_of(heights), "widths of the rise " + list_of(widths)}));
}

/// Each number of iterations against none.
Outcome anisotropy_stays(const ClaimSeries& report)
{
    const auto found = relaxed_spectra(report);
    if (found.size() < 2) return std::nullopt;
    Cases cases;
    std::vector<Estimate> rises;
    for (std::size_t i = 1; i < found.size(); ++i) {
        rises.push_back(difference_of(mean_excess_anisotropy(*found[i]), mean_excess_anisotropy(*found.front())));
        cases.add(is_below(rises.back(), 0.5));
    }
    return cases.outcome(fmt::format("{} dB more after up to {} iterations than after {}", range_words(rises, 2),
                                     format_exact(*number_parameter(*found.back(), "iterations")),
                                     format_exact(*number_parameter(*found.front(), "iterations"))));
}

/// All sets that are relaxed for long, from any start; the share of cells that a grid has is its standard error away.
Outcome no_regular_grid(const ClaimSeries& report)
{
    Cases cases;
    for (const auto* series : report.all({.sampler = "lloyd", .needs = Needs::iterations})) {
        const auto& cells = series->stored->measures.voronoi;
        const std::size_t iterations = series->stored->iterations->count();
        if (series->stored->points < 4096 || !cells || iterations < 64) continue;
        const double six = cells->neighbour_share[2];
        const double error = std::sqrt(six * (1 - six) / static_cast<double>(series->stored->points));
        cases.add(is_below({six, error}, 0.95),
                  fmt::format("N = {}: {} of the cells have six neighbours after {} iterations",
                              format_count(series->stored->points), percent_words(six), format_count(iterations)));
    }
    return cases.outcome();
}

/// Times of relaxation that did not start from random points have the time of their start in them.
PaperClaim lloyd_time_claim()
{
    std::vector<TimedSeries> timed;
    for (const int i : {1, 2, 4, 8, 16, 32})
        timed.push_back(
            {std::to_string(i), {.sampler = "lloyd", .numbers = {{"iterations", i}}, .points = usual_points}});
    auto claim =
        time_claim("6.5-time", "6.5",
                   "1, 2, 4, 8, 16, 32 iterations of 16,384 random points take 21.3, 35.7, 64.4, 120.4, 234.1, "
                   "458.5 s.",
                   timed);
    claim.measure = [measure = claim.measure](const ClaimSeries& report) {
        auto outcome = measure(report);
        if (outcome && !lloyd_of_darts(report, Needs::anything).empty())
            outcome->measured += "; from dart throwing, whose time is in it";
        return outcome;
    };
    return claim;
}

/// The iterations after which the relative radius of a set falls, once the first loss from a good start is over, in
/// each realization.
SampleMean falls_of(const ReportSeries& series)
{
    std::vector<double> falls;
    for (const auto& realization : series.iterations) {
        int count = 0;
        for (std::size_t i = 17; i < realization.size() && i <= 128; ++i)
            count += realization[i].relative_radius < realization[i - 1].relative_radius;
        falls.push_back(count);
    }
    return sample_mean(falls);
}

Outcome lloyd_in_space(const ClaimSeries& report)
{
    const auto in_words = [](const SampleMean& falls) {
        return format_estimate(falls.value, falls.standard_error, 2).text();
    };
    Cases cases;
    for (const auto* space : lloyd_of_darts(report, Needs::iterations, 3))
        for (const auto* plane : long_relaxations(report)) {
            if (plane->stored->points != space->stored->points || radii(*space).size() <= iterations_that_tell)
                continue;
            if (plane->iterations.empty() || space->iterations.empty()) continue;
            const SampleMean in_space = falls_of(*space), in_plane = falls_of(*plane);
            const double error = std::hypot(in_space.standard_error, in_plane.standard_error);
            cases.add(is_above({in_space.value - in_plane.value, error}, 0),
                      fmt::format("N = {}: {} falls a set, in 2D {}; at {} then, in 2D {}",
                                  format_count(space->stored->points), in_words(in_space), in_words(in_plane),
                                  format_fixed(radii(*space).back(), 3), format_fixed(radii(*plane).back(), 3)));
        }
    return cases.outcome();
}

}

std::vector<PaperClaim> claims_about_lloyd()
{
    return {
        {"6.5-converges", "6.5", "Lloyd relaxation of dart throwing converges in about 16 to 32 iterations.",
         "within 0.02 of iteration 32, where the paper's times end, the mean relative radius is from iteration 8 to 28 "
         "on; and it changes by at most 0.01 after it, of which fewer than 64 iterations tell nothing",
         lloyd_converges},
        {"6.5-increases", "6.5", "Lloyd relaxation increases the relative radius of dart throwing.",
         "after 32 iterations the relative radius is larger than at first, by two standard errors, set by set; it may "
         "fall in between",
         lloyd_increases},
        {"6.5-fewer-points", "6.5", "Sets of fewer points settle at a slightly higher relative radius.",
         "after the last iteration that both have, every series has a larger mean than those of more points, by two "
         "standard errors",
         fewer_points_higher},
        {"6.5-settles", "6.5", "In general sets settle at a relative radius of about 0.75 to 0.85.",
         "after the last iteration, of more than 64, the mean is in this range by two standard errors", settles_high},
        {"6.5-peaks", "6.5", "The peaks of the spectrum grow, and the rise gets steeper, with each iteration.",
         "from one number of iterations to the next the highest radial power grows, and the rise from 0.25 to 0.75 "
         "gets narrower, by two standard errors",
         peaks_grow},
        {"6.5-anisotropy", "6.5", "Relaxation does not increase the anisotropy, or not significantly.",
         "after every number of iterations less than 0.5 dB more than before, on average over rings of at least 100 "
         "samples",
         anisotropy_stays},
        {"6.5-grid", "6.5", "Larger sets do not fall back into a regular hexagonal grid.",
         "after 64 iterations and more of at least 4,096 points, fewer than 95 % of the Voronoi cells have six "
         "neighbours",
         no_regular_grid},
        time_claim("6.5-plate", "6.5", "262,144 points, for the zone plate, were too many to relax.",
                   {{"relaxed here", {.sampler = "lloyd", .points = plate_points}}}),
        lloyd_time_claim(),
        {"6.15-lloyd", "6.15",
         "In 3D, Lloyd relaxation converges less easily than in 2D and gets stuck in local minima often.",
         "set by set, the relative radius falls in more of the iterations 16 to 128 than in 2D, of equally many "
         "points, by two standard errors",
         lloyd_in_space},
    };
}

}
