// The value of a measure that a series has, in words.
#pragma once

#include "results/measures.hpp"

#include <optional>
#include <string>

namespace poissonlab {

struct MeasureWords
{
    std::string shown;  ///< rounded, without the unit; times with it
    std::string spread; ///< "± 0.01", of times and sizes "0.74 to 0.76", or a remark; empty: none
    std::string range;  ///< from the least set to the largest, where `spread` is the error of their mean
};

/// The standard error of a value: its own, or that of the mean over the sets; none where it is not known, and of times.
std::optional<double> standard_error_of(const Measure& measure, const MeasuredValue& value);

MeasureWords words_of(const Measure& measure, const MeasuredValue& value);

/// The unit that a series in a region or a box was given in, and how many of them are one length of the results;
/// nothing on the unit torus.
struct OwnUnit
{
    double lengths = 1;
    std::string name; ///< "m"
};
std::optional<OwnUnit> own_unit(const Series& series);

}
