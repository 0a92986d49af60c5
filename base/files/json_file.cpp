#include "base/files/json_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

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
    const std::size_t begin = line.find_first_not_of(std::string{' ', '\t', '\r', '\n', record_separator});
    return begin == line.npos ? std::string_view{} : line.substr(begin);
}

}

bool begins_as_geojson(std::string_view text)
{
    return text.starts_with('{') || (text.starts_with(record_separator) && without_separator(text).starts_with('{'));
}

namespace {

/// Is the text several values of JSON, one a line?
bool is_sequence(std::string_view text)
{
    LineReader lines(text);
    while (lines.next())
        if (const std::string_view line = without_separator(lines.line()); !line.empty())
            return lines.rest().find('{') != std::string_view::npos && nlohmann::json::accept(line);
    return false;
}

/// Adds a value of a sequence to a collection of features: a feature, all of a collection, or a geometry. Throws
/// InputError where it names another system of coordinates than those before.
void add_value(nlohmann::json value, bool is_first, nlohmann::json& all)
{
    if (!value.is_object()) throw InputError("must be an object of GeoJSON");
    const nlohmann::json system = value.value("crs", nlohmann::json());
    if (is_first && value.contains("crs")) all["crs"] = system;
    if (all.value("crs", nlohmann::json()) != system)
        throw InputError("crs: must be the same on all lines, or on none");
    const nlohmann::json type = value.value("type", nlohmann::json());
    if (type == "FeatureCollection" && value.contains("features") && value["features"].is_array()) {
        for (nlohmann::json& feature : value["features"]) all["features"].push_back(std::move(feature));
    } else if (type == "Feature") {
        all["features"].push_back(std::move(value));
    } else {
        all["features"].push_back({{"type", "Feature"}, {"geometry", std::move(value)}});
    }
}

}

nlohmann::json parsed_geojson(std::string_view text, const std::string& name)
{
    if (!is_sequence(text)) return parsed_json(without_separator(text), name);
    nlohmann::json all{{"type", "FeatureCollection"}, {"features", nlohmann::json::array()}};
    bool is_first = true;
    for (LineReader each(text); each.next();) {
        const std::string_view line = without_separator(each.line());
        if (line.empty()) continue;
        try {
            add_value(parsed_json(line, name), std::exchange(is_first, false), all);
        } catch (const InputError& error) {
            throw error.moved_to({name, each.number()});
        }
    }
    return all;
}

}
