#include "base/files/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

namespace poissonlab {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

void skip_blanks(std::string_view& text)
{
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
}

}

bool LineReader::next()
{
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    ++number_;
    return true;
}

bool WordReader::next()
{
    skip_blanks(rest_);
    if (rest_.empty()) return false;
    if (!first_ && rest_.front() == ',') {
        rest_.remove_prefix(1);
        skip_blanks(rest_);
    }
    first_ = false;
    std::size_t length = 0;
    while (length < rest_.size() && !is_blank(rest_[length]) && rest_[length] != ',') ++length;
    word_ = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return true;
}

std::string_view trimmed(std::string_view text)
{
    skip_blanks(text);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

bool parse_number(std::string_view word, double& value)
{
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end) return false;
    if (error == std::errc::result_out_of_range) {
        value = 0;
        return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    }
    return error == std::errc();
}

std::string_view decimal_comma_in(std::string_view text)
{
    const auto is_digit = [&](std::size_t at) {
        return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
    };
    const auto goes_on = [&](std::size_t at) { // as a number with a point, or as a name
        return at < text.size() &&
               (std::isalpha(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.' || text[at] == '_');
    };
    for (std::size_t comma = text.find(','); comma != text.npos; comma = text.find(',', comma + 1)) {
        std::size_t begin = comma, end = comma + 1;
        while (begin > 0 && is_digit(begin - 1)) --begin;
        while (is_digit(end)) ++end;
        const bool is_number = begin < comma && end > comma + 1;
        if (is_number && !goes_on(end) && (begin == 0 || !goes_on(begin - 1))) return text.substr(begin, end - begin);
    }
    return {};
}

bool mixes_separators(std::string_view text, std::size_t count, std::size_t group)
{
    bool has_comma = false, has_blank = false;
    WordReader words(text);
    for (std::size_t i = 0; i < count && words.next(); ++i) {
        const auto end = static_cast<std::size_t>(words.word().data() - text.data()) + words.word().size();
        const bool is_comma = trimmed(text.substr(end)).starts_with(',');
        const bool is_between_groups = (i + 1) % group == 0;
        has_comma |= is_comma && (!is_between_groups || i + 1 == count);
        has_blank |= !is_comma && !is_between_groups;
    }
    return has_comma && has_blank;
}

std::string decimal_comma_words(std::string_view text)
{
    const std::string_view found = decimal_comma_in(text);
    if (found.empty()) return {};
    std::string number(found);
    std::ranges::replace(number, ',', '.');
    return fmt::format("; the comma of \"{}\" is no decimal point: must be {}", found, number);
}

}
