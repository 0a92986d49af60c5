#include "reports/pages/verdicts.hpp"

#include "analysis/measures/peak_anisotropy.hpp"
#include "reports/words/number_format.hpp"
#include "results/measures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

/// The limits of the sentence.
constexpr double far_apart = 0.65, near_each_other = 0.4;                  ///< relative radius
constexpr double quiet = 0.1, noisy = 0.5, like_random = 0.9, worse = 1.1; ///< mean power at low frequencies
constexpr double no_waves = 1e-3;    ///< mean power at low frequencies, below which long waves do not show
constexpr double strong_peaks = 1.5; ///< lattice peaks over the power around them
constexpr double deep_seams = 0.2;   ///< deviation of the density at seams

/// The words for and against a series.
struct Opinion
{
    std::vector<std::string> good, bad;
};

std::optional<double> value_of(const ReportSeries& series, const char* key)
{
    const auto value = poissonlab::measure(key).get(*series.stored);
    return value ? std::optional(value->value) : std::nullopt;
}

/// "6.2", "62", "1,240".
std::string amount_words(double value)
{
    return value < 9.95 ? format_significant(value, 2) : format_count(static_cast<std::uint64_t>(std::llround(value)));
}

/// Sets in which only pairs across the border are near are judged by the distances inside.
void judge_distances(const ReportSeries& series, Opinion& opinion)
{
    const auto& stored = series.stored->relative_radius;
    if (!stored) return;
    const bool is_inside = is_not_periodic(series);
    const double radius = is_inside ? series.stored->border->relative_radius : stored->min;
    const char* name = series.stored->realizations == 1 ? "" : is_inside ? "mean " : "least ";
    const std::string words = fmt::format("{}ρ = {}", name, format_significant(radius, 3));
    if (radius >= far_apart)
        opinion.good.push_back(fmt::format("all points keep apart ({})", words));
    else if (radius >= near_each_other)
        opinion.bad.push_back(fmt::format("some points are near each other ({})", words));
    else
        opinion.bad.push_back(fmt::format("points nearly meet ({})", words));
}

void judge_noise(const ReportSeries& series, Opinion& opinion)
{
    const auto power = value_of(series, "low_frequency_mean");
    if (!power) return;
    const std::string share = amount_words(100 * *power) + " % of that of random points";
    if (*power <= quiet)
        opinion.good.push_back("little noise at low frequencies, " + share);
    else if (*power <= noisy)
        opinion.bad.push_back("noise at low frequencies, " + share);
    else if (*power <= like_random)
        opinion.bad.push_back("much noise at low frequencies, " + share);
    else if (*power <= worse)
        opinion.bad.emplace_back("as noisy at low frequencies as random points");
    else
        opinion.bad.push_back("more noise at low frequencies than random points have, " + share);
}

/// Long waves are a rise of the power towards frequency 0: relaxation from a random start takes them away last.
void judge_long_waves(const ReportSeries& series, Opinion& opinion)
{
    const auto& numbers = series.stored->measures.numbers;
    const auto exponent = numbers.find("hyperuniformity_exponent");
    if (exponent == numbers.end() || value_of(series, "low_frequency_mean").value_or(0) < no_waves) return;
    if (!series.stored->region &&
        !is_power_law(*series.stored, exponent->second.value, exponent->second.standard_error.value_or(0)))
        opinion.bad.emplace_back("long waves, as the power rises towards frequency 0");
}

void judge_directions(const ReportSeries& series, Opinion& opinion)
{
    if (const auto above = anisotropy_above_chance(series)) {
        if (*above > 0)
            opinion.bad.push_back(fmt::format("directions or peaks, {} dB above chance", format_fixed(*above, 1)));
        else
            opinion.good.emplace_back("no preferred directions");
    }
    if (const auto peaks = value_of(series, "near_lattice_peaks"); peaks && *peaks > strong_peaks)
        opinion.bad.push_back(
            fmt::format("its tiles show as peaks, {} times the power around them", amount_words(*peaks)));
    if (const auto seams = value_of(series, "seam_density"); seams && *seams > deep_seams)
        opinion.bad.push_back(fmt::format("seams, where the density deviates by {} %", amount_words(100 * *seams)));
}

/// Rings of an older result, one frequency wide.
std::optional<double> above_chance_of_curve(const ReportSeries& series)
{
    const auto& bins = series.curve.bins;
    const bool is_fine = bins.size() > 2 && bins[1].frequency - bins[0].frequency == 1;
    if (!is_fine || !reaches_as_asked(*series.stored, series.run->dimension) ||
        (series.stored->region && series.stored->region->tapers > 0))
        return std::nullopt;
    return anisotropy_above_chance_db(bins, std::max(series.curve.periodograms, 1));
}

}

bool is_not_periodic(const ReportSeries& series)
{
    return series.stored->border && series.stored->border->is_not_periodic();
}

std::string border_notice(const ReportSeries& series)
{
    if (!is_not_periodic(series)) return {};
    return border_words(*series.stored) + " " + border_advice(series.run->dimension);
}

std::optional<double> anisotropy_above_chance(const ReportSeries& series)
{
    const auto stored = value_of(series, "anisotropy_above_chance");
    return stored ? stored : above_chance_of_curve(series);
}

bool has_directions(const ReportSeries& series) { return anisotropy_above_chance(series).value_or(0) > 0; }

std::string sentence_about(const ReportSeries& series)
{
    if (follows_density(series))
        return "The points follow a density: their distances and their spectrum are those of the density as well, and "
               "say nothing of how even they are.";
    Opinion opinion;
    judge_distances(series, opinion);
    if (!is_not_periodic(series)) { // whose spectrum has the border in it
        judge_noise(series, opinion);
        judge_long_waves(series, opinion);
        judge_directions(series, opinion);
    }
    std::vector<std::string> parts;
    if (const auto& blue_noise = series.stored->blue_noise)
        parts.push_back(fmt::format("Blue noise: {}.", blue_noise->answer));
    if (is_not_periodic(series)) parts.push_back(border_words(*series.stored));
    if (!opinion.good.empty()) parts.push_back(fmt::format("Strengths: {}.", fmt::join(opinion.good, "; ")));
    if (!opinion.bad.empty()) parts.push_back(fmt::format("Weaknesses: {}.", fmt::join(opinion.bad, "; ")));
    return fmt::format("{}", fmt::join(parts, " "));
}

}
