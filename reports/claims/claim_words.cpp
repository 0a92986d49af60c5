#include "reports/claims/claim_words.hpp"

#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace poissonlab {

std::string joined_words(const std::vector<std::string>& parts)
{
    std::string text;
    for (const auto& part : parts)
        if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
    return text;
}

std::string range_words(const std::vector<double>& values, int digits)
{
    if (values.empty()) return "";
    const auto [low, high] = std::ranges::minmax(values);
    const auto from = format_significant(low, digits), to = format_significant(high, digits);
    return from == to ? from : from + " to " + to;
}

std::string range_words(const std::vector<Estimate>& values, int digits)
{
    std::vector<double> alone;
    double error = 0;
    for (const Estimate& value : values) {
        alone.push_back(value.value);
        error = std::max(error, value.standard_error.value_or(0));
    }
    const std::string range = range_words(alone, digits);
    return error > 0 ? fmt::format("{} (± {})", range, format_significant(error, 1)) : range;
}

void Cases::add(Finding finding, std::string words)
{
    tally_.add(finding);
    say(std::move(words));
}

std::optional<ClaimOutcome> Cases::uncounted() const
{
    if (count() == 0) return std::nullopt;
    return ClaimOutcome{agreement(), joined_words(words_)};
}

std::optional<ClaimOutcome> Cases::outcome(const std::string& words, const std::string& after) const
{
    if (count() == 0) return std::nullopt;
    return ClaimOutcome{agreement(), joined_words({words, tally_.words(), after})};
}

std::string with_error(const Estimate& estimate, int decimals)
{
    if (!estimate.standard_error) return format_fixed(estimate.value, decimals);
    return format_estimate(estimate.value, estimate.standard_error, decimals).text();
}

std::string percent_words(double share) { return format_significant(100 * share, 2) + " %"; }

namespace {

/// A radius that is asked for is met to the rounding of coordinates.
constexpr double rounding_of_radius = 1e-6;

/// "device, 2 threads"
std::string machine_words(const Run& run)
{
    const auto device = run.machine.text("device"), threads = run.machine.text("threads");
    std::string text = device;
    if (!threads.empty()) text += (text.empty() ? "" : ", ") + threads + (threads == "1" ? " thread" : " threads");
    return text;
}

}

std::vector<const ReportSeries*> darts_as_large(const ClaimSeries& report, double relative_radius)
{
    auto found = report.all({.sampler = "dart-throwing", .needs = SeriesQuery::Needs::spectrum});
    std::erase_if(found, [&](const ReportSeries* series) {
        const auto& measured = series->stored->relative_radius;
        return !measured || measured->min < relative_radius - rounding_of_radius;
    });
    return found;
}

std::vector<const ReportSeries*> of_even_density(const ClaimSeries& report, const std::string& sampler,
                                                 SeriesQuery::Needs needs)
{
    auto found = report.all({.sampler = sampler, .needs = needs});
    std::erase_if(found, [](const ReportSeries* series) { return follows_density(*series); });
    return found;
}

std::optional<Finding> finds_false_plates(const ClaimSeries& report, const ReportSeries& series)
{
    const auto rings = report.false_rings(series);
    if (!rings) return std::nullopt;
    // Powers of noise are exponential: what is a hundred times rarer lies ln 100 higher.
    const double rarely = rings->bound + std::log(100);
    if (rings->strength > rarely) return Finding::holds;
    return rings->strength > rings->bound ? Finding::open : Finding::fails;
}

std::optional<ClaimOutcome> false_plates(const ClaimSeries& report, const std::vector<const ReportSeries*>& series,
                                         bool should_alias)
{
    Cases cases;
    std::vector<double> strengths;
    double bound = 0;
    for (const auto* entry : series) {
        const auto found = finds_false_plates(report, *entry);
        if (!found) continue;
        cases.add(should_alias ? *found : opposite(*found));
        strengths.push_back(report.false_rings(*entry)->strength);
        bound = report.false_rings(*entry)->bound;
    }
    return cases.outcome(fmt::format("strongest false plate {} times the noise around it; noise alone gives up to {}",
                                     range_words(strengths, 2), format_significant(bound, 2)));
}

/// 0.5 dB is what K = 10 sets and some hundred rings leave open.
std::optional<ClaimOutcome> has_low_anisotropy(const std::vector<const ReportSeries*>& all)
{
    const auto excess = [](const ReportSeries& series) {
        return series.stored->deterministic ? std::nullopt : std::optional(mean_excess_anisotropy(series));
    };
    const auto sets_of = [](const ReportSeries* series) { return series->curve.periodograms; };
    const bool have_one_number =
        !all.empty() && std::ranges::all_of(all, [&](const auto* one) { return sets_of(one) == sets_of(all.front()); });
    const std::string chance =
        have_one_number ? fmt::format(" dB relative to the {} dB that chance gives K = {} sets",
                                      format_fixed(all.front()->curve.background_db, 1), sets_of(all.front()))
                        : std::string(" dB relative to the −10 log₁₀ K dB that chance gives K sets");
    return over(all, excess, within(-0.5, 0.5), 2, chance);
}

Finding compared_plates(double error, double other_error)
{
    constexpr double alike = 0.05;
    if (std::abs(error / other_error - 1) < alike) return Finding::open;
    return finding_if(error < other_error);
}

std::optional<ClaimOutcome> shown_plate_errors(const ClaimSeries& report,
                                               const std::vector<const ReportSeries*>& plates)
{
    const auto errors_of = [](const std::vector<const ReportSeries*>& series) {
        std::vector<double> errors;
        for (const ReportSeries* one : series)
            if (const double error = plate_error(*one, 0, plate_middle); error > 0) errors.push_back(error);
        return errors;
    };
    const std::vector<double> own = errors_of(plates);
    if (own.empty()) return std::nullopt;
    std::vector<std::string> words{range_words(own, 2)};
    for (const auto& [sampler, name] : {std::pair("dart-throwing", "dart throwing"), {"jittered", "jittered points"}})
        if (const auto errors =
                errors_of(report.all({.sampler = sampler, .points = plate_points, .needs = SeriesQuery::Needs::plate}));
            !errors.empty())
            words.push_back(fmt::format("{} {}", name, range_words(errors, 2)));
    return ClaimOutcome{Agreement::shown, joined_words(words)};
}

PaperClaim time_claim(const std::string& id, const std::string& section, const std::string& says,
                      const std::vector<TimedSeries>& timed)
{
    const auto measure = [timed](const ClaimSeries& report) -> std::optional<ClaimOutcome> {
        std::vector<std::string> parts;
        std::set<std::string> machines;
        for (const auto& [name, query] : timed) {
            const auto* series = report.one(query);
            if (series == nullptr || series->stored->sample_seconds.empty()) continue;
            const auto time = format_seconds(median(series->stored->sample_seconds));
            parts.push_back(name.empty() ? time : name + ": " + time);
            machines.insert(machine_words(*series->run));
        }
        if (parts.empty()) return std::nullopt;
        for (const auto& machine : machines) parts.push_back(machine);
        return ClaimOutcome{Agreement::shown, joined_words(parts)};
    };
    return {id, section, says, "times of 2006, on one core of an Athlon 64 4000+, beside medians here: shown", measure};
}

std::vector<const ReportSeries*> of_usual_size(const ClaimSeries& report, const std::string& sampler)
{
    auto found = report.all({.sampler = sampler});
    std::erase_if(found, [](const ReportSeries* series) {
        return 2 * series->stored->points < usual_points || series->stored->points > 2 * usual_points;
    });
    return found;
}

std::optional<ClaimOutcome> shown_times(const ClaimSeries& report, const std::vector<const char*>& samplers)
{
    std::vector<std::string> parts;
    std::set<std::string> machines;
    for (const char* sampler : samplers) {
        std::vector<double> seconds;
        for (const ReportSeries* series : of_usual_size(report, sampler))
            if (const auto median = median_seconds(*series)) {
                seconds.push_back(*median);
                machines.insert(machine_words(*series->run));
            }
        if (seconds.empty()) continue;
        const auto [least, most] = std::ranges::minmax(seconds);
        const std::string from = format_seconds(least), to = format_seconds(most);
        parts.push_back(fmt::format("{} {}{}", sampler, from, from == to ? "" : " to " + to));
    }
    if (parts.empty()) return std::nullopt;
    parts.insert(parts.end(), machines.begin(), machines.end());
    return ClaimOutcome{Agreement::shown, joined_words(parts)};
}

namespace {

/// A larger one by so much shows that "up to" is not the end.
constexpr double clearly_more = 0.005;

/// The largest radius that all realizations of a series have, and whether any series was made to have as much.
struct LargestRadius
{
    double radius = 0;
    bool was_asked_for = false;
};

LargestRadius largest_radius(const std::vector<const ReportSeries*>& series, double asked)
{
    LargestRadius found;
    for (const ReportSeries* entry : series) {
        if (!entry->stored->relative_radius) continue;
        found.radius = std::max(found.radius, entry->stored->relative_radius->min);
        found.was_asked_for = found.was_asked_for || text_parameter(*entry, "stop") == "saturation" ||
                              number_parameter(*entry, "relative_radius").value_or(0) >= asked;
    }
    return found;
}

ClaimOutcome judged_reach(const LargestRadius& found, double asked)
{
    const std::string radius = format_fixed(found.radius, 4) + " in every realization";
    if (found.radius > asked + clearly_more) return {Agreement::partly, radius + ", which is more"};
    if (found.radius > asked - rounding_of_radius) return {Agreement::agrees, radius};
    if (found.was_asked_for) return {Agreement::disagrees, radius + ", where more was asked for"};
    return {Agreement::open, radius + ", and no series was asked for more"};
}

bool repels(const ReportSeries* series) { return text_parameter(*series, "repulsion") == "true"; }

std::string reach_criterion(double radius)
{
    return fmt::format("the smallest relative radius of all realizations of a series is at least {}; partly: it is "
                       "more; open: no series was asked for so much",
                       format_exact(radius));
}

}

PaperClaim reach_claim(const std::string& id, const std::string& section, const std::string& says,
                       const SeriesQuery& query, double asked)
{
    return {id, section, says, reach_criterion(asked),
            [query, asked](const ClaimSeries& report) -> std::optional<ClaimOutcome> {
                const LargestRadius found = largest_radius(report.all(query), asked);
                return found.radius == 0 ? std::nullopt : std::optional(judged_reach(found, asked));
            }};
}

PaperClaim reach_by_lloyd_claim(const std::string& id, const std::string& section, const std::string& says,
                                const SeriesQuery& query, double asked)
{
    const auto measure = [query, asked](const ClaimSeries& report) -> std::optional<ClaimOutcome> {
        auto by_lloyd = report.all(query), by_repulsion = by_lloyd;
        std::erase_if(by_lloyd, repels);
        std::erase_if(by_repulsion, [](const ReportSeries* series) { return !repels(series); });
        const LargestRadius lloyd = largest_radius(by_lloyd, asked), repelled = largest_radius(by_repulsion, asked);
        if (lloyd.radius == 0 && repelled.radius == 0) return std::nullopt;
        const ClaimOutcome own = judged_reach(lloyd, asked), with = judged_reach(repelled, asked);
        if (lloyd.radius > asked - rounding_of_radius) return own;
        if (repelled.radius > asked - rounding_of_radius)
            return ClaimOutcome{Agreement::partly,
                                fmt::format("{} by repulsion after Lloyd relaxation, which the paper does without; {}",
                                            format_fixed(repelled.radius, 4),
                                            lloyd.radius == 0 ? "no series is without"
                                                              : "without it " + format_fixed(lloyd.radius, 4))};
        return repelled.radius > lloyd.radius ? with : own;
    };
    return {id, section, says,
            reach_criterion(asked) + ". The paper gets there by Lloyd relaxation; where only repulsion after it does, "
                                     "the claim holds in part",
            measure};
}

BlueNoise blue_noise(const ReportSeries& series)
{
    if (series.curve.bins.empty()) return {};
    const double principal = usual_principal_frequency(series);
    const auto low = mean_power(series, 0, 0.5 * principal), high = mean_power(series, 1.5 * principal, 1e9);
    if (!low) return {};
    const double place = power_peak(series).frequency / principal;
    BlueNoise result;
    result.finding = both(is_below(*low, 0.2), finding_if(std::abs(place - 1) < 0.25));
    if (high) result.finding = both(result.finding, is_within(*high, 0.9, 1.1));
    result.words = fmt::format("{} below half of it, highest at {} of it{}", format_significant(low->value, 2),
                               format_fixed(place, 2), high ? ", then " + format_fixed(high->value, 3) : "");
    return result;
}

std::optional<ClaimOutcome> all_blue_noise(const std::vector<const ReportSeries*>& series)
{
    constexpr std::size_t most_words = 3;
    Cases cases;
    std::size_t said = 0;
    for (const ReportSeries* entry : series) {
        const BlueNoise found = blue_noise(*entry);
        if (found.words.empty()) continue;
        cases.add(found.finding, said++ < most_words ? entry->label + ": " + found.words : "");
    }
    return cases.outcome();
}

std::optional<double> median_seconds(const ReportSeries& series)
{
    std::vector<double> seconds = series.stored->sample_seconds;
    if (seconds.empty()) return std::nullopt;
    std::ranges::sort(seconds);
    return seconds[seconds.size() / 2];
}

}
