#include "reports/diff/number_comparison.hpp"

#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

constexpr auto exact_note = "same seed: any difference is a change";
constexpr auto deterministic_note = "not random: any difference is a change";
constexpr auto single_note = "of one realization: no error is known";
constexpr auto no_error_note = "no error is stored";

bool nearly_equal(double a, double b, double scale) { return std::abs(a - b) <= rounding * scale; }

/// Judges numbers whose errors are both 0: nothing but rounding may differ.
void judge_exactly(NumberComparison& number, double scale, const char* note)
{
    const bool same = nearly_equal(number.before->value, number.after->value, scale);
    number.verdict = same ? Verdict::within_error : Verdict::changed;
    number.note = same ? "rounding" : note;
}

/// The reason why the spread over realizations does not tell; empty: it does.
std::string obstacle(const SampleMean& before, const SampleMean& after, const ComparisonTerms& terms)
{
    if (before.samples < 2 || after.samples < 2) return single_note;
    if (terms.one_tile_set && !terms.same_seed) return tile_set_note;
    return {};
}

}

std::optional<bool> NumberComparison::improved() const
{
    if (better == Better::neither || !before || !after) return std::nullopt;
    return (after->value > before->value) == (better == Better::higher);
}

void judge(NumberComparison& number, const ComparisonTerms& terms)
{
    const auto& before = *number.before;
    const auto& after = *number.after;
    if (before.value == after.value && before.standard_error == after.standard_error) {
        number.verdict = Verdict::identical;
        return;
    }
    const double scale = std::max(std::abs(before.value), std::abs(after.value));
    if (terms.deterministic) return judge_exactly(number, scale, deterministic_note);
    if (const auto reason = obstacle(before, after, terms); !reason.empty()) {
        if (terms.same_seed) return judge_exactly(number, scale, exact_note);
        number.note = reason;
        return;
    }
    if (before.standard_error == 0 && after.standard_error == 0) {
        if (nearly_equal(before.value, after.value, scale) || terms.same_seed)
            return judge_exactly(number, scale, exact_note);
        number.note = no_error_note;
        return;
    }
    number.p = welch_test(before, after).p_value;
}

void judge(NumberComparison& number, std::span<const double> before, std::span<const double> after,
           const ComparisonTerms& terms)
{
    number.before = sample_mean(before);
    number.after = sample_mean(after);
    if (std::ranges::equal(before, after)) {
        number.verdict = Verdict::identical;
        return;
    }
    judge(number, terms);
    // Equal means of other values are not the same numbers; realizations without any spread have told that there is
    // none.
    const bool no_spread = number.before->standard_error == 0 && number.after->standard_error == 0;
    if (number.verdict == Verdict::identical) number.verdict = Verdict::within_error;
    if (number.verdict == Verdict::not_judged && number.note == no_error_note && no_spread) {
        number.verdict = Verdict::changed;
        number.note = "equal in all realizations of each run";
    }
}

namespace {

//// The order in which points of a curve tell of a difference, the kind of its verdict first.
struct Telling
{
    int kind = 0;
    double amount = 0;

    auto operator<=>(const Telling&) const = default;
};

Telling telling_of(const NumberComparison& point)
{
    const double distance = std::abs(point.after->value - point.before->value);
    if (point.p) return {3, -*point.p};
    switch (point.verdict) {
    case Verdict::identical:
        return {0, 0};
    case Verdict::within_error:
        return {1, distance};
    case Verdict::changed:
        return {4, distance};
    default:
        return {2, distance};
    }
}

/// `scale` is that of the curve: what is next to nothing beside its peak is rounding.
NumberComparison judged_point(NumberComparison point, const SampleMean& before, const SampleMean& after, double scale,
                              const ComparisonTerms& terms)
{
    point.before = before;
    point.after = after;
    judge(point, terms);
    if (point.verdict == Verdict::changed && nearly_equal(before.value, after.value, scale)) {
        point.verdict = Verdict::within_error;
        point.note = "rounding";
    }
    return point;
}

double largest_value(std::span<const CurvePoint> curve)
{
    double largest = 0;
    for (const auto& point : curve) largest = std::max(largest, std::abs(point.mean.value));
    return largest;
}

}

void judge(NumberComparison& number, std::span<const CurvePoint> before, std::span<const CurvePoint> after,
           const std::string& place_name, const ComparisonTerms& terms)
{
    if (!std::ranges::equal(before, after, {}, &CurvePoint::place, &CurvePoint::place)) {
        number.verdict = Verdict::not_comparable;
        number.note = "stored at other places";
        return;
    }
    const double scale = std::max(largest_value(before), largest_value(after));
    NumberComparison most;
    Telling most_telling{-1, 0};
    std::size_t place = 0, tests = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const auto point = judged_point(number, before[i].mean, after[i].mean, scale, terms);
        tests += point.p ? 1 : 0;
        if (const auto telling = telling_of(point); telling > most_telling) {
            most = point;
            most_telling = telling;
            place = i;
        }
    }
    if (most.p) most.p = std::min(1.0, *most.p * static_cast<double>(tests));
    if (most.verdict != Verdict::identical)
        most.note = fmt::format("at {} {}{}{}", place_name, format_significant(before[place].place, 4),
                                most.note.empty() ? "" : "; ", most.note);
    number = most;
}

void judge_times(NumberComparison& number, std::span<const double> before, std::span<const double> after)
{
    const auto middle = [](std::span<const double> times) {
        return SampleMean{median({times.begin(), times.end()}), 0, times.size()};
    };
    number.before = middle(before);
    number.after = middle(after);
    if (std::ranges::equal(before, after)) {
        number.verdict = Verdict::identical;
        return;
    }
    const auto [low, high] = std::ranges::minmax(before);
    const auto [next_low, next_high] = std::ranges::minmax(after);
    const bool apart = high < next_low || next_high < low;
    number.note = fmt::format("medians; {} to {}, then {} to {}", format_seconds(low), format_seconds(high),
                              format_seconds(next_low), format_seconds(next_high));
    const auto [small, large] = std::minmax(number.before->value, number.after->value);
    if (before.size() < 2 || after.size() < 2)
        number.note = "timed once";
    else
        number.verdict = apart && large > 1.5 * small ? Verdict::changed : Verdict::within_error;
}

void settle_verdicts(const std::vector<NumberComparison*>& numbers)
{
    std::vector<NumberComparison*> tested;
    std::vector<double> p_values;
    for (auto* number : numbers) {
        if (!number->p) continue;
        tested.push_back(number);
        p_values.push_back(*number->p);
    }
    const auto adjusted = holm_adjusted(p_values);
    for (std::size_t i = 0; i < tested.size(); ++i) {
        tested[i]->adjusted_p = adjusted[i];
        tested[i]->verdict = adjusted[i] < comparison_level ? Verdict::changed : Verdict::within_error;
    }
}

}
