#include "host/settings/parameter_values.hpp"

#include "base/programs/shell_words.hpp"
#include "base/text/decimal_commas.hpp"
#include "host/settings/nearest_key.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>

namespace poissonlab {
namespace {

using Kind = ParameterSpec::Kind;

/// Bounds beyond which a range is no information for the reader.
constexpr double unlimited = 1e15;

std::string allowed_range(const ParameterSpec& spec)
{
    const bool bounded = spec.maximum < unlimited;
    if (spec.exclusive_minimum)
        return bounded ? fmt::format("greater than {} and {} {}", spec.minimum,
                                     spec.exclusive_maximum ? "less than" : "at most", spec.maximum)
                       : fmt::format("greater than {}", spec.minimum);
    if (spec.exclusive_maximum) return fmt::format("of at least {} and less than {}", spec.minimum, spec.maximum);
    return bounded ? fmt::format("from {} to {}", spec.minimum, spec.maximum)
                   : fmt::format("of at least {}", spec.minimum);
}

bool in_range(double value, const ParameterSpec& spec)
{
    // Written so that a NaN is out of range.
    return (spec.exclusive_minimum ? value > spec.minimum : value >= spec.minimum) &&
           (spec.exclusive_maximum ? value < spec.maximum : value <= spec.maximum);
}

std::optional<double> as_number(const ConfigNode& node)
{
    if (const auto* number = node.get_if<double>()) return *number;
    if (const auto* integer = node.get_if<std::int64_t>()) return static_cast<double>(*integer);
    return {};
}

/// The number as typed where that is plain decimal notation of the same value, else its shortest exact form.
std::string shown_number(const ConfigNode& node, double value)
{
    const std::string& text = node.text;
    double read = std::numeric_limits<double>::quiet_NaN();
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), read);
    const bool same = status == std::errc{} && end == text.data() + text.size() && read == value;
    return same ? text : fmt::format("{}", value);
}

/// Paths, and programs, are relative to the folder of the file that names them. A command line names none: the slashes
/// in `--set method.path=a/b` must not be taken for a folder.
SourceLocation path_location(const ConfigNode& node)
{
    return node.location.is_argument ? SourceLocation{"--set", 0, true} : node.location;
}

ParameterChoice single_choice(const ParameterSpec& spec, const ConfigNode& node)
{
    const auto refused = [&](const std::string& hint = {}) {
        return invalid_node(spec.key, node, "must be " + allowed_values(spec) + hint);
    };
    const auto without_unit = [&] {
        const auto* text = node.get_if<std::string>();
        return text ? unit_words(*text,
                                 [&](double value) {
                                     return in_range(value, spec) &&
                                            (spec.kind == Kind::number || value == std::floor(value));
                                 })
                    : "";
    };
    switch (spec.kind) {
    case Kind::number: {
        const auto number = as_number(node);
        if (!number || !in_range(*number, spec)) throw refused(without_unit());
        return {*number, shown_number(node, *number), node.location, {}};
    }
    case Kind::integer: {
        const auto* integer = node.get_if<std::int64_t>();
        if (!integer || !in_range(static_cast<double>(*integer), spec)) throw refused(without_unit());
        return {*integer, fmt::format("{}", *integer), node.location, {}};
    }
    case Kind::boolean: {
        const auto* flag = node.get_if<bool>();
        if (!flag) throw refused();
        return {*flag, *flag ? "true" : "false", node.location, {}};
    }
    case Kind::choice: {
        const auto* word = node.get_if<std::string>();
        if (!word) throw refused();
        if (std::ranges::find(spec.choices, *word) == spec.choices.end())
            throw refused(did_you_mean(*word, spec.choices));
        return {*word, *word, node.location, {}};
    }
    case Kind::text:
    case Kind::command:
    case Kind::paths: {
        const auto* text = node.get_if<std::string>();
        if (!text || text->empty()) throw refused();
        if (spec.kind == Kind::command) return {*text, *text, path_location(node), program_name(*text)};
        if (spec.kind == Kind::text) return {*text, *text, node.location, {}};
        // In a name the file's own one says enough.
        return {std::vector<std::string>{*text}, *text, path_location(node),
                std::filesystem::path(*text).stem().string()};
    }
    case Kind::sampler:
        break; // can be several: see choices_of
    }
    throw refused();
}

/// The values that one item stands for: several only where a sampler's table has lists.
std::vector<ParameterChoice> choices_of(const ParameterSpec& spec, const ConfigNode& node,
                                        const SamplerRegistry& registry, int depth)
{
    if (spec.kind == Kind::sampler) return sampler_choices(spec, node, registry, depth);
    return {single_choice(spec, node)};
}

}

std::string allowed_values(const ParameterSpec& spec)
{
    switch (spec.kind) {
    case Kind::number:
        return "a number " + allowed_range(spec);
    case Kind::integer:
        if (spec.maximum == spec.minimum + 1 && !spec.exclusive_minimum && !spec.exclusive_maximum)
            return fmt::format("{} or {}", spec.minimum, spec.maximum);
        return "an integer " + allowed_range(spec);
    case Kind::boolean:
        return "true or false";
    case Kind::choice:
        return fmt::format("one of \"{}\"", fmt::join(spec.choices, "\", \""));
    case Kind::text:
        return "a line of text in quotes";
    case Kind::command:
        return "a command in quotes, such as \"mysampler {points} {seed} {out}\"";
    case Kind::paths:
        return "a path in quotes, or a list of them";
    case Kind::sampler:
        return "a sampler's name in quotes, or a table with its parameters such as "
               "{ sampler = \"dart-throwing\", relative_radius = 0.7 }";
    }
    return {};
}

std::vector<ParameterChoice> parameter_choices(const ParameterSpec& spec, const ConfigNode& node,
                                               const SamplerRegistry& registry, int depth)
{
    const auto* list = node.get_if<ConfigList>();
    if (!list) return choices_of(spec, node, registry, depth);
    if (list->empty())
        throw invalid_node(spec.key, node, "the list is empty; each item must be " + allowed_values(spec));
    std::vector<ParameterChoice> choices;
    for (const ConfigNode& item : *list)
        std::ranges::move(choices_of(spec, item, registry, depth), std::back_inserter(choices));
    if (spec.kind != Kind::paths) return choices;

    // Paths: one value of them all, shown by the first.
    std::vector<std::string> paths;
    for (const ParameterChoice& choice : choices) paths.push_back(std::get<std::vector<std::string>>(choice.value)[0]);
    return {{std::move(paths), choices.front().shown, path_location(node), choices.front().in_name}};
}

}
