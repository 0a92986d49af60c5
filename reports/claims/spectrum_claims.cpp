// Claims about spectra that methods reach: effective Nyquist frequency and oscillation, and those of Heck and others
// (2013), who ask for a spectrum.
#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace poissonlab {
namespace {

/// The farthest step that a set can have, 1 / sqrt(pi) in units of sqrt(N), and its effective Nyquist frequency.
constexpr double farthest_step = 0.5642, farthest_nyquist = 0.595;

/// A step is there where none is asked for.
constexpr double usual_step = 0.55;

std::vector<const ReportSeries*> series_with_target(const ClaimSeries& report, const std::string& target)
{
    auto found = report.all({.sampler = "target-spectrum", .needs = SeriesQuery::Needs::spectrum});
    std::erase_if(found, [&](const ReportSeries* series) { return text_parameter(*series, "target") != target; });
    return found;
}

/// Effective Nyquist frequencies below that of the farthest step, for steps that can be; or above, for peaks behind
/// steps that cannot. Sets are asked for the power of rings of whole frequencies, which makes steps up to half a ring
/// farther.
std::optional<ClaimOutcome> nyquist_beside_the_step(const ClaimSeries& report, const std::string& target,
                                                    bool is_below_step)
{
    Cases cases;
    for (const ReportSeries* series : series_with_target(report, target)) {
        const Estimate* nyquist = estimate_of(*series, "effective_nyquist");
        const double step = number_parameter(*series, "frequency").value_or(usual_step);
        if (!nyquist || (step <= farthest_step) != is_below_step) continue;
        // Chance may take sets beyond by three errors; by five it does not.
        const double ring = is_below_step ? 0.5 / std::sqrt(static_cast<double>(series->stored->points)) : 0;
        const double beyond = (nyquist->value - ring - farthest_nyquist) / nyquist->standard_error.value_or(1e-9);
        const Finding is_farther = beyond > 5 ? Finding::holds : beyond > 3 ? Finding::open : Finding::fails;
        cases.add(is_below_step ? opposite(is_farther) : is_farther,
                  fmt::format("asked for at {}: {}", format_significant(step, 3), with_error(*nyquist, 3)));
    }
    return cases.uncounted();
}

constexpr std::array optimised_methods = {"farthest-point", "gaussian-blue-noise", "equal-areas", "lloyd"};

/// The step against every other method that moves points until they are good, of as many points.
std::optional<ClaimOutcome> step_oscillates_least(const ClaimSeries& report)
{
    Cases cases;
    for (const ReportSeries* step : series_with_target(report, "step")) {
        if (!step->stored->measures.oscillation) continue;
        const Oscillation& mine = *step->stored->measures.oscillation;
        const Estimate own{mine.value, mine.standard_error};
        for (const char* sampler : optimised_methods)
            for (const ReportSeries* other : report.all({.sampler = sampler, .points = step->stored->points})) {
                if (!other->stored->measures.oscillation || !has_estimated_spectrum(*other)) continue;
                if (follows_density(*other)) continue;
                const Oscillation& theirs = *other->stored->measures.oscillation;
                const Estimate value{theirs.value, theirs.standard_error};
                cases.add(is_below(difference_of(own, value), 0),
                          fmt::format("{} against {} of {}", with_error(own, 2), with_error(value, 2), other->label));
            }
    }
    return cases.uncounted();
}

}

PaperClaim nyquist_and_oscillation(const char* id, const char* says, const char* criterion, const char* sampler)
{
    return {id, "", says, criterion, [sampler](const ClaimSeries& report) -> std::optional<ClaimOutcome> {
                std::vector<std::string> words;
                for (const ReportSeries* series : of_even_density(report, sampler, SeriesQuery::Needs::spectrum)) {
                    const Estimate* nyquist = estimate_of(*series, "effective_nyquist");
                    const auto& oscillation = series->stored->measures.oscillation;
                    if (nyquist && oscillation)
                        words.push_back(fmt::format("{}, N = {}: {} and {}", series->label,
                                                    format_count(series->stored->points), with_error(*nyquist, 3),
                                                    with_error({oscillation->value, oscillation->standard_error}, 2)));
                }
                if (words.empty()) return std::nullopt;
                return ClaimOutcome{Agreement::shown, joined_words(words)};
            }};
}

std::vector<PaperClaim> claims_about_controlled_aliasing()
{
    return {{"heck-2013-step", "",
             "A step of the spectrum from 0 to 1 lies at √(N/π) at most, an effective Nyquist frequency of 0.595.",
             "sets that descend to a step there or before have at most that and half a ring, but for three standard "
             "errors; "
             "open up to five",
             [](const ClaimSeries& report) { return nyquist_beside_the_step(report, "step", true); }},
            {"heck-2013-peak", "", "A single peak behind a step lets the step be farther.",
             "sets that descend to a single peak behind a farther step have more, by five standard errors; open from "
             "three on",
             [](const ClaimSeries& report) { return nyquist_beside_the_step(report, "single-peak", false); }},
            {"heck-2013-oscillation", "", "Behind a step the spectrum is flat, so that aliasing is noise.",
             "less oscillation than any other method that optimises sets, of as many points, by two standard errors",
             step_oscillates_least},
            nyquist_and_oscillation(
                "heck-2013-spectrum",
                "The spectrum, as effective Nyquist frequency and oscillation, which the paper defines.",
                "shown beside those of other methods: numbers of the paper were not at hand", "target-spectrum")};
}

}
