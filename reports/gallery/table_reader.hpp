// The lines of a stored table, one after the other.
#pragma once

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/text/csv_fields.hpp"
#include "results/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

// The tables of docs/gallery/, embedded at build time.

/// The text of a table, such as "curves.csv"; empty for unknown names.
std::string_view gallery_file(std::string_view name);

/// Goes through the lines of a table below its header. Throws InputError with table and line.
class TableReader
{
public:
    TableReader(std::string_view text, std::string_view file, std::string_view header)
        : file_(file), columns_(static_cast<std::size_t>(std::ranges::count(header, ',')) + 1), lines_(text)
    {
        if (!lines_.next() || lines_.line() != header) throw error("must be the header " + std::string(header));
    }

    bool next()
    {
        if (!lines_.next()) return false;
        auto fields = csv_fields(lines_.line());
        if (!fields) throw error("must close its quotes, with a comma behind");
        if (fields->size() != columns_) throw error(fmt::format("must have {} columns", columns_));
        fields_ = std::move(*fields);
        return true;
    }

    const std::string& text(std::size_t column) const { return fields_[column]; }

    double number(std::size_t column) const
    {
        double value = 0;
        if (!parse_number(fields_[column], value)) throw error(fmt::format("\"{}\" must be a number", fields_[column]));
        return value;
    }

    /// The error's column is empty where none is known.
    Estimate estimate(std::size_t column, std::size_t error_column) const
    {
        Estimate estimate{number(column), {}};
        if (!fields_[error_column].empty()) estimate.standard_error = number(error_column);
        return estimate;
    }

    InputError error(const std::string& why) const { return InputError::at({file_, lines_.number()}, why); }

private:
    std::string file_;
    std::size_t columns_;
    LineReader lines_;
    std::vector<std::string> fields_;
};

}
