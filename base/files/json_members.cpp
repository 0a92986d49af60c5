#include "base/files/json_members.hpp"

#include "base/files/json_file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace poissonlab {

using Json = nlohmann::ordered_json;

void JsonMembers::put_value(const std::string& name, const Value& value)
{
    (*written_)[name] = std::visit([](const auto& any) { return Json(any); }, value);
}

void JsonMembers::put_json(const std::string& name, const std::string& text) { (*written_)[name] = Json::parse(text); }

void JsonMembers::format(const std::string& name, int version)
{
    if (!read_) {
        put("format", name);
        put("format_version", version);
        return;
    }
    if (!stored().has("format") || stored().text("format") != name)
        throw stored().error("format", "must be \"" + name + "\"; this file is of another kind");
    if (stored().integer("format_version", 1) != version)
        throw stored().error("format_version", "this program reads version " + std::to_string(version));
}

void JsonMembers::json(const std::string& name, const std::string& value)
{
    if (!value.empty()) put_json(name, value);
}

void JsonMembers::group(const std::string& name, const std::function<void(JsonMembers&)>& name_members)
{
    Json object = Json::object();
    JsonMembers m = read_ ? JsonMembers(read_->object(name)) : JsonMembers(object);
    name_members(m);
    if (!read_) (*written_)[name] = std::move(object);
}

void JsonMembers::put_list(const std::string& name, std::size_t size,
                           const std::function<void(JsonMembers&, std::size_t)>& name_members)
{
    Json all = Json::array();
    for (std::size_t i = 0; i < size; ++i) {
        JsonMembers m(all.emplace_back(Json::object()));
        name_members(m, i);
    }
    (*written_)[name] = std::move(all);
}

std::size_t JsonMembers::place_among(const std::string& name, const std::vector<std::string>& words) const
{
    const std::string word = stored().text(name);
    std::string all;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == word) return i;
        all += (i == 0 ? "\"" : i + 1 < words.size() ? ", \"" : " or \"") + words[i] + "\"";
    }
    throw stored().error(name, "must be " + all);
}

/// Numbers that integers of 32 bits can hold as well.
std::vector<double> JsonMembers::some_numbers(const std::string& name, std::size_t count) const
{
    const std::vector<double> numbers = stored().numbers(name);
    constexpr std::array words{"no", "one", "two", "three", "four", "five", "six"};
    if (numbers.size() != count) throw stored().error(name, std::string("must be ") + words.at(count) + " numbers");
    for (const double number : numbers)
        if (!(std::abs(number) <= 2e9)) throw stored().error(name, "has numbers that are too large");
    return numbers;
}

std::string json_text(const std::function<void(JsonMembers&)>& name_members, int indent)
{
    Json object = Json::object();
    JsonMembers m(object);
    name_members(m);
    return object.dump(indent, ' ', false, Json::error_handler_t::replace);
}

void read_unplaced(const std::string& text, const std::string& title,
                   const std::function<void(JsonMembers&)>& name_members)
{
    const nlohmann::json json = parsed_json(text, title);
    JsonMembers m(StoredObject::unplaced(json, title));
    name_members(m);
}

}
