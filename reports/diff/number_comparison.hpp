// One number of two runs: the same, other but within its error, or changed.
#pragma once

#include "analysis/statistics/welch.hpp"
#include "results/measures.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

enum class Verdict
{
    identical,      ///< the same double
    within_error,   ///< another one, as chance (or rounding) makes it
    changed,        ///< beyond error; or any difference, where there is no chance
    not_judged,     ///< no error is known that would tell
    not_comparable, ///< measured under other conditions
};

/// One number of a series, in both runs.
struct NumberComparison
{
    std::string quantity; ///< "relative radius"
    std::string unit;     ///< empty: none
    Better better = Better::neither;
    std::optional<SampleMean> before; ///< empty: not stored there
    std::optional<SampleMean> after;
    Verdict verdict = Verdict::not_judged;
    std::string note;        ///< the place on a curve, or why there is no verdict
    std::optional<double> p; ///< of the test, where there was one; settled by settle_verdicts()
    std::optional<double> adjusted_p;

    /// True for a change to a better value; empty if neither is better.
    std::optional<bool> improved() const;
};

/// The settings that two series have in common, which decide what a difference means.
struct ComparisonTerms
{
    bool same_seed = false;     ///< and the same engine: the same bytes are promised
    bool deterministic = false; ///< nothing in them is chance
    bool one_tile_set = false;  ///< realizations share a tile set, so their spread is not that between tile sets
};

/// Says why a quantity that a tile set decides is not judged between seeds.
inline constexpr auto tile_set_note = "of another tile set, whose spread is not known";

/// Relative differences below this are the last bits of another processor.
inline constexpr double rounding = 1e-10;

/// The probability that any of a comparison's tests calls chance a change.
inline constexpr double comparison_level = 0.01;

/// Two means with standard errors over realizations; an error of 0 with several samples: there is none.
///
/// Sets verdict, note and p. Where p is set, within_error or changed is for settle_verdicts() to say.
void judge(NumberComparison& number, const ComparisonTerms& terms);

/// Judges two means by the values of all realizations.
void judge(NumberComparison& number, std::span<const double> before, std::span<const double> after,
           const ComparisonTerms& terms);

/// A point of a curve.
struct CurvePoint
{
    double place = 0; ///< on the horizontal axis
    SampleMean mean;
};

/// Two curves, point by point: the number becomes that at the place of the largest |t|, and p is corrected for all
/// places (Bonferroni). `place_name` is for the note: "frequency".
void judge(NumberComparison& number, std::span<const CurvePoint> before, std::span<const CurvePoint> after,
           const std::string& place_name, const ComparisonTerms& terms);

/// Two lists of times under equal conditions. Changed: the medians differ by more than half of the smaller one, and no
/// time of one run lies among those of the other. That is a rule of thumb: what else a machine does is in no spread.
void judge_times(NumberComparison& number, std::span<const double> before, std::span<const double> after);

/// Corrects the p-values of all numbers together (Holm) and says which are changes at comparison_level.
void settle_verdicts(const std::vector<NumberComparison*>& numbers);

}
