#include "app/help_lines.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace poissonlab {
namespace {

constexpr std::string_view prompt = "  poissonlab ";
constexpr std::string_view continued = "      "; ///< before the further lines of a command
constexpr std::size_t full_line = 108;           ///< columns: a line with room for a word up to here ends a paragraph

std::size_t indent_of(const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// The column of what follows the first word of a list, after two blanks or more; 0: the line is no list's.
std::size_t second_column(const std::string& line)
{
    const std::size_t gap = line.find("  ", indent_of(line));
    const std::size_t column = gap == std::string::npos ? gap : line.find_first_not_of(' ', gap);
    return column == std::string::npos ? 0 : column;
}

/// The place of the last blank before an option that a line of so many columns may be broken at; npos: there is none.
std::size_t option_break(const std::string& line, std::size_t columns)
{
    bool is_quoted = false;
    std::size_t place = std::string::npos;
    for (std::size_t i = prompt.size(); i + 2 <= columns && i + 2 < line.size(); ++i) {
        if (line[i] == '"' || line[i] == '\'') is_quoted = !is_quoted;
        if (!is_quoted && line.compare(i, 3, " --") == 0) place = i;
    }
    return place;
}

class Columns
{
public:
    explicit Columns(std::size_t columns) : columns_(columns) {}

    void add(std::string line)
    {
        if (line.starts_with(prompt)) {
            flush();
            return add_command(std::move(line));
        }
        const std::size_t indent = indent_of(line), second = second_column(line);
        const std::size_t word = std::min(line.find(' ', indent), line.size()) - indent, written = written_;
        written_ = line.size();
        if (!rest_.empty() && second == 0 && word > 0 && indent == rest_indent_ && written + 1 + word > full_line)
            line = std::string(indent, ' ') + rest_ + " " + line.substr(indent);
        else
            flush();
        rest_.clear();
        const std::size_t hanging = second > 0 && second < columns_ / 2 ? second : indent;
        while (line.size() > columns_) {
            const std::size_t blank = place_of_break(line, hanging);
            if (blank == std::string::npos) break;
            lines_ += line.substr(0, line.find_last_not_of(' ', blank) + 1) + "\n";
            line = std::string(hanging, ' ') + line.substr(blank + 1);
            rest_indent_ = hanging;
            rest_ = "-";
        }
        if (rest_.empty())
            lines_ += line + "\n";
        else
            rest_ = line.substr(hanging);
    }

    std::string text()
    {
        flush();
        return lines_;
    }

private:
    /// The last blank before the end of a line, else the first one after it.
    std::size_t place_of_break(const std::string& line, std::size_t hanging) const
    {
        const std::size_t blank = line.rfind(' ', columns_);
        return blank != std::string::npos && blank > hanging ? blank : line.find(' ', columns_);
    }

    void add_command(std::string line)
    {
        while (line.size() > columns_) {
            const std::size_t place = option_break(line, columns_);
            if (place == std::string::npos) break;
            lines_ += line.substr(0, place) + " \\\n";
            line = std::string(continued) + line.substr(place + 1);
        }
        lines_ += line + "\n";
    }

    void flush()
    {
        if (!rest_.empty()) lines_ += std::string(rest_indent_, ' ') + rest_ + "\n";
        rest_.clear();
    }

    std::size_t columns_;
    std::string lines_;
    std::string rest_; ///< of a line that was too long, not yet written
    std::size_t rest_indent_ = 0;
    std::size_t written_ = 0; ///< the columns of the last line as it came
};

}

std::string within_columns(const std::string& text, std::size_t columns)
{
    Columns result(columns);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) result.add(std::move(line));
    std::string all = result.text();
    if (!text.ends_with('\n') && !all.empty()) all.pop_back();
    return all;
}

}
