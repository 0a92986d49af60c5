// The value of a measure that a series has, in words.
#pragma once

#include "results/measures.hpp"

#include <string>

namespace poissonlab {

struct MeasureWords
{
    std::string shown;  ///< rounded, without the unit; times with it
    std::string spread; ///< "± 0.01", "0.74 to 0.76" or a remark; empty: none
};

MeasureWords words_of(const Measure& measure, const MeasuredValue& value);

}
