// Claims of sections 6.2 to 6.5 and 6.15, about sets without tiles.
#include "analysis/statistics/welch.hpp"
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <boost/math/distributions/students_t.hpp>
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

SeriesQuery relaxation_darts(double factor, double attempts, Needs needs = Needs::anything,
                             std::size_t points = usual_points)
{
    return {.sampler = "relaxation-dart-throwing",
            .numbers = {{"initial_radius", 0.15}, {"factor", factor}, {"attempts", attempts}},
            .points = points,
            .needs = needs};
}

bool starts_with(const ReportSeries& series, const std::string& sampler)
{
    for (const auto& [key, value] : series.stored->parameters)
        if (key == "start") return value.starts_with(sampler);
    return sampler == "random"; // the default
}

/// Lloyd series from dart throwing, without repulsion afterwards.
std::vector<const ReportSeries*> lloyd_of_darts(const ClaimSeries& report, Needs needs, int dimension = 2)
{
    auto found = report.all({.sampler = "lloyd", .dimension = dimension, .needs = needs});
    std::erase_if(found, [](const auto* series) {
        const bool repels = std::ranges::any_of(series->stored->parameters, [](const auto& parameter) {
            return parameter.first == "repulsion" && parameter.second == "true";
        });
        return repels || !starts_with(*series, "dart-throwing");
    });
    return found;
}

const std::vector<double>& radii(const ReportSeries& series) { return series.stored->iterations->relative_radius.mean; }

// 6.2.2

/// The ring that is furthest from power 1 in standard errors, corrected for the number of rings.
Outcome flat_spectrum(const ClaimSeries& report)
{
    const auto* series = report.one({.sampler = "random", .needs = Needs::spectrum});
    if (series == nullptr || series->stored->realizations < 2) return std::nullopt;
    double furthest = -1;
    for (const auto& bin : series->curve.bins)
        if (bin.power_error > 0) furthest = std::max(furthest, std::abs(bin.power - 1) / bin.power_error);
    if (furthest < 0) return std::nullopt; // no error is stored
    const boost::math::students_t distribution(series->stored->realizations - 1);
    const double p = 2 * boost::math::cdf(boost::math::complement(distribution, furthest)) *
                     static_cast<double>(series->curve.bins.size());
    return ClaimOutcome{p > 0.01 ? Agreement::agrees : Agreement::disagrees,
                        fmt::format("of {} rings the furthest from 1 is {} standard errors away, p = {}",
                                    format_count(series->curve.bins.size()), format_fixed(furthest, 1),
                                    format_significant(std::min(1.0, p), 2))};
}

/// The mean over rings of what white noise has on average; 0.5 dB is what K = 10 sets and some hundred rings leave
/// open.
Outcome low_anisotropy(const std::vector<const ReportSeries*>& all)
{
    Tally tally;
    std::vector<double> values;
    for (const auto* series : all) {
        if (series->stored->deterministic) continue;
        values.push_back(mean_excess_anisotropy(*series));
        tally.add(std::abs(values.back()) < 0.5);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(values, 2) + " dB from it", tally.words()})};
}
constexpr auto anisotropy_criterion =
    "the mean over rings of at least 100 samples is within 0.5 dB of −10 log10 K, what chance alone gives";

Outcome all_blue_noise(const std::vector<const ReportSeries*>& all)
{
    Tally tally;
    std::vector<std::string> words;
    for (const auto* series : all) {
        const auto blue = blue_noise(*series);
        tally.add(blue.holds);
        if (words.size() < 3) words.push_back(series->label + ": " + blue.words);
    }
    if (tally.empty()) return std::nullopt;
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

std::vector<PaperClaim> methodology_claims()
{
    return {
        {"6.2.2-flat", "6.2.2", "The spectrum of a Poisson distribution is flat.",
         "no ring is further from 1 than chance makes it once in 100 (Student's t, corrected for the number of rings)",
         flat_spectrum},
        {"6.2.2-poisson-anisotropy", "6.2.2",
         "The anisotropy of a Poisson distribution is close to −10 dB: radial symmetry.", anisotropy_criterion,
         [](const ClaimSeries& report) {
             return low_anisotropy(report.all({.sampler = "random", .needs = Needs::spectrum}));
         }},
        {"6.2.2-disk-anisotropy", "6.2.2", "The anisotropy of a Poisson disk distribution is close to −10 dB as well.",
         anisotropy_criterion,
         [](const ClaimSeries& report) {
             return low_anisotropy(report.all({.sampler = "dart-throwing", .needs = Needs::spectrum}));
         }},
        {"6.2.2-blue-noise", "6.2.2",
         "A Poisson disk distribution has little power at low frequencies, a sharp rise at the principal frequency, "
         "and is flatter beyond.",
         blue_noise_criterion,
         [](const ClaimSeries& report) { return all_blue_noise(report.all(darts(0.75, Needs::spectrum))); }},
        {"6.2.3-aliasing", "6.2.3",
         "A regular pattern aliases: false rings in the zone plate. A stratified one trades them for noise.",
         "the strongest false plate of regular points is at least 100 times as strong as that of jittered ones, of "
         "which none away from the origin is stronger than noise makes once in 100 pictures",
         [](const ClaimSeries& report) -> Outcome {
             const auto* regular = report.one({.sampler = "regular", .needs = Needs::plate});
             const auto* jittered = report.one({.sampler = "jittered", .needs = Needs::plate});
             if (regular == nullptr || jittered == nullptr) return std::nullopt;
             const auto a = report.false_rings(*regular), b = report.false_rings(*jittered);
             if (!a || !b) return std::nullopt;
             const double strong = std::max(a->strength, a->at_the_plate),
                          weak = std::max(b->strength, b->at_the_plate);
             const bool traded = strong >= 100 * weak, noise = b->strength < b->bound;
             return ClaimOutcome{traded && noise   ? Agreement::agrees
                                 : traded || noise ? Agreement::partly
                                                   : Agreement::disagrees,
                                 fmt::format("{} times the noise around it, against {}; noise alone gives up to {}",
                                             format_significant(strong, 2), format_significant(weak, 2),
                                             format_significant(b->bound, 2))};
         }},
    };
}

// 6.3 and 6.4

/// Root mean square errors in the upper half of what pixels can show.
constexpr double plate_low = 0.25, plate_high = 0.5;
constexpr auto plate_criterion = "lower root mean square error where the plate has a quarter to half a cycle per pixel "
                                 "(one set each: no error known)";

Outcome plate_better(const ClaimSeries& report, const SeriesQuery& good, const SeriesQuery& other)
{
    const auto* a = report.one(good);
    const auto* b = report.one(other);
    if (a == nullptr || b == nullptr) return std::nullopt;
    const double x = plate_error(*a, plate_low, plate_high), y = plate_error(*b, plate_low, plate_high);
    if (x == 0 || y == 0) return std::nullopt;
    return ClaimOutcome{x < y ? Agreement::agrees : Agreement::disagrees,
                        fmt::format("{}, against {}", format_significant(x, 3), format_significant(y, 3))};
}

std::vector<PaperClaim> dart_throwing_claims()
{
    const SeriesQuery jittered{.sampler = "jittered", .points = plate_points, .needs = Needs::plate};
    return {
        reach_claim("6.3-radius", "6.3", "Dart throwing reaches relative radii of up to 0.75.",
                    {.sampler = "dart-throwing", .points = usual_points}, 0.75),
        {"6.3-spectrum", "6.3", "The radially averaged power of dart throwing is that of blue noise.",
         blue_noise_criterion,
         [](const ClaimSeries& report) {
             return all_blue_noise(
                 report.all({.sampler = "dart-throwing", .points = usual_points, .needs = Needs::spectrum}));
         }},
        {"6.3-noise", "6.3", "In the zone plate, undersampling causes noise rather than aliasing.",
         "no false plate is stronger than noise makes once in 100 pictures",
         [](const ClaimSeries& report) {
             const SeriesQuery darts{.sampler = "dart-throwing", .points = plate_points, .needs = Needs::plate};
             return false_plates(report, report.all(darts), false);
         }},
        {"6.3-plate", "6.3",
         "Dart throwing reproduces the zone plate significantly better at higher frequencies than a stratified pattern "
         "does.",
         plate_criterion,
         [jittered](const ClaimSeries& report) {
             return plate_better(report, darts(0.70, Needs::plate, plate_points), jittered);
         }},
        time_claim("6.3-time", "6.3", "16,384 points take 35.0 s for ρ = 0.70 and 263.5 s for ρ = 0.75.",
                   {{"ρ = 0.70", darts(0.70)}, {"ρ = 0.75", darts(0.75)}}),
    };
}

struct RelaxationSetting
{
    double factor, attempts, relative_radius;
};
constexpr RelaxationSetting relaxation_settings[] = {{0.9, 100, 0.57}, {0.99, 1000, 0.68}, {0.999, 10000, 0.73}};

/// The text has two digits of one set: half of the last, and two standard deviations of what sets scatter.
double text_tolerance(const Statistic& radius)
{
    if (radius.each.empty()) return 0.005;
    const auto mean = sample_mean(radius.each);
    return 0.005 + 2 * mean.standard_error * std::sqrt(static_cast<double>(mean.samples));
}

Outcome relaxation_radii(const ClaimSeries& report)
{
    Tally tally;
    std::vector<std::string> words;
    for (const auto& setting : relaxation_settings) {
        const auto* series = report.one(relaxation_darts(setting.factor, setting.attempts));
        if (series == nullptr || !series->stored->relative_radius) continue;
        const auto& radius = *series->stored->relative_radius;
        tally.add(std::abs(radius.mean - setting.relative_radius) <= text_tolerance(radius));
        words.push_back(fmt::format("{} ({} to {})", format_fixed(radius.mean, 3), format_fixed(radius.min, 3),
                                    format_fixed(radius.max, 3)));
    }
    if (tally.empty()) return std::nullopt;
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

/// Widths of the rises of dart throwing, by the mean relative radius.
std::map<double, double> rises_of_darts(const ClaimSeries& report)
{
    std::map<double, double> rises;
    for (const auto* series :
         report.all({.sampler = "dart-throwing", .points = usual_points, .needs = Needs::spectrum})) {
        const auto rise = rise_width(*series);
        if (rise && series->stored->relative_radius) rises[series->stored->relative_radius->mean] = *rise;
    }
    return rises;
}

/// Between the two sets of dart throwing whose radii enclose this one; empty where there are none.
std::optional<double> rise_at(const std::map<double, double>& rises, double relative_radius)
{
    const auto above = rises.lower_bound(relative_radius);
    if (above == rises.end()) return std::nullopt;
    if (above->first == relative_radius) return above->second;
    if (above == rises.begin()) return std::nullopt;
    const auto below = std::prev(above);
    const double share = (relative_radius - below->first) / (above->first - below->first);
    return below->second + share * (above->second - below->second);
}

/// The rise gets steeper with the radius, so methods are compared at equal radii.
Outcome relaxation_steeper(const ClaimSeries& report)
{
    const std::map<double, double> darts_at = rises_of_darts(report);
    Tally tally;
    std::vector<std::string> words;
    for (const auto& setting : relaxation_settings) {
        const auto* series = report.one(relaxation_darts(setting.factor, setting.attempts, Needs::spectrum));
        if (series == nullptr || !series->stored->relative_radius) continue;
        const double radius = series->stored->relative_radius->mean;
        const auto rise = rise_width(*series), width = rise_at(darts_at, radius);
        if (!rise || !width) continue;
        tally.add(*rise < *width);
        words.push_back(fmt::format("ρ = {}: {}, dart throwing {}", format_fixed(radius, 3),
                                    format_significant(*rise, 2), format_significant(*width, 2)));
    }
    if (tally.empty()) return std::nullopt;
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
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
         "the mean is within half of the text's last digit and two standard deviations of realizations",
         relaxation_radii},
        {"6.4-steeper", "6.4", "The rise of the radial power is a bit steeper than that of dart throwing.",
         "narrower from power 0.25 to 0.75, in cycles per mean spacing, than between sets of dart throwing with a "
         "smaller and a larger relative radius",
         relaxation_steeper},
        {"6.4-plate", "6.4", "The zone plate is reproduced even better at higher frequencies than by dart throwing.",
         plate_criterion,
         [](const ClaimSeries& report) {
             return plate_better(report, relaxation_darts(0.99, 1000, Needs::plate, plate_points),
                                 darts(0.70, Needs::plate, plate_points));
         }},
        time_claim("6.4-time", "6.4", "16,384 points take 0.020 s, 0.289 s, 11.733 s.", timed),
    };
}

// 6.5

/// The times of the dissertation end with this iteration, and so does, presumably, the plot that it speaks of.
constexpr std::size_t last_of_the_paper = 32;

/// The first iteration from which on the mean relative radius stays within 0.02 of that of iteration 32.
std::size_t settled_at(const std::vector<double>& values)
{
    std::size_t settled = last_of_the_paper;
    while (settled > 0 && std::abs(values[settled - 1] - values[last_of_the_paper]) <= 0.02) --settled;
    return settled;
}

Outcome lloyd_converges(const ClaimSeries& report)
{
    Tally settles, stays;
    std::vector<std::string> words;
    for (const auto* series : lloyd_of_darts(report, Needs::iterations)) {
        const std::vector<double>& values = radii(*series);
        if (values.size() < 65) continue; // twice the 32 of the claim, to see what follows
        const auto settled = settled_at(values);
        const double gain = values.back() - values[last_of_the_paper];
        settles.add(settled >= 8 && settled <= 28);
        stays.add(std::abs(gain) <= 0.01);
        words.push_back(fmt::format("N = {}: from iteration {} on, then {} more up to iteration {}",
                                    format_count(series->stored->points), settled, format_fixed(gain, 3),
                                    values.size() - 1));
    }
    if (settles.empty()) return std::nullopt;
    const Agreement both = settles.agreement() == stays.agreement() ? settles.agreement() : Agreement::partly;
    return ClaimOutcome{both, joined_words(words)};
}

/// Sets of dart throwing, whose radius is large to begin with.
Outcome lloyd_increases(const ClaimSeries& report)
{
    Tally tally;
    std::vector<std::string> words;
    for (const auto* series : lloyd_of_darts(report, Needs::iterations)) {
        const std::vector<double>& values = radii(*series);
        if (values.size() < 33) continue;
        const auto least = std::ranges::min_element(values);
        const auto back = std::find_if(least, values.end(), [&](double value) { return value >= values.front(); });
        tally.add(least == values.begin());
        words.push_back(fmt::format("N = {}: from {}, {} at iteration {}, {}", format_count(series->stored->points),
                                    format_fixed(values.front(), 3), format_fixed(*least, 3), least - values.begin(),
                                    back == values.end()
                                        ? "never more than at first"
                                        : fmt::format("more again from {} on", back - values.begin())));
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

/// Series of the largest number of iterations, by number of points.
std::vector<const ReportSeries*> long_relaxations(const ClaimSeries& report)
{
    auto found = lloyd_of_darts(report, Needs::iterations);
    std::erase_if(found, [](const auto* series) { return radii(*series).size() < 65; });
    std::ranges::stable_sort(found, {}, [](const auto* series) { return series->stored->points; });
    return found;
}

Outcome fewer_points_higher(const ClaimSeries& report)
{
    const auto found = long_relaxations(report);
    Tally tally;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < found.size(); ++i) {
        words.push_back(fmt::format("N = {}: {}", format_count(found[i]->stored->points),
                                    format_fixed(radii(*found[i]).back(), 3)));
        // The tolerance is what chance does to means of K sets that differ by some 0.01.
        if (i > 0) tally.add(radii(*found[i]).back() < radii(*found[i - 1]).back() + 0.003);
    }
    if (tally.empty()) return std::nullopt;
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

Outcome settles_high(const ClaimSeries& report)
{
    Tally tally;
    std::vector<double> values;
    for (const auto* series : long_relaxations(report)) {
        values.push_back(radii(*series).back());
        tally.add(values.back() >= 0.75 && values.back() <= 0.85);
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{tally.agreement(), joined_words({range_words(values, 3), tally.words()})};
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

Outcome peaks_grow(const ClaimSeries& report)
{
    const auto found = relaxed_spectra(report);
    Tally tally;
    std::vector<std::string> heights, widths;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto width = rise_width(*found[i]);
        heights.push_back(format_fixed(power_peak(*found[i]).power, 2));
        if (width) widths.push_back(format_significant(*width, 2));
        if (i == 0) continue;
        tally.add(power_peak(*found[i]).power > power_peak(*found[i - 1]).power);
        if (const auto before = rise_width(*found[i - 1]); before && width) tally.add(*width < *before);
    }
    if (tally.empty()) return std::nullopt;
    const auto list = [](const std::vector<std::string>& parts) {
        std::string text;
        for (const auto& part : parts) text += (text.empty() ? "" : ", ") + part;
        return text;
    };
    return ClaimOutcome{tally.agreement(),
                        joined_words({"peaks " + list(heights), "widths of the rise " + list(widths), tally.words()})};
}

Outcome anisotropy_stays(const ClaimSeries& report)
{
    const auto found = relaxed_spectra(report);
    if (found.size() < 2) return std::nullopt;
    const double rise = mean_excess_anisotropy(*found.back()) - mean_excess_anisotropy(*found.front());
    return ClaimOutcome{std::abs(rise) < 0.5 ? Agreement::agrees : Agreement::disagrees,
                        fmt::format("{} dB more after {} iterations than after {}", format_fixed(rise, 2),
                                    format_exact(*number_parameter(*found.back(), "iterations")),
                                    format_exact(*number_parameter(*found.front(), "iterations")))};
}

Outcome no_regular_grid(const ClaimSeries& report)
{
    const ReportSeries* longest = nullptr;
    for (const auto* series : report.all({.sampler = "lloyd", .needs = Needs::iterations}))
        if (series->stored->points >= 4096 && series->stored->measures.voronoi &&
            (longest == nullptr || series->stored->iterations->count() > longest->stored->iterations->count()))
            longest = series;
    if (longest == nullptr || longest->stored->iterations->count() < 64) return std::nullopt;
    const double six = longest->stored->measures.voronoi->neighbour_share[2];
    return ClaimOutcome{six < 0.95 ? Agreement::agrees : Agreement::disagrees,
                        fmt::format("{} of the cells have six neighbours after {} iterations", percent_words(six),
                                    format_count(longest->stored->iterations->count()))};
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

std::vector<PaperClaim> lloyd_claims()
{
    return {
        {"6.5-converges", "6.5", "Lloyd relaxation of dart throwing converges in about 16 to 32 iterations.",
         "within 0.02 of iteration 32, where the paper's times end, the mean relative radius is from iteration 8 to 28 "
         "on; and it changes by at most 0.01 after it",
         lloyd_converges},
        {"6.5-increases", "6.5", "Lloyd relaxation increases the relative radius of dart throwing.",
         "the mean relative radius is never below that of the start", lloyd_increases},
        {"6.5-fewer-points", "6.5", "Sets of fewer points settle at a slightly higher relative radius.",
         "the last mean falls with the number of points, but for 0.003", fewer_points_higher},
        {"6.5-settles", "6.5", "In general sets settle at a relative radius of about 0.75 to 0.85.",
         "the last mean is in this range", settles_high},
        {"6.5-peaks", "6.5", "The peaks of the spectrum grow, and the rise gets steeper, with each iteration.",
         "from one number of iterations to the next the highest radial power grows, and the rise from 0.25 to 0.75 "
         "gets narrower",
         peaks_grow},
        {"6.5-anisotropy", "6.5", "Relaxation does not increase the anisotropy, or not significantly.",
         "less than 0.5 dB on average over rings of at least 100 samples", anisotropy_stays},
        {"6.5-grid", "6.5", "Larger sets do not fall back into a regular hexagonal grid.",
         "after the most iterations of at least 4,096 points, fewer than 95 % of the Voronoi cells have six neighbours",
         no_regular_grid},
        time_claim("6.5-plate", "6.5", "262,144 points, for the zone plate, were too many to relax.",
                   {{"relaxed here", {.sampler = "lloyd", .points = plate_points}}}),
        lloyd_time_claim(),
    };
}

// 6.15

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
        return fmt::format("{} ± {}", format_fixed(falls.value, 1), format_fixed(falls.standard_error, 1));
    };
    Tally tally;
    std::vector<std::string> words;
    for (const auto* space : lloyd_of_darts(report, Needs::iterations, 3))
        for (const auto* plane : long_relaxations(report)) {
            if (plane->stored->points != space->stored->points || radii(*space).size() < 65) continue;
            if (plane->iterations.empty() || space->iterations.empty()) continue;
            const SampleMean in_space = falls_of(*space), in_plane = falls_of(*plane);
            const double error = std::hypot(in_space.standard_error, in_plane.standard_error);
            tally.add(in_space.value - in_plane.value > 2 * error);
            words.push_back(fmt::format("N = {}: {} falls a set, in 2D {}; at {} then, in 2D {}",
                                        format_count(space->stored->points), in_words(in_space), in_words(in_plane),
                                        format_fixed(radii(*space).back(), 3), format_fixed(radii(*plane).back(), 3)));
        }
    if (tally.empty()) return std::nullopt;
    words.push_back(tally.words());
    return ClaimOutcome{tally.agreement(), joined_words(words)};
}

std::vector<PaperClaim> space_claims()
{
    return {
        reach_claim("6.15-darts", "6.15", "In 3D, dart throwing reaches relative radii of up to 0.70.",
                    {.sampler = "dart-throwing", .dimension = 3}, 0.70),
        {"6.15-relaxation", "6.15",
         "In 3D, relaxation dart throwing with a factor of 0.99 after 1,000 failures reaches 0.70.",
         "the mean is within half of the text's last digit and two standard deviations of realizations",
         [](const ClaimSeries& report) -> Outcome {
             auto query = relaxation_darts(0.99, 1000);
             query.points.reset();
             query.dimension = 3;
             const auto* series = report.one(query);
             if (series == nullptr || !series->stored->relative_radius) return std::nullopt;
             const auto& radius = *series->stored->relative_radius;
             return ClaimOutcome{std::abs(radius.mean - 0.70) <= text_tolerance(radius) ? Agreement::agrees
                                                                                        : Agreement::disagrees,
                                 format_fixed(radius.mean, 3)};
         }},
        {"6.15-lloyd", "6.15",
         "In 3D, Lloyd relaxation converges less easily than in 2D and gets stuck in local minima often.",
         "set by set, the relative radius falls in more of the iterations 16 to 128 than in 2D, of equally many "
         "points, by two standard errors",
         lloyd_in_space},
        {"6.15-spectrum", "6.15",
         "The spectrum of Poisson sphere distributions by dart throwing is that of blue noise.", blue_noise_criterion,
         [](const ClaimSeries& report) {
             return all_blue_noise(report.all({.sampler = "dart-throwing", .dimension = 3, .needs = Needs::spectrum}));
         }},
        {"6.15-symmetry", "6.15", "The spectrum of Poisson sphere distributions is radially symmetric.",
         anisotropy_criterion,
         [](const ClaimSeries& report) {
             return low_anisotropy(report.all({.sampler = "dart-throwing", .dimension = 3, .needs = Needs::spectrum}));
         }},
    };
}

}

std::vector<PaperClaim> claims_about_untiled_sets()
{
    std::vector<PaperClaim> claims;
    for (const auto& part :
         {methodology_claims(), dart_throwing_claims(), relaxation_claims(), lloyd_claims(), space_claims()})
        claims.insert(claims.end(), part.begin(), part.end());
    return claims;
}

}
