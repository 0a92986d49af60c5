#include "host/settings/keys/keys.hpp"

#include "base/densities/density_values.hpp"
#include "base/files/file_kind.hpp"
#include "base/regions/region_words.hpp"
#include "host/settings/parameter_values.hpp"
#include "host/settings/sampler_help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <utility>

namespace poissonlab {
namespace {

using ValueKind = ParameterSpec::Kind;

}

std::string option_name(const std::string& key)
{
    std::string name = "--" + key;
    std::ranges::replace(name, '_', '-');
    return name;
}

std::string option_name(const KeySpec& spec) { return option_name(spec.alias.empty() ? spec.value.key : spec.alias); }

std::string KeySpec::allowed() const
{
    if (!own.empty()) return own;
    if (is_spread) {
        const std::string range = allowed_values(value);
        return range + ", { uniform = [a, b] } or { normal = [mean, deviation] } of such";
    }
    if (!parts.empty() && fewest > 0 && fewest < parts.size())
        return fmt::format("[{}], or the first of these", fmt::join(parts, ", "));
    if (!parts.empty()) return fmt::format("[{}]", fmt::join(parts, ", "));
    if (is_formula) return "a picture's file or a formula, in quotes";
    if (is_region)
        return "a file's path, rectangle X0 Y0 X1 Y1, disk X Y RADIUS, formula ..., path M..., WKT or GeoJSON, in "
               "quotes; where points may lie in space also box, ball or solid";
    if (is_file) return "a file's path in quotes";
    return allowed_values(value);
}

std::string key_help(const KeySpec& spec)
{
    const ParameterSpec& value = spec.value;
    std::string text;
    if (spec.parts.empty() && spec.own.empty() && !spec.is_spread && !spec.is_file) {
        text = option_help(value);
    } else {
        text = fmt::format("{}: {}", meaning_of(value), spec.allowed());
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
        if (value.otherwise) text += "; default: " + to_string(*value.otherwise);
    }
    if (spec.is_required) return text + "; needed";
    return value.unless_given.empty() ? text : fmt::format("{}; default: {}", text, value.unless_given);
}

Keys::Keys(const ConfigTable& table, SourceLocation where, std::string name)
    : table_(&table), where_(std::move(where)), name_(std::move(name))
{}

Keys::Said Keys::Said::unit(std::string words)
{
    keys_.specs_[index_].value.unit = std::move(words);
    return *this;
}

Keys::Said Keys::Said::otherwise(std::string words)
{
    ParameterSpec& value = keys_.specs_[index_].value;
    value.otherwise.reset();
    value.unless_given = std::move(words);
    return *this;
}

Keys::Said Keys::Said::excludes(const std::string& other)
{
    KeySpec& spec = keys_.specs_[index_];
    spec.excludes = other;
    if (keys_.is_given(spec.value.key) && keys_.is_given(other))
        throw keys_.invalid(spec.value.key, "cannot be combined with " + keys_.name_of(other));
    return *this;
}

Keys::Said Keys::Said::called(std::string words)
{
    keys_.specs_[index_].alias = std::move(words);
    return *this;
}

Keys::Said Keys::Said::required()
{
    KeySpec& spec = keys_.specs_[index_];
    spec.is_required = true;
    spec.value.otherwise.reset();
    if (keys_.table_ && !keys_.is_given(spec.value.key)) throw keys_.problem("needs " + keys_.name_of(spec.value.key));
    return *this;
}

Keys::Said Keys::number(const std::string& key, double& value, Interval range, std::string help)
{
    std::optional<double> kept = value;
    const Said said = number(key, kept, range, std::move(help));
    specs_.back().value.otherwise = value;
    value = *kept;
    return said;
}

Keys::Said Keys::number(const std::string& key, std::optional<double>& value, Interval range, std::string help)
{
    KeySpec spec{.value = {.key = key, .help = std::move(help), .minimum = range.low, .maximum = range.high}};
    if (const auto given = read(spec.value)) value = std::get<double>(*given);
    resolve(key, value ? fmt::format("{}", *value) : "none");
    return describe(std::move(spec));
}

Keys::Said Keys::flag(const std::string& key, bool& value, std::string help)
{
    KeySpec spec{.value = {.key = key, .kind = ValueKind::boolean, .help = std::move(help), .otherwise = value}};
    if (const auto given = read(spec.value)) value = std::get<bool>(*given);
    resolve(key, value ? "true" : "false");
    return describe(std::move(spec));
}

Keys::Said Keys::flag(const std::string& key, std::optional<bool>& value, std::string help)
{
    KeySpec spec{.value = {.key = key, .kind = ValueKind::boolean, .help = std::move(help), .choices = {"auto"}},
                 .own = "true, false or \"auto\""};
    if (const ConfigNode* node = given(key)) {
        const auto* word = node->get_if<std::string>();
        const auto* truth = node->get_if<bool>();
        if (!truth && !(word && *word == "auto")) throw invalid(key, "must be " + spec.own);
        value = truth ? std::optional(*truth) : std::nullopt;
    }
    resolve(key, !value ? "auto" : *value ? "true" : "false");
    return describe(std::move(spec));
}

Keys::Said Keys::text(const std::string& key, std::string& value, std::string help)
{
    KeySpec spec{.value = {.key = key, .kind = ValueKind::text, .help = std::move(help)}};
    if (!value.empty()) spec.value.otherwise = value;
    if (const auto given = read(spec.value)) {
        value = std::get<std::string>(*given);
        check_text(key, value);
    }
    resolve(key, value);
    return describe(std::move(spec));
}

Keys::Said Keys::word(const std::string& key, std::string& value, std::vector<std::string> words, std::string help)
{
    KeySpec spec{.value = {.key = key,
                           .kind = ValueKind::choice,
                           .help = std::move(help),
                           .choices = std::move(words),
                           .otherwise = value}};
    if (const auto given = read(spec.value)) value = std::get<std::string>(*given);
    resolve(key, value);
    return describe(std::move(spec));
}

Keys::Said Keys::parameter(ParameterSpec spec, Parameters& values)
{
    const std::string key = spec.key;
    if (const auto value = read(spec)) values.set(key, *value, place_of(key));
    resolve(key, values.is_given(key) ? to_string(values.given().at(key).value)
                 : spec.otherwise     ? to_string(*spec.otherwise)
                                      : "none");
    return describe({.value = std::move(spec)});
}

Keys::Said Keys::value(const std::string& key, std::string allowed, std::string help,
                       const std::function<void(const ConfigNode& node)>& read)
{
    const ConfigNode* node = given(key);
    if (node) read(*node);
    resolve(key, node ? text_of({{key, *node}}) : "none");
    return describe({.value = {.key = key, .help = std::move(help)}, .own = std::move(allowed)});
}

Keys::Said Keys::region(const std::string& key, std::string& value, std::string help)
{
    const Said said = text(key, value, std::move(help));
    specs_.back().is_file = specs_.back().is_region = true;
    if (!is_given(key) || value.empty() || is_region_text(value)) return said;
    value = path_of(key, value);
    if (is_file_name(value)) inputs_.emplace_back(value);
    return said;
}

Keys::Said Keys::picture_or_formula(const std::string& key, std::string& value, std::string help)
{
    const Said said = text(key, value, std::move(help));
    specs_.back().is_file = specs_.back().is_formula = true;
    if (is_given(key)) value = named_file(key, value);
    return said;
}

Keys::Said Keys::picture_or_formula(const std::string& key, std::string& value, std::string& from, std::string help)
{
    const Said said = picture_or_formula(key, value, std::move(help));
    from_of_picture(key, value, from);
    return said;
}

void Keys::from_of_picture(const std::string& key, const std::string& value, std::string& from)
{
    const std::string from_key = key + "_from", unless_given = from;
    text(from_key, from,
         fmt::format("what is read of the picture that {} names: light, ink, or one of its channels", key));
    if (value.empty() && from != unless_given) throw invalid(from_key, "needs " + name_of(key));
    if (is_given(key) && !is_file_name(value) && from != unless_given)
        throw invalid(from_key,
                      fmt::format("is for pictures, and {} is none", shown(key, shortened(printable(value)))));
}

bool Keys::is_given(const std::string& key) const { return given(key) != nullptr; }

const SourceLocation& Keys::place_of(const std::string& key) const { return given(key)->location; }

void check_described_keys(const ConfigTable& table, const std::function<void(Keys&)>& visit,
                          std::vector<std::string> before, const std::vector<std::string>& after)
{
    Keys described;
    visit(described);
    std::vector<std::string> known = std::move(before);
    for (const KeySpec& spec : described.described()) known.push_back(spec.value.key);
    known.insert(known.end(), after.begin(), after.end());
    check_keys(table, known);
}

std::string Keys::name_of(const std::string& key) const
{
    if (!where_.is_argument) return key;
    const std::string begin = name_ + ": ";
    if (is_given(key) && place_of(key).file.starts_with(begin)) return place_of(key).file.substr(begin.size());
    const auto described = std::ranges::find(specs_, key, [](const KeySpec& spec) { return spec.value.key; });
    return described == specs_.end() ? option_name(key) : option_name(*described);
}

std::string Keys::shown(const std::string& key, const std::string& word) const
{
    return where_.is_argument ? name_of(key) + " " + word : fmt::format("{} = \"{}\"", key, word);
}

InputError Keys::invalid(const std::string& key, const std::string& allowed) const
{
    const ConfigNode& node = *given(key);
    if (!where_.is_argument) return invalid_node(key, node, allowed);
    // Its place is the option, and its text what was typed.
    return InputError(fmt::format("{} {}: {}{}", node.location.file, node.text, allowed, comma_words(node, allowed)));
}

InputError Keys::problem(const std::string& what) const
{
    const std::string message = name_.empty() ? what : fmt::format("{}: {}", name_, what);
    return where_.is_argument ? InputError(message) : InputError::at(where_, message);
}

void Keys::check(const std::string& key, const std::function<void()>& work) const
{
    if (!is_given(key)) return;
    const auto said_of = [&](const std::string& said, const InputError& error) {
        const SourceLocation& place = place_of(is_given(said) ? said : key);
        const std::string message = fmt::format("{}: {}", name_of(said), error.what());
        if (where_.is_argument) return InputError(fmt::format("{}: {}", name_, message));
        return InputError::at(place, place.is_argument ? error.what() : message); // an argument names the key itself
    };
    try {
        work();
    } catch (const UnknownChannel& error) {
        throw said_of(key + "_from", error);
    } catch (const InputError& error) {
        throw said_of(key, error);
    }
}

void Keys::check(const std::function<void()>& work) const
{
    try {
        work();
    } catch (const InputError& error) {
        if (error.key().empty() || !is_given(error.key())) throw problem(error.what());
        throw invalid(error.key(), error.allowed());
    }
}

Keys::Said Keys::describe(KeySpec spec)
{
    specs_.push_back(std::move(spec));
    return {*this, specs_.size() - 1};
}

const ConfigNode* Keys::given(const std::string& key) const { return table_ ? find(*table_, key) : nullptr; }

void Keys::resolve(const std::string& key, const std::string& value)
{
    resolved_ += fmt::format("{} = {}, ", key, value);
}

/// The value that a table gives; nothing where it gives none. Throws InputError for what is not allowed.
std::optional<ParameterValue> Keys::read(const ParameterSpec& spec) const
{
    const ConfigNode* node = given(spec.key);
    if (!node) return {};
    if (node->get_if<ConfigList>()) throw invalid(spec.key, "must be " + allowed_values(spec));
    try {
        const auto choices = parameter_choices(spec, *node);
        if (choices.size() != 1) throw invalid(spec.key, "must be one value, without lists");
        return choices.front().value;
    } catch (const InputError& error) {
        throw error.key() == spec.key ? invalid(spec.key, error.allowed()) : error;
    }
}

/// Labels and names go to terminals.
void Keys::check_text(const std::string& key, const std::string& text) const
{
    if (printable(text) != text) throw invalid(key, "must be " + allowed_values({.key = key, .kind = ValueKind::text}));
}

/// A path counts from the folder of the config, unless it was typed in a command.
std::string Keys::path_of(const std::string& key, const std::string& text) const
{
    const SourceLocation& place = place_of(key);
    return place.is_argument ? text : (std::filesystem::path(place.file).parent_path() / text).string();
}

/// The path where there is a file, and where the folder that the program runs in has one of that name, which is not
/// meant; else the text as it is, which may be a formula. Files join the inputs.
std::string Keys::named_file(const std::string& key, const std::string& text)
{
    const std::string path = path_of(key, text);
    const std::string name = is_file_name(path) || is_file_name(text) ? path : text;
    if (is_file_name(name)) inputs_.emplace_back(name);
    return name;
}

}
