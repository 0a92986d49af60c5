// Stored tables of four columns: a header, then a line of numbers a row.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

using NumberRow = std::array<double, 4>;

/// Reads the rows below `header`. The first two columns must be finite, others may be inf or nan. Throws
/// InputError with file and line; `what` is what a table without rows lacks.
std::vector<NumberRow> read_number_table(const std::filesystem::path& path, const std::string& header,
                                         const std::string& what);

}
