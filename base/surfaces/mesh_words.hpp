// The words of a mesh in text, whichever program and system wrote it.
#pragma once

#include "base/files/text_lines.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace poissonlab {

/// Goes through lines and their words, which blanks and tabs separate. Lines end in LF, CRLF or CR; a byte order mark
/// is skipped. Throws InputError `file:line: problem`.
class MeshWords
{
public:
    enum class Lines
    {
        plain,
        commented, ///< what follows a # is left out
        continued  ///< commented, and a line that ends in \ goes on in the next one
    };

    /// The first line of `text`, which must live as long, has the number `line_before` + 1.
    MeshWords(const std::string& file, std::string_view text, Lines lines, int line_before = 0);
    MeshWords(const MeshWords&) = delete;
    MeshWords& operator=(const MeshWords&) = delete;

    /// Moves to the next line; false where there is none.
    bool next_line();
    /// Moves to the next word of the line; false where there is none.
    bool next();
    /// Moves to the next word, of this line or a later one; false where there is none.
    bool next_anywhere();
    /// Moves to the next line that has words, before its first one; false where there is none.
    bool next_filled_line();

    std::string_view word() const { return word_; }
    /// The next line that has words, without moving there; empty where there is none.
    std::string_view line_ahead() const;
    /// The bytes of the text after this line.
    std::size_t bytes_left() const { return lines_.rest().size(); }
    int line() const { return lines_.number(); }

    /// The word as a finite number; a `name` is what it would be, with its article.
    double number(std::string_view name) const;
    /// A word as a whole number.
    std::int64_t whole_number(std::string_view word, std::string_view name) const;

    [[noreturn]] void fail(const std::string& problem) const;

private:
    static std::string_view text_of_mesh(const std::string& file, std::string_view text, std::string& changed);
    std::string_view without_comment(std::string_view line) const;

    const std::string file_;
    const Lines kind_;
    std::string changed_; ///< the text, where its lines had other ends
    LineReader lines_;
    std::string joined_; ///< a line that went on
    std::string_view rest_, word_;
};

}
