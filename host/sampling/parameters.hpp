// The parameters of samplers: declared as data, checked in one place, and kept with the place that they come from.
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

/// The sampler that a value is, or null.
const SamplerChoice* as_sampler(const ParameterValue& value);

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
    std::string help = {};                        ///< one line, without unit and default
    std::string unit = {};                        ///< "seconds"; empty: a number without one
    double minimum = 0;                           ///< inclusive; number and integer
    double maximum = 0;                           ///< inclusive; number and integer
    bool exclusive_minimum = false;               ///< true: the value must be greater than minimum
    bool exclusive_maximum = false;               ///< true: the value must be less than maximum
    std::vector<std::string> choices = {};        ///< choice: the allowed words
    std::string symbol = {};                      ///< short form for names and labels: "rho"; empty: the key
    std::optional<ParameterValue> otherwise = {}; ///< the value where none is given
    std::string unless_given = {};                ///< what holds then where no value can say it; empty: it is needed
};

/// The parameters of one series: those that the config gives, with the line that set them, and the defaults of the
/// others. Names, labels and what identifies stored work show what was given.
class Parameters
{
public:
    struct Entry
    {
        ParameterValue value;
        SourceLocation location;
    };

    Parameters() = default;

    /// No value is given: the defaults alone.
    explicit Parameters(const std::vector<ParameterSpec>& specs);

    /// Gives a value.
    void set(const std::string& key, ParameterValue value, SourceLocation location = {});

    bool is_given(const std::string& key) const { return given_.contains(key); }

    // Values, given or default.
    double number(const std::string& key) const;
    std::int64_t integer(const std::string& key) const;
    bool flag(const std::string& key) const;
    const std::string& text(const std::string& key) const;
    const std::vector<std::string>& texts(const std::string& key) const;
    const SamplerChoice& sampler(const std::string& key) const;

    /// The place at which a value was given.
    const SourceLocation& location(const std::string& key) const { return given_.at(key).location; }

    /// The InputError that says that the given value of `key` is not possible, and why.
    InputError error(const std::string& key, const std::string& allowed) const;

    // Both maps are in alphabetical order of keys.
    const std::map<std::string, Entry>& given() const { return given_; }
    const std::map<std::string, ParameterValue>& defaults() const { return defaults_; } ///< of those not given

private:
    const ParameterValue& at(const std::string& key) const;

    std::map<std::string, Entry> given_;
    std::map<std::string, ParameterValue> defaults_;
};

/// True when the same keys are given with equal values, wherever they were set.
bool same_parameters(const Parameters& a, const Parameters& b);

/// A method with its parameters, as the value of another method's parameter.
struct SamplerChoice
{
    const SamplerSpec* spec = nullptr; ///< of the registry; outlives this
    Parameters parameters;
};

}
