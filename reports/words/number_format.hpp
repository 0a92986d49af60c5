// Numbers as readers want them: thousands separated, sensible digits, times with a unit.
#pragma once

#include <cstdint>
#include <string>

namespace poissonlab {

/// 16384 -> "16,384".
std::string format_count(std::uint64_t value);

/// A label with its numbers of points like that: "Random, N = 16384" -> "Random, N = 16,384".
std::string with_formatted_points(const std::string& label);

/// Significant digits, zeros at the end included; very small and very large numbers as "2.3 × 10⁻⁵". Minus as
/// U+2212.
std::string format_significant(double value, int digits);

/// A fixed number of decimals; never "-0". Minus as U+2212.
std::string format_fixed(double value, int decimals);

/// Three significant digits with the unit that suits: "812 µs", "12.3 ms", "35.0 s".
std::string format_seconds(double seconds);

/// The shortest decimal that reads back as the same double.
std::string format_exact(double value);

}
