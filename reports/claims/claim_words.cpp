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
    const auto [low, high] = std::ranges::minmax(values);
    const auto from = format_significant(low, digits), to = format_significant(high, digits);
    return from == to ? from : from + " to " + to;
}

std::string with_error(const Estimate& estimate, int decimals)
{
    const std::string value = format_fixed(estimate.value, decimals);
    if (!estimate.standard_error) return value;
    return fmt::format("{} ± {}", value, format_significant(*estimate.standard_error, 1));
}

std::string percent_words(double share) { return format_significant(100 * share, 2) + " %"; }

namespace {

/// "device, 2 threads"
std::string machine_words(const Run& run)
{
    const auto device = run.machine.text("device"), threads = run.machine.text("threads");
    std::string text = device;
    if (!threads.empty()) text += (text.empty() ? "" : ", ") + threads + (threads == "1" ? " thread" : " threads");
    return text;
}

}

bool follows_density(const ReportSeries& series) { return !text_parameter(series, "density").empty(); }

std::vector<const ReportSeries*> of_even_density(const ClaimSeries& report, const std::string& sampler,
                                                 SeriesQuery::Needs needs)
{
    auto found = report.all({.sampler = sampler, .needs = needs});
    std::erase_if(found, [](const ReportSeries* series) { return follows_density(*series); });
    return found;
}

std::optional<ClaimOutcome> false_plates(const ClaimSeries& report, const std::vector<const ReportSeries*>& series,
                                         bool should_alias)
{
    Tally tally;
    std::vector<double> strengths;
    double bound = 0;
    for (const auto* entry : series) {
        const auto rings = report.false_rings(*entry);
        if (!rings) continue;
        tally.add(should_alias ? rings->strength > rings->bound : rings->strength < rings->bound);
        strengths.push_back(rings->strength);
        bound = rings->bound;
    }
    if (tally.empty()) return std::nullopt;
    return ClaimOutcome{
        tally.agreement(),
        joined_words({fmt::format("strongest false plate {} times the noise around it; noise alone gives up to {}",
                                  range_words(strengths, 2), format_significant(bound, 2)),
                      tally.words()})};
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
        return ClaimOutcome{Agreement::not_judged, joined_words(parts)};
    };
    return {id, section, says, "times of 2006, on one core of an Athlon 64 4000+, beside medians here: not judged",
            measure};
}

PaperClaim reach_claim(const std::string& id, const std::string& section, const std::string& says,
                       const SeriesQuery& query, double relative_radius)
{
    const auto measure = [query, relative_radius](const ClaimSeries& report) -> std::optional<ClaimOutcome> {
        double best = 0;
        for (const auto* series : report.all(query))
            if (series->stored->relative_radius) best = std::max(best, series->stored->relative_radius->min);
        if (best == 0) return std::nullopt;
        // Six digits: a radius that is asked for is met to the rounding of coordinates.
        const bool reached = best > relative_radius - 1e-6;
        // A larger one shows that "up to" is not the end.
        const bool exceeded = best > relative_radius + 0.005;
        return ClaimOutcome{reached && !exceeded ? Agreement::agrees : Agreement::partly,
                            fmt::format("{} in every realization{}", format_fixed(best, 4),
                                        !reached   ? ", the largest in this report"
                                        : exceeded ? ", which is more"
                                                   : "")};
    };
    return {
        id, section, says,
        fmt::format("the smallest relative radius of all realizations of a series is at least {}; partly: the report "
                    "has no series of so much, or one of more",
                    format_exact(relative_radius)),
        measure};
}

BlueNoise blue_noise(const ReportSeries& series)
{
    const auto low = mean_power(series, 0, 0.5), high = mean_power(series, 1.5, 100);
    BlueNoise result;
    if (!low || !series.curve.principal_frequency) return result;
    const double place = power_peak(series).frequency / *series.curve.principal_frequency;
    const bool flat = !high || std::abs(*high - 1) < 0.1;
    result.holds = *low < 0.2 && std::abs(place - 1) < 0.25 && flat;
    result.words = fmt::format("{} below half of 1/d_min, highest at {} of it{}", format_significant(*low, 2),
                               format_fixed(place, 2), high ? ", then " + format_fixed(*high, 3) : "");
    return result;
}

std::optional<double> median_seconds(const ReportSeries& series)
{
    std::vector<double> seconds = series.stored->sample_seconds;
    if (seconds.empty()) return std::nullopt;
    std::ranges::sort(seconds);
    return seconds[seconds.size() / 2];
}

}
