// What a sampler can be told: declared as data, checked in one place, and remembered with its origin.
#pragma once

#include "base/errors/errors.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace poissonlab {

struct SamplerChoice;
struct SamplerSpec;

/// One value of a [[method]] key.
using ParameterValue = std::variant<double, std::int64_t, bool, std::string, std::vector<std::string>,
                                    std::shared_ptr<const SamplerChoice>>;

/// The value as it would be typed: numbers in their shortest exact form, strings without quotes, samplers as
/// tables.
std::string to_string(const ParameterValue& value);

/// True for equal values; samplers are equal when they have the same name and equal parameters.
bool same_value(const ParameterValue& a, const ParameterValue& b);

/// A declared parameter: its key, its type, what is allowed, and how it is shown.
struct ParameterSpec
{
    enum class Kind
    {
        number,
        integer,
        boolean, ///< shown in names and labels where it is true
        text,
        choice,
        paths,
        command, ///< a program with its arguments
        sampler  ///< another method with its parameters: a table in the config
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
    bool flag(const std::string& key) const;
    const std::string& text(const std::string& key) const;
    const std::vector<std::string>& texts(const std::string& key) const;
    const SamplerChoice& sampler(const std::string& key) const;
    const SourceLocation& location(const std::string& key) const;

    /// The InputError that says that the value of `key` is not possible, and why.
    InputError error(const std::string& key, const std::string& allowed) const;

    /// In alphabetical order of keys.
    const std::map<std::string, Entry>& entries() const { return entries_; }

private:
    const Entry& at(const std::string& key) const;

    std::map<std::string, Entry> entries_;
};

/// True when both have the same keys with equal values, wherever they were set.
bool same_parameters(const Parameters& a, const Parameters& b);

/// A method with its parameters, as the value of another method's parameter.
struct SamplerChoice
{
    const SamplerSpec* spec = nullptr; ///< of the registry; outlives this
    Parameters parameters;
};

}
