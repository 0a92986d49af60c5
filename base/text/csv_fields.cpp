#include "base/text/csv_fields.hpp"

namespace poissonlab {
namespace {

/// Takes the field in quotes off the beginning of a line. Nothing where they stay open.
std::optional<std::string> take_quoted_field(std::string_view& line)
{
    std::string text;
    for (std::size_t at = 1; at < line.size(); ++at) {
        const bool is_quote = line[at] == '"';
        if (is_quote && !line.substr(at + 1).starts_with('"')) {
            line.remove_prefix(at + 1);
            return text;
        }
        text += line[at];
        if (is_quote) ++at;
    }
    return std::nullopt;
}

std::string take_plain_field(std::string_view& line, char separator)
{
    const std::string_view text = line.substr(0, line.find(separator));
    line.remove_prefix(text.size());
    return std::string(text);
}

}

std::string csv_quoted(std::string_view text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return quoted + "\"";
}

std::optional<std::vector<std::string>> csv_fields(std::string_view line, char separator)
{
    std::vector<std::string> fields;
    while (true) {
        auto field = line.starts_with('"') ? take_quoted_field(line) : take_plain_field(line, separator);
        if (!field) return std::nullopt;
        fields.push_back(std::move(*field));
        if (line.empty()) return fields;
        if (line.front() != separator) return std::nullopt;
        line.remove_prefix(1);
    }
}

}
