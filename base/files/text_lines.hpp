// Text taken apart into lines, words and numbers: the same in every locale, without copies.
#pragma once

#include <string_view>

namespace poissonlab {

/// Goes through a text line by line. Lines end in LF or CRLF, in CR where the text has no LF; the last one may lack its
/// end.
class LineReader
{
public:
    /// The first line of `text` has the number `line_before` + 1.
    explicit LineReader(std::string_view text, int line_before = 0)
        : rest_(text), number_(line_before), end_(text.find('\n') == text.npos ? '\r' : '\n')
    {}

    /// Moves to the next line; false when there is none.
    bool next();

    /// The line without its end.
    std::string_view line() const { return line_; }
    /// Counted from 1.
    int number() const { return number_; }
    /// The text after the line.
    std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
    std::string_view line_;
    int number_;
    char end_;
};

/// Goes through the words of a line, which blanks, tabs or a comma separate. A comma with nothing before or
/// after it makes an empty word, so that "0.1,,0.2" is noticed.
class WordReader
{
public:
    explicit WordReader(std::string_view line) : rest_(line) {}

    /// Moves to the next word; false when there is none.
    bool next();

    std::string_view word() const { return word_; }

private:
    std::string_view rest_;
    std::string_view word_;
    bool first_ = true;
};

/// `text` without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

/// Reads all of `word` as a decimal number (a leading + is allowed). False when it is none or overflows.
/// A number nearer to zero than every double becomes zero. "nan" and "inf" are numbers here.
bool parse_number(std::string_view word, double& value);

}
