#include "base/points/text_table.hpp"

#include "base/files/text_lines.hpp"
#include "base/text/csv_fields.hpp"
#include "base/text/decimal_commas.hpp"
#include "base/text/noun.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <utility>

namespace poissonlab {
namespace {

bool has(std::string_view text, char c) { return text.find(c) != text.npos; }

/// Returns true for a number with a decimal comma or a decimal point.
bool is_a_number(std::string_view word)
{
    double value = 0;
    std::string text(word);
    std::ranges::replace(text, ',', '.');
    return parse_number(text, value);
}

std::string in_small_letters(std::string_view text)
{
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small;
}

/// Letters, and no control characters, as binary files have them.
bool is_a_word(std::string_view text)
{
    const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0 || c > 127; };
    return std::ranges::any_of(text, is_letter) && std::ranges::none_of(text, [](unsigned char c) { return c < ' '; });
}

/// The line without what is quoted.
std::string without_quoted(std::string_view line)
{
    std::string rest;
    bool is_quoted = false;
    for (const char c : line) {
        if (c == '"') is_quoted = !is_quoted;
        if (!is_quoted) rest += c;
    }
    return rest;
}

/// The line without blanks around its separators, in front of which quotes begin.
std::string without_blanks(std::string_view line, char separator)
{
    std::string tight;
    bool is_quoted = false;
    for (const char c : line) {
        const bool is_blank = !is_quoted && c != separator && (c == ' ' || c == '\t');
        if (is_blank && (tight.empty() || tight.back() == separator)) continue;
        if (c == '"') is_quoted = !is_quoted;
        if (!is_quoted && c == separator)
            while (tight.ends_with(' ') || (separator != '\t' && tight.ends_with('\t'))) tight.pop_back();
        tight += c;
    }
    return tight;
}

/// The axis that a column of this name holds.
std::optional<std::size_t> axis_of(const std::string& name)
{
    constexpr std::string_view axes = "xyz";
    const std::string small = in_small_letters(name);
    const std::size_t axis = small.size() == 1 ? axes.find(small) : axes.npos;
    return axis == axes.npos ? std::nullopt : std::optional(axis);
}

/// The axis of a column of places on the globe.
std::optional<std::size_t> globe_axis_of(const std::string& name)
{
    const std::string small = in_small_letters(name);
    if (small == "longitude" || small == "lon" || small == "lng") return 0;
    if (small == "latitude" || small == "lat") return 1;
    return std::nullopt;
}

bool are_of_globe(const std::vector<std::string>& names)
{
    return std::ranges::none_of(names, [](const std::string& name) { return axis_of(name).has_value(); }) &&
           std::ranges::any_of(names, [](const std::string& name) { return globe_axis_of(name).has_value(); });
}

/// Are these the names that pandas gives to the columns of an array, behind its index or without one?
bool are_counted(std::vector<std::string> names)
{
    static const std::vector<std::string> plane{"0", "1"}, space{"0", "1", "2"};
    if (names.front().empty()) names.erase(names.begin());
    return names == plane || names == space;
}

}

bool TextTable::takes(std::string_view line, int number, std::string_view rest)
{
    if (separator_ == Separator::unknown && line.size() == 5 && in_small_letters(line).starts_with("sep=") &&
        has(",;\t", line[4])) {
        separator_ = Separator(line[4]);
        return true;
    }
    if (!names_.empty()) return false;
    find_separator(line);
    split(line, number);
    if (!are_names(number, rest)) {
        if (separator_ == Separator::comma || separator_ == Separator::blank) separator_ = Separator::blank_or_comma;
        return false;
    }
    take_names(number);
    return true;
}

/// Finds the separator of a line of names or of numbers. Commas within numbers that tabs separate are decimal points.
void TextTable::find_separator(std::string_view line)
{
    if (separator_ != Separator::unknown) return;
    const std::string rest = without_quoted(line);
    const bool has_words = has(line, '"') || std::ranges::any_of(rest, [](unsigned char c) {
                               return std::isalpha(c) != 0 && c != 'e' && c != 'E';
                           });
    if (has(rest, ';')) {
        separator_ = Separator::semicolon;
    } else if (has(rest, '\t') && (has_words || !decimal_comma_in(rest).empty())) {
        separator_ = Separator::tab;
    } else if (has(rest, ',')) {
        separator_ = Separator::comma;
    } else {
        separator_ = Separator::blank;
    }
}

/// Takes a line apart into fields.
void TextTable::split(std::string_view line, int number)
{
    fields_.clear();
    const bool has_blanks = separator_ == Separator::blank || separator_ == Separator::blank_or_comma;
    const char mark = separator_ == Separator::blank ? ' ' : static_cast<char>(separator_);
    if (has(line, '"')) {
        const bool has_commas = separator_ == Separator::blank_or_comma && has(without_quoted(line), ',');
        const char separator = has_commas ? ',' : mark;
        auto unquoted = csv_fields(without_blanks(line, separator), separator);
        if (!unquoted)
            fail_in_point_file(file_, number, line, "a quote stays open, or text goes on behind a closing one");
        unquoted_ = std::move(*unquoted);
        for (const std::string& field : unquoted_) fields_.push_back(trimmed(field));
    } else if (has_blanks) {
        for (WordReader words(line); words.next();) fields_.push_back(words.word());
    } else {
        for (std::string_view rest = line;; rest.remove_prefix(rest.find(mark) + 1)) {
            fields_.push_back(trimmed(rest.substr(0, rest.find(mark))));
            if (!has(rest, mark)) break;
        }
    }
}

/// Without pandas' index, the names of columns are numbers. They count as names only if the next line has fractions.
bool TextTable::are_names(int number, std::string_view rest) const
{
    const std::vector<std::string> names(fields_.begin(), fields_.end());
    if (are_counted(names)) {
        LineReader next(rest);
        return names.front().empty() ||
               (number == 1 && separator_ == Separator::comma && next.next() && has(next.line(), '.'));
    }
    const auto is_axis = [](const std::string& name) { return axis_of(name) || globe_axis_of(name); };
    return std::ranges::none_of(names, is_a_number) && std::ranges::any_of(names, is_a_word) &&
           (separator_ != Separator::blank || std::ranges::any_of(names, is_axis));
}

void TextTable::take_names(int number)
{
    names_.assign(fields_.begin(), fields_.end());
    std::array<std::optional<std::size_t>, 3> found;
    std::vector<std::string> others;
    const bool of_globe = are_of_globe(names_), is_counted = are_counted(names_);
    const std::size_t count = names_.size() - names_.front().empty();
    if (is_counted && count == names_.size())
        file_.tell("the first line is read as the column numbers that pandas writes, not as a point");
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const auto axis = is_counted && !names_[i].empty() ? std::optional(i - (names_.size() - count))
                          : of_globe                       ? globe_axis_of(names_[i])
                                                           : axis_of(names_[i]);
        if (!axis && file_.has_classes() && names_[i] == file_.classes.column) {
            if (class_column_) fail_in_point_file(file_, number, names_[i], "two columns have this name");
            class_column_ = i;
        } else if (!axis) {
            others.push_back(names_[i].empty() ? "one without a name" : names_[i]);
        } else if (found[*axis]) {
            fail_in_point_file(file_, number, names_[i], "two columns have this name");
        } else {
            found[*axis] = i;
        }
    }
    if (!found[0] || !found[1])
        fail_in_point_file(file_, number, names_in_words(),
                           "is no point, nor names of columns: among these must be x and y, of points in space z, or "
                           "longitude and latitude");
    if (file_.has_classes() && !class_column_)
        fail_in_point_file(file_, number, file_.classes.column,
                           fmt::format("is not a column with classes; columns other than coordinates: {}",
                                       others.empty() ? "none" : fmt::format("{}", fmt::join(others, ", "))));
    if (of_globe) degrees_line_ = number;
    for (const auto& column : found)
        if (column) columns_.push_back(*column);
    if (!others.empty() && !file_.has_classes())
        file_.tell(fmt::format("only the columns {} are read; left out: {}",
                               of_globe   ? "longitude and latitude"
                               : found[2] ? "x, y and z"
                                          : "x and y",
                               fmt::join(others, ", ")));
}

std::string TextTable::names_in_words() const
{
    return shortened(printable(fmt::format("{}", fmt::join(names_, ", "))), 100);
}

std::span<const std::string_view> TextTable::coordinates(std::string_view line, int number)
{
    if (!has_decimal_commas() && columns_.size() == names_.size()) check_commas(line, number);
    split(line, number);
    if (!names_.empty()) check_fields(line, number);
    if (file_.has_classes()) find_class_by_number(line, number);
    words_.clear();
    for (const std::size_t column : columns_) words_.push_back(fields_[column + has_row_names_]);
    if (columns_.empty()) words_.assign(fields_.begin(), fields_.end());
    if (columns_.empty() && class_column_) words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(*class_column_));
    if (has_decimal_commas() || !columns_.empty())
        if (const auto empty = std::ranges::find(words_, ""); empty != words_.end())
            fail_in_point_file(file_, number, "nothing between separators",
                               columns_.empty()
                                   ? "must be a number"
                                   : fmt::format("column {} must be a number",
                                                 names_[columns_[static_cast<std::size_t>(empty - words_.begin())]]));
    if (has_decimal_commas()) mend_decimals(number);
    return words_;
}

/// In a table without names, the column is given by its number.
void TextTable::find_class_by_number(std::string_view line, int number)
{
    if (!names_.empty()) return;
    std::size_t column = 0;
    const std::string& typed = file_.classes.column;
    const auto [end, error] = std::from_chars(typed.data(), typed.data() + typed.size(), column);
    if (error != std::errc() || end != typed.data() + typed.size() || column == 0)
        fail_in_point_file(
            file_, number, line,
            fmt::format("the first line has no names of columns, so that the column with classes must be "
                        "given by its number, from 1 on; {} is not such a number",
                        typed));
    if (column > fields_.size())
        fail_in_point_file(file_, number, line, fmt::format("has no column {}, which should have the classes", column));
    class_column_ = column - 1;
}

/// R writes names of rows in a first column, which has no name itself.
void TextTable::check_fields(std::string_view line, int number)
{
    const bool is_numbered = separator_ != Separator::comma && // which may be a decimal one
                             !fields_.back().empty() &&        // as a separator at the end leaves it
                             fields_.front().find_first_not_of("0123456789") == std::string_view::npos;
    if (std::exchange(is_first_point_, false) && fields_.size() == names_.size() + 1 &&
        (line.starts_with('"') || is_numbered || !is_a_number(fields_.front()))) {
        has_row_names_ = true;
        if (columns_.size() == names_.size()) file_.tell("the names of rows, in front, are left out");
    }
    const std::size_t needed = names_.size() + has_row_names_;
    if (fields_.size() == needed) return;
    const std::string hint = has_decimal_commas() ? "" : decimal_comma_words(line);
    fail_in_point_file(
        file_, number, fmt::format("{} {}", fields_.size(), noun(fields_.size(), "field")),
        fmt::format("must be {}, as the names of the columns say ({}){}", needed, names_in_words(), hint));
}

/// Throws where commas stand within numbers, as many languages write decimals: "12,5 7" is no point in space.
void TextTable::check_commas(std::string_view line, int number) const
{
    const std::string_view found = decimal_comma_in(line);
    if (found.empty()) return;
    const bool has_other_separators = std::ranges::any_of(line, [&](const char& c) {
        const bool is_beside_comma = (&c > line.data() && *(&c - 1) == ',') || (&c < &line.back() && *(&c + 1) == ',');
        return c == ';' || ((c == ' ' || c == '\t') && !is_beside_comma);
    });
    if (has_other_separators)
        fail_in_point_file(file_, number, line, "commas separate numbers" + decimal_comma_words(line));
}

/// Decimal commas become points. A file has one of the two.
void TextTable::mend_decimals(int number)
{
    mended_.clear();
    mended_.reserve(words_.size());
    for (std::string_view& word : words_) {
        const bool has_comma = has(word, ','), has_point = has(word, '.');
        if (has_comma && comma_line_ == 0) comma_line_ = number;
        if (has_point && point_line_ == 0) point_line_ = number;
        if ((has_comma && point_line_ > 0) || (has_point && comma_line_ > 0))
            fail_in_point_file(file_, number, word,
                               fmt::format("numbers have decimal commas (line {}) and points (line {}): must be one of "
                                           "them",
                                           comma_line_, point_line_));
        if (!has_comma) continue;
        mended_.emplace_back(word);
        std::ranges::replace(mended_.back(), ',', '.');
        word = mended_.back();
    }
}

}
