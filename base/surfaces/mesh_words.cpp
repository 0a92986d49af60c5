#include "base/surfaces/mesh_words.hpp"

#include "base/errors/errors.hpp"
#include "base/text/decimal_commas.hpp"
#include "base/text/plain_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::string_view mesh_blanks = " \t\v\f";

/// Is there a CR that ends a line by itself?
bool has_lone_return(std::string_view text)
{
    for (std::size_t at = text.find('\r'); at != text.npos; at = text.find('\r', at + 1))
        if (at + 1 == text.size() || text[at + 1] != '\n') return true;
    return false;
}

}

MeshWords::MeshWords(const std::string& file, std::string_view text, Lines lines, int line_before)
    : file_(file), kind_(lines), lines_(text_of_mesh(file, text, changed_), line_before)
{}

std::string_view MeshWords::text_of_mesh(const std::string& file, std::string_view text, std::string& changed)
{
    text = plain_text(file, text);
    if (!has_lone_return(text)) return text;
    changed.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\r')
            changed += text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            changed += '\n';
    return changed;
}

std::string_view MeshWords::without_comment(std::string_view line) const
{
    return kind_ == Lines::plain ? line : line.substr(0, line.find('#'));
}

bool MeshWords::next_line()
{
    rest_ = word_ = {};
    if (!lines_.next()) return false;
    rest_ = without_comment(lines_.line());
    if (kind_ != Lines::continued || !rest_.ends_with('\\')) return true;
    joined_.clear();
    while (rest_.ends_with('\\')) {
        joined_ += rest_.substr(0, rest_.size() - 1);
        joined_ += ' ';
        rest_ = lines_.next() ? without_comment(lines_.line()) : std::string_view{};
    }
    joined_ += rest_;
    rest_ = joined_;
    return true;
}

bool MeshWords::next()
{
    const std::size_t begin = rest_.find_first_not_of(mesh_blanks);
    if (begin == rest_.npos) {
        rest_ = word_ = {};
        return false;
    }
    rest_.remove_prefix(begin);
    word_ = rest_.substr(0, rest_.find_first_of(mesh_blanks));
    rest_.remove_prefix(word_.size());
    return true;
}

bool MeshWords::next_anywhere()
{
    while (!next())
        if (!next_line()) return false;
    return true;
}

bool MeshWords::next_filled_line()
{
    while (next_line())
        if (rest_.find_first_not_of(mesh_blanks) != rest_.npos) return true;
    return false;
}

std::string_view MeshWords::line_ahead() const
{
    for (LineReader ahead = lines_; ahead.next();)
        if (const std::string_view line = without_comment(ahead.line());
            line.find_first_not_of(mesh_blanks) != line.npos)
            return line;
    return {};
}

double MeshWords::number(std::string_view name) const
{
    double value = 0;
    if (!parse_number(word_, value) || !std::isfinite(value))
        fail(fmt::format("\"{}\": {} must be a finite number{}", shortened(word_), name, decimal_comma_words(word_)));
    return value;
}

std::int64_t MeshWords::whole_number(std::string_view word, std::string_view name) const
{
    std::int64_t value = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || stop != end)
        fail(fmt::format("\"{}\": {} must be a whole number", shortened(word), name));
    return value;
}

void MeshWords::fail(const std::string& problem) const { throw InputError::at({file_, lines_.number()}, problem); }

}
