#include "base/files/number_table.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace poissonlab {

namespace {

/// A number for each of `values`; false when the line holds anything else.
bool parse_line(const std::string& line, std::vector<double>& values)
{
    const char* position = line.data();
    const char* const end = line.data() + line.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0 && (position == end || *position++ != ',')) return false;
        const auto [next, error] = std::from_chars(position, end, values[i]);
        if (error != std::errc{}) return false;
        position = next;
    }
    return position == end && std::isfinite(values[0]) && std::isfinite(values[1]);
}

}

std::vector<std::vector<double>> read_number_table(const std::filesystem::path& path, const std::string& header,
                                                   const std::string& what)
{
    std::istringstream text(read_whole_file(path));
    std::string line;
    if (!std::getline(text, line) || line != header)
        throw InputError::at({path.string(), 1}, "must be the header " + header);

    std::vector<std::vector<double>> rows;
    std::vector<double> values(static_cast<std::size_t>(std::ranges::count(header, ',')) + 1);
    for (int number = 2; std::getline(text, line); ++number) {
        if (!parse_line(line, values))
            throw InputError::at({path.string(), number}, "must be " + std::to_string(values.size()) +
                                                              " numbers, not '" + shortened(line) + "'");
        rows.push_back(values);
    }
    if (rows.empty()) throw InputError::at({path.string()}, "holds no " + what);
    return rows;
}

std::size_t table_count(double number, const std::filesystem::path& path, std::size_t row, const std::string& column)
{
    if (!(number >= 0 && number <= 0x1p53 && number == std::floor(number)))
        throw InputError(fmt::format("{}:{}: {} = {}: must be a whole number of at least 0", path.string(), row + 2,
                                     column, number));
    return static_cast<std::size_t>(number);
}

}
