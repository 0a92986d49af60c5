#include "host/settings/toml_reader.hpp"

#include "base/files/text_lines.hpp"
#include "base/text/decimal_commas.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Turns toml++ nodes into a config tree; keeps the text to recover numbers as they were typed.
class TreeBuilder
{
public:
    TreeBuilder(std::string_view text, SourceLocation origin) : origin_(std::move(origin))
    {
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            lines_.push_back(text.substr(begin, end - begin));
            begin = end + 1;
        }
    }

    ConfigNode node(const toml::node& source) const
    {
        ConfigNode result{OtherValue{}, origin_, {}};
        // An argument has no lines.
        if (!origin_.is_argument) result.location.line = static_cast<int>(source.source().begin.line);
        source.visit([&](const auto& value) {
            if constexpr (toml::is_table<decltype(value)>)
                result.value = table(value);
            else if constexpr (toml::is_array<decltype(value)>)
                result.value = list(value);
            else if constexpr (!toml::is_chronological<decltype(value)>) // no key takes a date
                result.value = value.get();
        });
        if (const auto* text = result.get_if<std::string>()) result.text = '"' + *text + '"';
        if (result.text.empty()) result.text = typed_text(source.source().begin);
        return result;
    }

    ConfigTable table(const toml::table& source) const
    {
        std::vector<std::pair<toml::source_position, ConfigEntry>> entries;
        for (const auto& [key, value] : source)
            entries.push_back({key.source().begin, {std::string(key.str()), node(value)}});
        std::ranges::stable_sort(entries, [](const auto& a, const auto& b) { return a.first < b.first; });
        ConfigTable result;
        for (auto& entry : entries) result.push_back(std::move(entry.second));
        return result;
    }

private:
    ConfigList list(const toml::array& source) const
    {
        ConfigList result;
        for (const toml::node& item : source) result.push_back(node(item));
        return result;
    }

    /// The word that starts at a position, up to what ends a single value.
    std::string typed_text(const toml::source_position& begin) const
    {
        if (begin.line == 0 || begin.line > lines_.size()) return {};
        const std::string_view line = lines_[begin.line - 1];
        if (begin.line != last_.line || begin.column < last_.column) last_ = {begin.line};
        // Columns count characters, UTF-8 continuation bytes are none.
        while (last_.column < begin.column && last_.offset < line.size()) {
            ++last_.offset;
            while (last_.offset < line.size() && is_continuation(line[last_.offset])) ++last_.offset;
            ++last_.column;
        }
        const std::string_view rest = line.substr(last_.offset);
        return std::string(rest.substr(0, rest.find_first_of(",]}# \t\r\n")));
    }

    static bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

    /// The place of a column of a line, in bytes.
    struct Place
    {
        toml::source_index line = 0;
        toml::source_index column = 1;
        std::size_t offset = 0;
    };

    SourceLocation origin_;
    std::vector<std::string_view> lines_;
    mutable Place last_; ///< the next value is mostly further on in the same line, which may be very long
};

/// Words for a value that is a number with a decimal comma: `radius = 0,5`.
std::string comma_in_value(std::string_view text, int line)
{
    LineReader lines(text);
    while (lines.next() && lines.number() < line) {
    }
    const std::string_view value =
        trimmed(lines.line().substr(std::min(lines.line().size(), lines.line().find('=') + 1)));
    const std::string_view begin = value.substr(0, value.find_first_of(" \t#"));
    return decimal_comma_in(begin) == begin && !begin.empty() ? decimal_comma_words(begin) : "";
}

/// toml++ says "Error while parsing key-value pair: cannot redefine ...", with names of any length.
std::string description(const toml::parse_error& error)
{
    std::string text(error.description());
    std::ranges::replace(text, '\n', ' ');
    return shortened(text, 300);
}

}

ConfigTable read_toml(std::string_view text, const std::string& file)
{
    try {
        const toml::table document = toml::parse(text, file);
        return TreeBuilder(text, {file}).table(document);
    } catch (const toml::parse_error& error) {
        const auto line = static_cast<int>(error.source().begin.line);
        throw InputError::at({file, line}, description(error) + comma_in_value(text, line));
    }
}

ConfigNode read_toml_value(const std::string& text, const SourceLocation& origin)
{
    constexpr std::string_view key = "value = ";
    const std::string line = std::string(key) + text;
    try {
        const toml::table document = toml::parse(line);
        // A line break in the argument could smuggle in further keys.
        if (document.size() == 1 && document.contains("value"))
            return TreeBuilder(line, origin).table(document).front().node;
    } catch (const toml::parse_error& error) {
        if (!text.empty() && (text.front() == '[' || text.front() == '{' || text.front() == '"'))
            throw InputError::at(origin, description(error));
    }
    // TOML has no numbers such as .5, 5. and +.5.
    double number = 0;
    if (parse_number(text, number) && std::isfinite(number)) return {number, origin, text};
    return {text, origin, '"' + text + '"'};
}

}
