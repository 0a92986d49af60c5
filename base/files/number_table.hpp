// Stored tables: a header with the names of the columns, then a line of numbers a row.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Reads the rows below `header`, as many numbers as that has columns. The first two columns must be finite, others may
/// be inf or nan. Throws InputError with file and line; `what` is what a table without rows lacks.
std::vector<std::vector<double>> read_number_table(const std::filesystem::path& path, const std::string& header,
                                                   const std::string& what);

/// A number of that table that counts something. `row` is counted from 0, `column` is its name. Throws InputError for
/// what is no whole number from 0 to 2^53.
std::size_t table_count(double number, const std::filesystem::path& path, std::size_t row, const std::string& column);

}
