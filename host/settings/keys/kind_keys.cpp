// Keys that only kinds of work have: lists, spreads, files, pictures, regions, and what makes even points.
#include "base/densities/density_text.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/files/file_kind.hpp"
#include "base/images/raw_picture.hpp"
#include "base/text/decimal_commas.hpp"
#include "host/settings/config_tree.hpp"
#include "host/settings/keys/command_words.hpp"
#include "host/settings/keys/keys.hpp"
#include "host/settings/parameter_values.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

std::string name_of_input(const std::string& text)
{
    return shortened(printable(is_file_name(text) ? std::filesystem::path(text).filename().string() : text));
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
    if (!applies && keys_.is_given(value.key))
        throw keys_.invalid(
            value.key,
            "is for " + (keys_.where_.is_argument
                             ? in_words_of_commands(when, [&](const std::string& key) { return keys_.name_of(key); })
                             : when));
    return *this;
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

Keys::Said Keys::texts(KeySpec spec, std::vector<std::string>& values, const std::string& allowed)
{
    const std::string key = spec.value.key;
    std::string all;
    if (const ConfigNode* node = given(key)) {
        const auto* items = node->get_if<ConfigList>();
        values.clear();
        for (const ConfigNode& item : items ? *items : ConfigList{*node}) {
            const auto* text = item.get_if<std::string>();
            if (!text) throw invalid(key, "must be " + allowed);
            check_text(key, *text);
            all += (all.empty() ? "" : ", ") + *text;
            values.push_back(spec.is_file ? named_file(key, *text) : *text);
        }
        if (values.size() > spec.count)
            throw invalid(key, fmt::format("must be at most {} {}", spec.count,
                                           spec.is_formula ? "densities"
                                           : spec.is_file  ? "files"
                                                           : "names"));
    }
    resolve(key, all);
    return describe(std::move(spec));
}

Keys::Said Keys::pictures(const std::string& key, std::vector<std::filesystem::path>& values, std::string help)
{
    const std::string files = where_.is_argument ? "a picture's file" : "a list of pictures' files, in quotes";
    KeySpec spec{.value = {.key = key, .kind = ValueKind::text, .help = std::move(help)},
                 .count = most_listed_files,
                 .is_file = true,
                 .own = "a list of pictures' files"};
    std::vector<std::string> names;
    const Said said = texts(std::move(spec), names, files);
    if (!is_given(key)) return said;
    values.assign(names.begin(), names.end());
    for (const std::string& name : names)
        if (const std::string lack = lack_of_file(name); !lack.empty())
            throw invalid(key, fmt::format("{}{}: must be {}", names.size() > 1 ? name + ": " : "", lack, files));
    return said;
}

Keys::Said Keys::region(std::string& value)
{
    return region("region", value,
                  "where points lie, in units of its own: a file of GeoJSON, WKT or pixels, or a formula")
        .required();
}

Keys::Said Keys::picture(const std::string& key, std::filesystem::path& value, std::string help)
{
    const Said said =
        file(key, value, std::move(help),
             where_.is_argument ? "a picture's file" : "a picture's file, by its path from the config's folder");
    check(key, [&] { read_picture_header(value); });
    return said;
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

}
