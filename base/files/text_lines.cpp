#include "base/files/text_lines.hpp"

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
    const std::size_t end = rest_.find(end_);
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (end_ == '\n' && line_.ends_with('\r')) line_.remove_suffix(1);
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

}
