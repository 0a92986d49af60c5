// The order of the ranking, its best values, and which series is best for what.
#pragma once

#include "reports/layout/report_layout.hpp"
#include "results/measures.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// A column of the ranking that methods are chosen by, in fewer words than the measure's own.
struct ChoiceColumn
{
    const char* key;
    const char* heading;
    const char* unit; ///< with the words of a dimension, as measures have them
};

/// The column of a measure; null for those that the ranking shows when all measures are asked for.
const ChoiceColumn* choice_column(const std::string& key);

/// True for series that are compared with others: not those that follow a density, nor sets that are not periodic.
bool is_ranked(const ReportSeries& series);

/// The series by their relative radius, the largest first, and those that are not ranked behind them.
std::vector<const ReportSeries*> ranking_order(std::vector<const ReportSeries*> series);

/// The series with the best value of a measure, of all ranked ones of a dimension; null where all are as good, and
/// where values do not compare: times do between sets of one size that were made on one machine.
const ReportSeries* best_to_mark(const Measure& measure, const std::vector<const ReportSeries*>& all, int dimension);

/// True where a series' value is no further from the best one than two standard errors, or shown with the same digits.
bool is_as_good(const Measure& measure, const ReportSeries& series, const ReportSeries& best);
bool is_as_good(const Measure& measure, const MeasuredValue& value, const MeasuredValue& best);

/// Something that sets are wanted for, and the series that is best for it.
struct BestFor
{
    std::string what;
    const ReportSeries* series = nullptr;
    std::string value; ///< "ρ = 0.925"
};

/// The series that are best for what, of those of a dimension. Lattices are best at nearly everything but that they are
/// lattices: where there are series without directions, the best is one of these.
std::vector<BestFor> best_series(const std::vector<const ReportSeries*>& all, int dimension);

/// "Blue noise? Yes: dart-throwing. Weakly: jittered. No: random."; empty where no series has an answer.
std::string blue_noise_words(const std::vector<const ReportSeries*>& all, int dimension);

/// "None of them has preferred directions.", "Left out here for their preferred directions: A; B.": of the ranked
/// series of a dimension.
std::string directions_words(const std::vector<const ReportSeries*>& all, int dimension);

/// "Of all series, the best would be A for points far apart.": those with preferred directions that would be best if
/// they were not left out; empty where there is none.
std::string hidden_best_words(const std::vector<const ReportSeries*>& all, int dimension);

}
