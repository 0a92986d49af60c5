// Tables of points as programs write them: which fields of a line are coordinates.
//
// A first line of names (x, y and z, or longitude and latitude, in any case, quoted or not) says so; other columns are
// left out, with a word: an index or a number in front, classes, what else there is. R leaves out the name of the first
// column; pandas leaves it empty, and names the columns of an array 0, 1 and 2. Separators are commas, semicolons, tabs
// or blanks, as the first line has them (or Excel's line `sep=;`). Without names, all fields are coordinates, and
// blanks and commas may both separate. Where semicolons or tabs do, commas are decimal points.
#pragma once

#include "base/points/point_file_formats.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

class TextTable
{
public:
    explicit TextTable(const PointFileContent& file) : file_(file) {}

    /// Takes a line before the points; `rest` is the text after it. True if the line belongs to the table's head.
    /// Throws InputError for names without x and y.
    bool takes(std::string_view line, int number, std::string_view rest);

    /// The words of a point's coordinates, until the next line. Throws InputError.
    std::span<const std::string_view> coordinates(std::string_view line, int number);

    /// The class in the line whose coordinates were taken last, if classes are asked for.
    std::string_view class_name() const { return fields_[*class_column_ + has_row_names_]; }

    /// The number of the line that names the columns longitude and latitude; 0: none does.
    int degrees_line() const { return degrees_line_; }
    std::string names_in_words() const;

private:
    enum class Separator : char
    {
        unknown = 0,
        blank_or_comma = ' ',
        comma = ',',
        semicolon = ';',
        tab = '\t',
        blank = 'b',
    };

    void find_separator(std::string_view line);
    void split(std::string_view line, int number);
    bool are_names(int number, std::string_view rest) const;
    void take_names(int number);
    /// Decimal commas are read where no comma separates numbers.
    bool has_decimal_commas() const { return separator_ == Separator::semicolon || separator_ == Separator::tab; }
    void check_fields(std::string_view line, int number);
    void check_commas(std::string_view line, int number) const;
    void mend_decimals(int number);
    void find_class_by_number(std::string_view line, int number);

    const PointFileContent& file_;
    Separator separator_ = Separator::unknown;
    std::vector<std::string> names_;
    std::vector<std::size_t> columns_; ///< of the coordinates; empty: all
    std::optional<std::size_t> class_column_;
    bool has_row_names_ = false; ///< a column in front that has no name
    bool is_first_point_ = true;
    int degrees_line_ = 0;
    int comma_line_ = 0, point_line_ = 0; ///< the first numbers with decimal commas, and with points

    std::vector<std::string_view> fields_, words_;
    std::vector<std::string> unquoted_, mended_;
};

}
