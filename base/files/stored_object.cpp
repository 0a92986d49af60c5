#include "base/files/stored_object.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {

StoredObject::StoredObject(const nlohmann::json& value, std::filesystem::path file, std::string member)
    : value_(&value), file_(std::move(file)), member_(std::move(member))
{
    if (!value_->is_object())
        throw InputError::at({file_.string()}, (member_.empty() ? "" : member_ + ": ") + "must be an object");
}

StoredObject StoredObject::unplaced(const nlohmann::json& value, const std::string& title)
{
    StoredObject object(value, title);
    object.is_unplaced_ = true;
    return object;
}

StoredObject StoredObject::inner(const nlohmann::json& value, std::string member) const
{
    StoredObject object(value, file_, std::move(member));
    object.is_unplaced_ = is_unplaced_;
    return object;
}

InputError StoredObject::error(const std::string& name, const std::string& problem) const
{
    const auto value = value_->find(name);
    const bool is_single = value != value_->end() && value->is_primitive();
    const std::string shown =
        is_single ? " = " + shortened(value->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) : "";
    return InputError::at({file_.string()}, shortened(place_of(name), 200) + shown + ": " + problem);
}

std::string StoredObject::place_of(const std::string& name) const
{
    return member_.empty() ? name : member_ + "." + name;
}

const nlohmann::json& StoredObject::at(const std::string& name) const
{
    const auto found = value_->find(name);
    if (found == value_->end()) throw error(name, "is missing");
    return *found;
}

bool StoredObject::has(const std::string& name) const
{
    const auto found = value_->find(name);
    return found != value_->end() && !found->is_null();
}

std::string StoredObject::text(const std::string& name) const
{
    const auto& value = at(name);
    if (!value.is_string()) throw error(name, "must be a string");
    return value.get<std::string>();
}

bool StoredObject::boolean(const std::string& name) const
{
    const auto& value = at(name);
    if (!value.is_boolean()) throw error(name, "must be true or false");
    return value.get<bool>();
}

double StoredObject::number(const std::string& name) const
{
    const auto& value = at(name);
    if (!value.is_number()) throw error(name, "must be a number");
    return value.get<double>();
}

std::int64_t StoredObject::integer(const std::string& name, std::int64_t minimum, std::int64_t maximum) const
{
    const auto& value = at(name);
    // The comparison is one of doubles, because the library lets unsigned integers of 64 bits wrap to negative ones.
    const bool fits = value.is_number_integer() && value.get<double>() >= static_cast<double>(minimum) &&
                      value.get<double>() <= static_cast<double>(maximum);
    if (!fits)
        throw error(name, "must be an integer of at least " + std::to_string(minimum) +
                              (maximum == largest_integer ? "" : " and at most " + std::to_string(maximum)));
    return value.get<std::int64_t>();
}

std::vector<std::int64_t> StoredObject::integers(const std::string& name) const
{
    const auto& list = at(name);
    const auto fits = [](const nlohmann::json& v) {
        return v.is_number_integer() && !(v.is_number_unsigned() && v.get<std::uint64_t>() > INT64_MAX);
    };
    if (!list.is_array() || !std::ranges::all_of(list, fits)) throw error(name, "must be a list of integers");
    return list.get<std::vector<std::int64_t>>();
}

std::vector<std::size_t> StoredObject::counts(const std::string& name) const
{
    const auto& list = at(name);
    const auto is_count = [](const nlohmann::json& v) {
        return v.is_number_unsigned() && v.get<std::uint64_t>() <= largest_integer;
    };
    if (!list.is_array() || !std::ranges::all_of(list, is_count))
        throw error(name, "must be a list of integers of at least 0");
    return list.get<std::vector<std::size_t>>();
}

std::vector<double> StoredObject::numbers(const std::string& name) const
{
    const auto& list = at(name);
    if (!list.is_array() || !std::ranges::all_of(list, [](const auto& v) { return v.is_number(); }))
        throw error(name, "must be a list of numbers");
    return list.get<std::vector<double>>();
}

std::vector<std::string> StoredObject::texts(const std::string& name) const
{
    const auto& list = at(name);
    if (!list.is_array() || !std::ranges::all_of(list, [](const auto& v) { return v.is_string(); }))
        throw error(name, "must be a list of strings");
    return list.get<std::vector<std::string>>();
}

StoredObject StoredObject::object(const std::string& name) const { return inner(at(name), place_of(name)); }

std::vector<StoredObject> StoredObject::objects(const std::string& name) const
{
    const auto& list = at(name);
    if (!list.is_array()) throw error(name, "must be a list of objects");
    std::vector<StoredObject> result;
    for (const auto& value : list)
        result.push_back(inner(value, place_of(name) + "[" + std::to_string(result.size()) + "]"));
    return result;
}

namespace {

std::string shown_value(const nlohmann::json& value)
{
    if (value.is_string()) return value.get<std::string>();
    const auto sampler = value.is_object() ? value.find("sampler") : value.end();
    if (sampler == value.end()) return value.dump();
    std::string text;
    for (const auto& [key, member] : value.items())
        if (key != "sampler") text += (text.empty() ? "" : ", ") + key + " = " + shown_value(member);
    return shown_value(*sampler) + (text.empty() ? "" : " (" + text + ")");
}

}

std::string StoredObject::shown(const std::string& name) const { return shown_value(at(name)); }

std::string StoredObject::json(const std::string& name) const
{
    return at(name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<std::string> StoredObject::names() const
{
    std::vector<std::string> result;
    for (const auto& item : value_->items()) result.push_back(item.key());
    return result;
}

std::string StoredObject::checked_file_name(const std::string& name, const std::string& value) const
{
    if (is_unplaced_) return value;
    const std::filesystem::path path = value;
    const bool climbs = std::ranges::any_of(path, [](const auto& part) { return part == ".."; });
    if (path.empty() || path.is_absolute() || climbs || printable(value) != value)
        throw error(name, (at(name).is_string() ? "" : "\"" + shortened(value) + "\" ") +
                              "must be a file inside the result folder");
    std::error_code none; // a name that is too long is that of no file
    if (const auto full = file_.parent_path() / path; !std::filesystem::is_regular_file(full, none))
        throw error(name, full.parent_path().string() + "/" + shortened(full.filename().string()) + " is missing");
    return value;
}

std::string StoredObject::folder_name(const std::string& name) const
{
    const auto text = this->text(name);
    if (is_unplaced_) return text;
    if (text.empty() || text == "." || text == ".." || text.find('/') != std::string::npos || printable(text) != text)
        throw error(name, "must be the name of a folder");
    return text;
}

std::string StoredObject::file_name(const std::string& name) const { return checked_file_name(name, text(name)); }

std::vector<std::string> StoredObject::file_names(const std::string& name) const
{
    auto result = texts(name);
    for (const auto& value : result) checked_file_name(name, value);
    return result;
}

}
