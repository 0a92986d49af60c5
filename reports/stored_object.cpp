#include "reports/stored_object.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {

StoredObject::StoredObject(const nlohmann::json& value, std::filesystem::path file, std::string member)
    : value_(&value), file_(std::move(file)), member_(std::move(member))
{
    if (!value_->is_object())
        throw InputError(file_.string() + ": " + (member_.empty() ? "" : member_ + ": ") +
                         "must be an object");
}

InputError StoredObject::error(const std::string& name, const std::string& problem) const
{
    return InputError(file_.string() + ": " + (member_.empty() ? name : member_ + "." + name) + ": " +
                      problem);
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

std::int64_t StoredObject::integer(const std::string& name, std::int64_t minimum) const
{
    const auto& value = at(name);
    if (!value.is_number_integer() || value.get<std::int64_t>() < minimum)
        throw error(name, "must be an integer of at least " + std::to_string(minimum));
    return value.get<std::int64_t>();
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

StoredObject StoredObject::object(const std::string& name) const
{
    return {at(name), file_, member_.empty() ? name : member_ + "." + name};
}

std::vector<StoredObject> StoredObject::objects(const std::string& name) const
{
    const auto& list = at(name);
    if (!list.is_array()) throw error(name, "must be a list of objects");
    std::vector<StoredObject> result;
    for (const auto& value : list)
        result.emplace_back(value, file_,
                            (member_.empty() ? name : member_ + "." + name) + "[" +
                                std::to_string(result.size()) + "]");
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

std::vector<std::string> StoredObject::names() const
{
    std::vector<std::string> result;
    for (const auto& item : value_->items()) result.push_back(item.key());
    return result;
}

std::string StoredObject::checked_file_name(const std::string& name, const std::string& value) const
{
    const std::filesystem::path path = value;
    const bool climbs = std::ranges::any_of(path, [](const auto& part) { return part == ".."; });
    if (path.empty() || path.is_absolute() || climbs)
        throw error(name, "'" + value + "' must be a file inside the result folder");
    if (const auto full = file_.parent_path() / path; !std::filesystem::is_regular_file(full))
        throw error(name, full.string() + " is missing");
    return value;
}

std::string StoredObject::folder_name(const std::string& name) const
{
    const auto text = this->text(name);
    if (text.empty() || text == "." || text == ".." || text.find('/') != std::string::npos)
        throw error(name, "'" + text + "' must be the name of a folder");
    return text;
}

std::string StoredObject::file_name(const std::string& name) const
{
    return checked_file_name(name, text(name));
}

std::vector<std::string> StoredObject::file_names(const std::string& name) const
{
    auto result = texts(name);
    for (const auto& value : result) checked_file_name(name, value);
    return result;
}

}
