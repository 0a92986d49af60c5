#include "base/files/json_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr int deepest = 64;

/// The line of a byte, both counted from 1.
int line_of(std::string_view text, std::size_t byte)
{
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    return static_cast<int>(std::ranges::count(before, '\n')) + 1;
}

/// The library's message without the library's names: "unexpected ..." of "[json.exception.parse_error.101] parse error
/// at line 1, column 2: syntax error while parsing value - unexpected ...".
std::string reason(std::string_view what)
{
    for (const std::string_view before : {" - ", "] "})
        if (const std::size_t at = what.find(before); at != what.npos) {
            what.remove_prefix(at + before.size());
            break;
        }
    return shortened(what, 200);
}

}

nlohmann::json read_json_file(const std::filesystem::path& file)
{
    return parsed_json(read_whole_file(file), file.string());
}

nlohmann::json parsed_json(std::string_view text, const std::string& name)
{
    const auto not_too_deep = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
        if (depth > deepest)
            throw InputError::at({name},
                                 fmt::format("lists and objects lie more than {} deep in one another", deepest));
        return true;
    };
    try {
        return nlohmann::json::parse(text, not_too_deep);
    } catch (const nlohmann::json::parse_error& error) {
        throw InputError::at({name, line_of(text, error.byte)}, fmt::format("is not JSON: {}", reason(error.what())));
    } catch (const nlohmann::json::out_of_range& error) { // a number that no double holds
        throw InputError::at({name}, fmt::format("is not JSON: {}", reason(error.what())));
    }
}

namespace {

constexpr char record_separator = '\x1e';

std::string_view without_separator(std::string_view line)
{
    const std::size_t begin = line.find_first_not_of(std::string{' ', '\t', '\r', record_separator});
    return begin == line.npos ? std::string_view{} : line.substr(begin);
}

}

bool begins_as_geojson(std::string_view text)
{
    return text.starts_with('{') || (text.starts_with(record_separator) && without_separator(text).starts_with('{'));
}

nlohmann::json parsed_geojson(std::string_view text, const std::string& name)
{
    LineReader lines(text);
    lines.next();
    const bool is_sequence =
        lines.rest().find('{') != std::string_view::npos && nlohmann::json::accept(without_separator(lines.line()));
    if (!is_sequence) return parsed_json(without_separator(text), name);
    nlohmann::json features = nlohmann::json::array();
    for (LineReader each(text); each.next();) {
        const std::string_view line = without_separator(each.line());
        if (line.empty()) continue;
        try {
            nlohmann::json value = parsed_json(line, name);
            const bool is_feature = value.is_object() && value.value("type", nlohmann::json()) == "Feature";
            features.push_back(is_feature ? std::move(value)
                                          : nlohmann::json{{"type", "Feature"}, {"geometry", std::move(value)}});
        } catch (const InputError& error) {
            throw error.moved_to({name, each.number()});
        }
    }
    return {{"type", "FeatureCollection"}, {"features", std::move(features)}};
}

}
