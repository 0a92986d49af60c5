// The members of a JSON object, said once for writing and for reading.
//
// A type has a function template `members(object, value)` that names its members one after the other. They are written
// where the value is const, and read and checked where it is not:
//
// - member(name, value): a bool, a number, a text, or a list of numbers or texts. A std::optional one is left out where
//   there is none. or_none(name, value) may be missing when it is read; if_any(name, value) is left out where it is 0
//   or empty.
// - object(name, value), objects(name, values): what members() names of each value.
// - group(name, function): an object whose members the function names.
#pragma once

#include "base/files/stored_object.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace poissonlab {

/// A T to be read, or a const T to be written.
template <class Value, class T>
concept Stored = std::same_as<std::remove_const_t<Value>, T>;

class JsonMembers
{
public:
    /// Writes into an object, in the order in which members are named.
    explicit JsonMembers(nlohmann::ordered_json& written) : written_(&written) {}

    /// Reads an object; all of the functions below throw InputError, as StoredObject does.
    explicit JsonMembers(StoredObject read) : read_(std::move(read)) {}

    /// The object that is read.
    const StoredObject& stored() const { return read_.value(); }

    /// Lets a function check what was read beyond single members. What is written was made here, and what has no place
    /// yet is not whole.
    void check(const auto& check) const
    {
        if (read_ && !read_->is_unplaced()) check(*read_);
    }

    /// True if a member is there to be read, or, by the argument, to be written.
    bool is_there(const std::string& name, bool is_written) const { return read_ ? read_->has(name) : is_written; }

    template <class T>
    void member(const std::string& name, T& value, std::int64_t minimum = 0)
    {
        if constexpr (std::is_const_v<T>)
            put(name, value);
        else
            get(name, value, minimum);
    }
    template <class T>
    void or_none(const std::string& name, T& value)
    {
        if (is_there(name, true)) member(name, value);
    }
    template <class T>
    void if_any(const std::string& name, T& value)
    {
        if (is_there(name, value != T{})) member(name, value);
    }

    /// A constant, the same for all values: it is written only.
    void constant(const std::string& name, std::int64_t value)
    {
        if (!read_) put(name, value);
    }

    /// The members "format" and "format_version" of a file, which one that is read must have as well.
    void format(const std::string& name, int version);

    void folder_name(const std::string& name, const std::string& value) { put(name, value); }
    void folder_name(const std::string& name, std::string& value) { value = stored().folder_name(name); }
    void file_name(const std::string& name, const std::string& value) { put(name, value); }
    void file_name(const std::string& name, std::string& value) { value = stored().file_name(name); }
    void file_names(const std::string& name, const std::vector<std::string>& values) { put(name, values); }
    void file_names(const std::string& name, std::vector<std::string>& values) { values = stored().file_names(name); }

    /// One of some words, by its place among them.
    template <class Place>
    void word(const std::string& name, Place& value, const std::vector<std::string>& words)
    {
        if constexpr (std::is_const_v<Place>)
            put(name, words.at(static_cast<std::size_t>(value)));
        else
            value = static_cast<Place>(place_among(name, words));
    }

    /// Any JSON as text; left out where that is empty.
    void json(const std::string& name, const std::string& value);
    void json(const std::string& name, std::string& value)
    {
        if (stored().has(name)) value = stored().json(name);
    }

    void group(const std::string& name, const std::function<void(JsonMembers&)>& name_members);
    void group_if(bool is_written, const std::string& name, const std::function<void(JsonMembers&)>& name_members)
    {
        if (is_there(name, is_written)) group(name, name_members);
    }

    template <class T>
    void object(const std::string& name, T& value)
    {
        group(name, [&](JsonMembers& m) { members(m, value); });
    }
    template <class T>
    void object(const std::string& name, const std::optional<T>& value)
    {
        if (value) object(name, *value);
    }
    template <class T>
    void object(const std::string& name, std::optional<T>& value)
    {
        if (stored().has(name)) object(name, value.emplace());
    }
    /// null where there is no value.
    template <class T>
    void object_or_null(const std::string& name, T& value)
    {
        if (read_ || value)
            object(name, value);
        else
            put_json(name, "null");
    }
    template <class T>
    void object_or_none(const std::string& name, T& value)
    {
        if (is_there(name, true)) object(name, value);
    }

    /// `name_members(object, value)` names the members of each value.
    template <class T, class Function>
    void objects(const std::string& name, const std::vector<T>& values, const Function& name_members)
    {
        put_list(name, values.size(), [&](JsonMembers& m, std::size_t i) { name_members(m, values[i]); });
    }
    template <class T, class Function>
    void objects(const std::string& name, std::vector<T>& values, const Function& name_members)
    {
        for (const StoredObject& object : stored().objects(name)) {
            JsonMembers m(object);
            name_members(m, values.emplace_back());
        }
    }
    template <class T>
    void objects(const std::string& name, T& values)
    {
        objects(name, values, [](JsonMembers& m, auto& value) { members(m, value); });
    }
    template <class T>
    void objects_or_none(const std::string& name, T& values)
    {
        if (is_there(name, true)) objects(name, values);
    }
    template <class T>
    void objects_if_any(const std::string& name, T& values)
    {
        if (is_there(name, !values.empty())) objects(name, values);
    }

private:
    using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<std::int64_t>,
                               std::vector<std::size_t>, std::vector<double>, std::vector<std::string>>;
    void put_value(const std::string& name, const Value& value);
    void put_json(const std::string& name, const std::string& text);
    void put_list(const std::string& name, std::size_t size,
                  const std::function<void(JsonMembers&, std::size_t)>& name_members);

    template <class T>
    void put(const std::string& name, const T& value)
    {
        if constexpr (std::integral<T> && !std::same_as<T, bool>)
            put_value(name, static_cast<std::int64_t>(value));
        else
            put_value(name, value);
    }
    void put(const std::string& name, const std::optional<double>& value)
    {
        if (value) put_value(name, *value);
    }
    template <class Number, std::size_t n>
    void put(const std::string& name, const std::array<Number, n>& values)
    {
        using Kept = std::conditional_t<std::is_floating_point_v<Number>, double, std::int64_t>;
        put_value(name, std::vector<Kept>(values.begin(), values.end()));
    }

    void get(const std::string& name, bool& value, std::int64_t) { value = stored().boolean(name); }
    void get(const std::string& name, double& value, std::int64_t) { value = stored().number(name); }
    void get(const std::string& name, std::string& value, std::int64_t) { value = stored().text(name); }
    void get(const std::string& name, std::vector<std::string>& v, std::int64_t) { v = stored().texts(name); }
    void get(const std::string& name, std::vector<double>& v, std::int64_t) { v = stored().numbers(name); }
    void get(const std::string& name, std::vector<std::size_t>& v, std::int64_t) { v = stored().counts(name); }
    void get(const std::string& name, std::optional<double>& value, std::int64_t)
    {
        if (stored().has(name)) value = stored().number(name);
    }
    template <std::integral T>
    void get(const std::string& name, T& value, std::int64_t minimum)
    {
        constexpr T largest = std::numeric_limits<T>::max();
        constexpr bool fits = std::cmp_less(largest, StoredObject::largest_integer);
        value = static_cast<T>(
            stored().integer(name, minimum, fits ? static_cast<std::int64_t>(largest) : StoredObject::largest_integer));
    }
    template <class Number, std::size_t n>
    void get(const std::string& name, std::array<Number, n>& values, std::int64_t)
    {
        const std::vector<double> numbers = some_numbers(name, n);
        for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<Number>(numbers[i]);
    }
    std::vector<double> some_numbers(const std::string& name, std::size_t count) const;
    std::size_t place_among(const std::string& name, const std::vector<std::string>& words) const;

    nlohmann::ordered_json* written_ = nullptr; ///< null: the other one is read
    std::optional<StoredObject> read_;
};

/// The text of an object whose members a function names; bytes that are not UTF-8 are replaced. indent -1: one line.
std::string json_text(const std::function<void(JsonMembers&)>& name_members, int indent = -1);

/// Reads what json_text() wrote of results that have no place yet, see StoredObject::unplaced(). Throws InputError.
void read_unplaced(const std::string& text, const std::string& title,
                   const std::function<void(JsonMembers&)>& name_members);

}
