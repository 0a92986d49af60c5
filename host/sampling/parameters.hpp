// What a sampler can be told: declared as data, checked in one place, and remembered with its origin.
#pragma once

#include "errors/errors.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace poissonlab {

/// One value of a [[method]] key.
using ParameterValue = std::variant<double, std::int64_t, std::string, std::vector<std::string>>;

/// The value as it would be typed: numbers in their shortest exact form, strings without quotes.
std::string to_string(const ParameterValue& value);

/// A declared parameter: its key, its type, what is allowed, and how it is shown.
struct ParameterSpec
{
    enum class Kind
    {
        number,
        integer,
        text,
        choice,
        paths
    };

    std::string key;
    Kind kind = Kind::number;
    std::string help;                 ///< one line, with the unit
    double minimum = 0;               ///< inclusive; number and integer
    double maximum = 0;               ///< inclusive; number and integer
    bool exclusive_minimum = false;   ///< true: the value must be greater than minimum
    bool exclusive_maximum = false;   ///< true: the value must be less than maximum
    std::vector<std::string> choices; ///< choice: the allowed words
    std::string symbol;               ///< short form for names and labels, for example "rho"; empty: the key
};

/// The parameters of one series: key, value, and the line of the config that set it.
class Parameters
{
public:
    struct Entry
    {
        ParameterValue value;
        SourceLocation location;
    };

    void set(const std::string& key, ParameterValue value, SourceLocation location = {});

    bool has(const std::string& key) const { return entries_.contains(key); }
    double number(const std::string& key) const;
    std::int64_t integer(const std::string& key) const;
    const std::string& text(const std::string& key) const;
    const std::vector<std::string>& texts(const std::string& key) const;
    const SourceLocation& location(const std::string& key) const;

    /// The InputError that says that the value of `key` is not possible, and why.
    InputError error(const std::string& key, const std::string& allowed) const;

    /// In alphabetical order of keys.
    const std::map<std::string, Entry>& entries() const { return entries_; }

private:
    const Entry& at(const std::string& key) const;

    std::map<std::string, Entry> entries_;
};

}
