// The catalogue of measures: what results.json, the ranking, the pages of series, diff and docs/output-folder.md say of
// each follows from its row in measures.cpp.
#pragma once

#include "results/series.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Which way a quantity is better.
enum class Better
{
    higher,
    lower,
    neither,
};

/// The sets that a value stands for, which says how large its error is.
enum class MeasureKind
{
    setting,  ///< what was asked for
    size,     ///< of the sets, exact
    per_set,  ///< one value a realization: the error is their spread
    estimate, ///< one value of all realizations, with a standard error where one is known
    first,    ///< of the first realization only: no error is known
    time,     ///< compares on one machine only
};

/// The rounding of a value for readers.
struct Digits
{
    enum class Form
    {
        significant,
        decimals,
        count,   ///< whole, with separators
        seconds, ///< with the unit that fits
    };
    Form form = Form::significant;
    int digits = 3;
};

/// The value of a measure that a series has.
struct MeasuredValue
{
    double value = 0;
    std::optional<double> standard_error = {}; ///< over the realizations
    std::vector<double> each = {};             ///< of every realization (times: of every run), where they are known
    std::optional<std::array<double, 2>> range = {}; ///< from the smallest to the largest of these
    std::string remark = {};                         ///< a word beside the value
};

/// A text of a measure in the words of a dimension: of "{disks|balls}" the first in 2D, the second in 3D, and
/// "disks (3D: balls)" where both are meant.
std::string in_dimension(const std::string& text, int dimension = 0);

/// Texts may have words for either dimension, see in_dimension().
struct Measure
{
    std::string key;
    std::string name;   ///< "relative radius": as in a sentence
    std::string symbol; ///< "ρ"; empty: none
    std::string unit;   ///< as it follows a value; empty: a pure number
    Better better = Better::neither;
    MeasureKind kind = MeasureKind::estimate;
    Digits digits;
    std::string meaning; ///< a sentence or two for readers; empty: none is needed
    std::function<std::optional<MeasuredValue>(const Series&)> get;
    bool is_number = false; ///< one of Measures::numbers
    bool is_detail = false; ///< the ranking shows it when all measures are asked for

    /// "Relative radius ρ"
    std::string title() const;
};

/// All measures, in the order in which they are shown.
const std::vector<Measure>& measures();

/// The measure of that key. Throws std::out_of_range for others.
const Measure& measure(const std::string& key);

/// Returns true if the power at low frequencies follows a power law with this exponent. It returns false in a region,
/// whose boundary decides that power, and if the power rises towards frequency 0 by more than three standard errors:
/// such long waves are left over from a random start, and follow no power law.
bool is_power_law(const Series& series, double exponent, double standard_error);

/// The rows of the table of docs/output-folder.md, in Markdown.
std::string measures_table();

}
