// Numbers as readers want them: thousands separated, sensible digits, times with a unit.
//
// The value of a measure that a series has, in words.
#pragma once

#include "results/measures.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace poissonlab {

/// 16384 -> "16,384".
std::string format_count(std::uint64_t value);

/// A label with its numbers of points like that: "Random, N = 16384" -> "Random, N = 16,384"; and with the sign of the
/// relative radius, ρ, where it is spelt.
std::string with_formatted_points(const std::string& label);

/// Significant digits, zeros at the end included; very small and very large numbers as "2.3 × 10⁻⁵". Minus as
/// U+2212.
std::string format_significant(double value, int digits);

/// An estimate and its standard error as readers have them.
struct RoundedEstimate
{
    std::string value;
    std::string error; ///< empty: there is none, or nothing but rounding

    /// "0.721 ± 0.004", or the value alone.
    std::string text() const;
};

/// All numbers with an error are rounded here, by the rule of the Particle Data Group (Review of Particle Physics,
/// section 5.3): the error has two digits where they are up to 354, else one, where the first three of its digits are
/// meant, and the value ends at the same place. Small ones are powers of ten, and so is their error. An error below a
/// millionth of the value is as good as none; without an error the value has `digits` significant ones.
RoundedEstimate format_estimate(double value, std::optional<double> standard_error, int digits = 4);

/// A fixed number of decimals; never "-0". Minus as U+2212.
std::string format_fixed(double value, int decimals);

/// Three significant digits with the unit that suits: "812 µs", "12.3 ms", "35.0 s".
std::string format_seconds(double seconds);

/// The shortest decimal that reads back as the same double.
std::string format_exact(double value);

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
