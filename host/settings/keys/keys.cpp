#include "host/settings/keys/keys.hpp"

#include "base/densities/density_text.hpp"
#include "base/densities/density_values.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/files/file_kind.hpp"
#include "base/images/raw_picture.hpp"
#include "base/regions/region_words.hpp"
#include "base/text/decimal_commas.hpp"
#include "host/settings/config_tree.hpp"
#include "host/settings/parameter_values.hpp"
#include "host/settings/sampler_help.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::size_t most_listed_files = 16;

using ValueKind = ParameterSpec::Kind;

/// The number that a node is, if it lies within the ends.
std::optional<double> number_within(const ConfigNode& node, Interval range)
{
    const auto* whole = node.get_if<std::int64_t>();
    const auto* real = node.get_if<double>();
    const double value = whole ? static_cast<double>(*whole) : real ? *real : NAN;
    if (!(value >= range.low && value <= range.high)) return {};
    return value;
}

std::string spread_text(const SpreadChoice& spread)
{
    using Kind = SpreadChoice::Kind;
    if (spread.kind == Kind::constant) return fmt::format("{}", spread.a);
    return fmt::format("{{ {} = [{}, {}] }}", spread.kind == Kind::normal ? "normal" : "uniform", spread.a, spread.b);
}

/// Two numbers of a spread; nothing where they are not.
std::optional<SpreadChoice> spread_of(const ConfigTable& words, Interval range)
{
    const auto* numbers = words.size() == 1 ? words.front().node.get_if<ConfigList>() : nullptr;
    if (!numbers || numbers->size() != 2) return {};
    const bool is_normal = words.front().key == "normal";
    if (!is_normal && words.front().key != "uniform") return {};
    const auto a = number_within((*numbers)[0], range);
    if (!a) return {};
    const auto b = number_within((*numbers)[1], {is_normal ? 0 : *a, range.high});
    if (!b) return {};
    return SpreadChoice{is_normal ? SpreadChoice::Kind::normal : SpreadChoice::Kind::uniform, *a, *b};
}

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

std::string name_of_input(const std::string& text)
{
    return shortened(printable(is_file_name(text) ? std::filesystem::path(text).filename().string() : text));
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

Keys::Said Keys::Said::at_most(std::size_t count)
{
    keys_.specs_[index_].count = count;
    return *this;
}

Keys::Said Keys::Said::only_if(bool applies, const std::string& when)
{
    ParameterSpec& value = keys_.specs_[index_].value;
    value.help += ", for " + when;
    if (!applies && keys_.is_given(value.key)) throw keys_.invalid(value.key, "is for " + when);
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

Keys::Said Keys::list(std::vector<double>& values, KeySpec spec, const std::vector<Interval>& ranges)
{
    const auto range = [&](std::size_t i) { return ranges[std::min(i, ranges.size() - 1)]; };
    if (const ConfigNode* node = given(spec.value.key)) {
        const auto* items = node->get_if<ConfigList>();
        const auto refused = [&](const std::string& allowed) { return invalid(spec.value.key, allowed); };
        if (!items || items->size() != spec.count)
            throw refused(fmt::format("must be [{}]", fmt::join(spec.parts, ", ")));
        for (std::size_t i = 0; i < spec.count; ++i) {
            const auto number = number_within((*items)[i], range(i));
            if (!number || (spec.value.kind == ValueKind::integer && !(*items)[i].get_if<std::int64_t>()))
                throw refused(fmt::format("must be [{}]; {} must be a number from {} to {}",
                                          fmt::join(spec.parts, ", "), spec.parts[i], range(i).low, range(i).high));
            values[i] = *number;
        }
    }
    resolve(spec.value.key, fmt::format("{}", values));
    spec.value.otherwise = fmt::format("{}", values);
    return describe(std::move(spec));
}

Keys::Said Keys::whole_numbers(const std::string& key, std::vector<std::int64_t>& values, std::int64_t low,
                               std::vector<std::string> parts, std::string help, std::size_t fewest)
{
    KeySpec spec{.value = {.key = key, .kind = ValueKind::integer, .help = std::move(help)},
                 .count = parts.size(),
                 .parts = std::move(parts),
                 .fewest = fewest};
    if (const ConfigNode* node = given(key)) {
        const auto* items = node->get_if<ConfigList>();
        values.clear();
        if (items)
            for (const ConfigNode& item : *items)
                if (const auto* number = item.get_if<std::int64_t>(); number && *number >= low)
                    values.push_back(*number);
        if (!items || values.size() != items->size() || values.size() > spec.count ||
            values.size() < (fewest > 0 ? fewest : spec.count))
            throw invalid(key, fmt::format("must be {}{}", spec.allowed(),
                                           low == 0   ? ", integers of at least 0"
                                           : low == 1 ? ", integers of at least 1"
                                                      : ""));
    }
    resolve(key, fmt::format("{}", values));
    if (!values.empty()) spec.value.otherwise = fmt::format("{}", values);
    return describe(std::move(spec));
}

Keys::Said Keys::words(const std::string& key, std::vector<std::string>& values, std::vector<std::string> known,
                       std::string help)
{
    KeySpec spec{.value = {.key = key, .kind = ValueKind::choice, .help = std::move(help)},
                 .count = known.size(),
                 .own = fmt::format("a list of {}", fmt::join(known, ", "))};
    if (const ConfigNode* node = given(key)) {
        const auto* items = node->get_if<ConfigList>();
        values.clear();
        for (const ConfigNode& item : items ? *items : ConfigList{})
            if (const auto* word = item.get_if<std::string>(); word && std::ranges::find(known, *word) != known.end())
                values.push_back(*word);
        if (!items || items->empty() || values.size() != items->size()) throw invalid(key, "must be " + spec.own);
    }
    const std::string all = fmt::format("{}", fmt::join(values, ", "));
    resolve(key, all);
    spec.value.unless_given = all;
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

Keys::Said Keys::spread(const std::string& key, SpreadChoice& value, Interval range, std::string help)
{
    KeySpec spec{.value = {.key = key, .help = std::move(help), .minimum = range.low, .maximum = range.high},
                 .is_spread = true};
    spec.value.otherwise = spread_text(value);
    if (const ConfigNode* node = given(key)) {
        const auto* words = node->get_if<ConfigTable>();
        const auto number = number_within(*node, range);
        const auto spread = words ? spread_of(*words, range) : std::nullopt;
        const auto* text = node->get_if<std::string>();
        const auto is_in_range = [&](double v) { return v >= range.low && v <= range.high; };
        if (!number && !spread)
            throw invalid(key, "must be " + spec.allowed() + (text ? unit_words(*text, is_in_range) : ""));
        value = spread ? *spread : SpreadChoice{SpreadChoice::Kind::constant, *number, 0};
    }
    resolve(key, spread_text(value));
    return describe(std::move(spec));
}

Keys::Said Keys::file(const std::string& key, std::filesystem::path& value, std::string help, const std::string& what)
{
    std::string text = value.string();
    const Said said = this->text(key, text, std::move(help));
    specs_.back().is_file = true;
    if (!is_given(key)) return said;
    value = named_file(key, text);
    if (const std::string lack = lack_of_file(value); !lack.empty()) throw invalid(key, lack + ": must be " + what);
    return said;
}

Keys::Said Keys::pictures(const std::string& key, std::vector<std::filesystem::path>& values, std::string help)
{
    const std::string files = where_.is_argument ? "a picture's file" : "a list of pictures' files, in quotes";
    KeySpec spec{.value = {.key = key, .kind = ValueKind::text, .help = std::move(help)},
                 .count = most_listed_files,
                 .is_file = true,
                 .own = "a list of pictures' files"};
    std::string all;
    if (const ConfigNode* node = given(key)) {
        const auto* items = node->get_if<ConfigList>();
        values.clear();
        for (const ConfigNode& item : items ? *items : ConfigList{*node}) {
            const auto* text = item.get_if<std::string>();
            if (!text) throw invalid(key, "must be " + files);
            check_text(key, *text);
            all += (all.empty() ? "" : ", ") + *text;
            values.emplace_back(named_file(key, *text));
            if (const std::string lack = lack_of_file(values.back()); !lack.empty())
                throw invalid(
                    key, fmt::format("{}{}: must be {}", items && items->size() > 1 ? *text + ": " : "", lack, files));
        }
        if (values.size() > spec.count) throw invalid(key, fmt::format("must be at most {} files", spec.count));
    }
    resolve(key, all);
    return describe(std::move(spec));
}

Keys::Said Keys::region(std::string& value)
{
    return region("region", value,
                  "where points lie, in units of its own: a file of GeoJSON, WKT or pixels, or a formula")
        .required();
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

Keys::Said Keys::picture(const std::string& key, std::filesystem::path& value, std::string help)
{
    const Said said =
        file(key, value, std::move(help),
             where_.is_argument ? "a picture's file" : "a picture's file, by its path from the config's folder");
    check(key, [&] { read_picture_header(value); });
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
    text(from_key, from, fmt::format("what of the picture {} is meant: light, ink, or one of its channels", key));
    if (is_given(key) && !is_file_name(value) && from != unless_given)
        throw invalid(from_key,
                      fmt::format("is for pictures, and {} is none", shown(key, shortened(printable(value)))));
}

Keys::Said Keys::number_over_region(const std::string& key, std::optional<double>& value, std::string& text,
                                    std::string& from, Interval range, std::string help)
{
    const std::string allowed =
        fmt::format("a number from {} to {}, or a formula or a picture's file in quotes", range.low, range.high);
    if (const ConfigNode* node = given(key)) {
        const auto* words = node->get_if<std::string>();
        if (words) {
            check_text(key, *words);
            text = named_file(key, *words);
        }
        // A formula without x and y is a number: points have one distance, and none that varies.
        const auto constant = words && !is_file_name(text) ? constant_of(text) : std::nullopt;
        value = constant ? number_within({*constant, node->location, node->text}, range) : number_within(*node, range);
        if (constant) text.clear();
        if (!value && text.empty()) throw invalid(key, "must be " + allowed);
    }
    resolve(key, value ? fmt::format("{}", *value) : text.empty() ? "none" : text);
    const Said said = describe({.value = {.key = key, .help = std::move(help)}, .is_formula = true, .own = allowed});
    from_of_picture(key, value ? fmt::format("{}", *value) : text, from);
    return said;
}

Keys::Said Keys::points(std::size_t& value, std::string help)
{
    return integer("points", value, 1, max_points, std::move(help)).required();
}

void Keys::density(DensityChoice& value)
{
    picture_or_formula("density", value.text, value.from,
                       "what points follow: a picture, or a formula in x and y from -1 to 1")
        .required();
    check("density", [&] { density_of_text(value.text, value.from, 1, 1); });
}

Keys::Said Keys::tiles(std::filesystem::path& value)
{
    return file("tiles", value, "the tile set's file").otherwise("corner tiles of 3 colours, 32 points");
}

void Keys::even_points(EvenMethodChoice& value)
{
    KeySpec spec{
        .value = {
            .key = "method", .kind = ValueKind::sampler, .help = "the method of even points", .unless_given = "tiles"}};
    if (given("method")) {
        const ParameterValue method = *read(spec.value);
        value.sampler = *as_sampler(method);
        resolve("method", to_string(method));
    }
    describe(std::move(spec));
    tiles(value.tiles).excludes("method");
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
