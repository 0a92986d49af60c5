// A comparison of two results in words: for terminals and for programs.
#pragma once

#include "reports/diff/run_comparison.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// "better", "worse", "changed", "within error", "identical", "no verdict", "not comparable".
std::string verdict_words(const NumberComparison& number);

/// "0.7001 ± 0.0002", or "none" where it is not stored. Both values have digits enough to tell them apart.
struct NumberTexts
{
    std::string before;
    std::string after;
};
NumberTexts number_texts(const NumberComparison& number);

/// The reason of the verdict: "t = −5.2, p = 0.0003; at frequency 12".
std::string reason_words(const NumberComparison& number);

/// "2 of 57 numbers changed, 1 series is missing": what the comparison comes to.
std::string comparison_summary(const RunComparison& comparison);

/// One line of a comparison.
struct ComparedLine
{
    const SeriesComparison* series = nullptr;
    const NumberComparison* number = nullptr;
};

/// Changes, worse ones first; with `all` also the numbers without verdict, those within error, and identical ones.
std::vector<ComparedLine> sorted_lines(const RunComparison& comparison, bool all);

/// Lines of text in columns.
std::string comparison_table(const RunComparison& comparison, bool all);

/// docs/output-folder.md, "diff".
std::string comparison_json(const RunComparison& comparison);

}
