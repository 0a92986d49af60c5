// Names of classes in files of points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// A file has at most this many classes.
inline constexpr std::size_t most_measured_classes = 64;

/// A number for each point, and the names of the classes: numbers in rising order, then words in alphabetical order.
using ClassNumbers = std::pair<std::vector<std::uint8_t>, std::vector<std::string>>;

/// Numbers the classes of points by their names. Throws InputError for a point without one, for names that cannot be
/// printed, for fewer than two and for more than most_measured_classes; `file` is for the message.
ClassNumbers number_classes(const std::vector<std::string>& class_of_point, const std::string& file);

}
