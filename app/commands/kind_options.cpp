#include "app/commands/kind_options.hpp"

#include "base/errors/errors.hpp"
#include "base/files/standard_streams.hpp"
#include "experiment/run/progress.hpp"
#include "host/settings/keys/command_words.hpp"
#include "host/settings/toml_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using ValueKind = ParameterSpec::Kind;

/// Keys whose words are taken as they were typed: others may be numbers or tables.
bool is_plain_text(const KeySpec& spec)
{
    return spec.value.kind == ValueKind::text || spec.value.kind == ValueKind::choice;
}

/// Booleans that are false unless they are given; those that follow from other keys are typed as "on" or "off", or mean
/// "on" by themselves.
bool is_flag(const KeySpec& spec) { return spec.value.kind == ValueKind::boolean && spec.value.otherwise.has_value(); }

std::string in_capitals(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char letter) { return std::toupper(letter); });
    return text;
}

/// Returns the words that a boolean is typed as: "on", "off" and its other words.
std::vector<std::string> switch_words(const KeySpec& spec)
{
    std::vector<std::string> words{"on", "off"};
    std::ranges::copy(spec.value.choices, std::back_inserter(words));
    return words;
}

std::string value_name_of(const KeySpec& spec)
{
    if (!spec.parts.empty()) {
        return in_capitals(fmt::format("{}", fmt::join(spec.parts, " ")));
    }
    if (spec.is_spread) return "NUMBER|LOW HIGH|TABLE";
    switch (spec.value.kind) {
    case ValueKind::number:
        return spec.is_formula ? "NUMBER|IMAGE|FORMULA" : "NUMBER";
    case ValueKind::integer:
        return "N";
    case ValueKind::boolean:
        return spec.value.choices.empty() ? "[on|off]" : fmt::format("[on|off|{}]", fmt::join(spec.value.choices, "|"));
    case ValueKind::sampler:
        return "NAME|TABLE";
    default:
        if (spec.is_region) return "FILE|REGION";
        return spec.is_formula ? "IMAGE|FORMULA" : spec.is_file ? "FILE" : "NAME";
    }
}

/// Throws for a file that the command reads as well: it would be lost.
void check_is_no_input(const std::string& command, const std::filesystem::path& out, const KindSettings& settings)
{
    std::error_code unknown;
    for (const std::filesystem::path& input : settings.inputs)
        if (std::filesystem::is_regular_file(out, unknown) && std::filesystem::equivalent(out, input, unknown))
            throw InputError(fmt::format("{}: --out {}: is a file that the command reads: must be another one", command,
                                         printable(out.string())));
}

}

KindOptions::KindOptions(const Kind& kind, OutputFiles files, std::string placed)
    : outs(std::move(files)), kind_(kind), placed_(std::move(placed))
{
    for (KeySpec& spec : kind.keys()) {
        const std::string& key = spec.value.key;
        typed_.push_back({spec, key == placed_ ? in_capitals(key) : option_name(spec), {}});
    }
}

std::vector<Option> KindOptions::options()
{
    std::vector<Option> all;
    for (Typed& typed : typed_) all.push_back(option_of(typed));
    return joined({all, work_.options(), {json_option(as_json_, "Print the numbers of what was made as JSON")}});
}

Option KindOptions::option_of(Typed& typed) const
{
    const KeySpec& spec = typed.spec;
    const std::string help = in_words_of_commands(key_help(spec), [&](const std::string& key) {
        const auto found = std::ranges::find(typed_, key, [](const Typed& each) { return each.spec.value.key; });
        return found == typed_.end() ? "" : found->name;
    });
    if (is_flag(spec)) return {typed.name, &typed.is_set, help};
    Option option{typed.name, &typed.words, help, value_name_of(spec)}; // what is needed is said by whoever reads it
    option.may_be_left_out = spec.value.otherwise.has_value();
    option.most_values = static_cast<int>(spec.is_spread ? 2 : spec.is_file ? 1 : spec.count); // files: once for each
    if (spec.value.kind == ValueKind::choice) option.words = spec.value.choices;
    if (spec.value.kind == ValueKind::boolean) {
        option.words = switch_words(spec);
        option.alone = "on";
    }
    if (!spec.excludes.empty()) option.excludes = option_name(spec.excludes);
    return option;
}

ConfigNode KindOptions::node_of(const Typed& typed) const
{
    const SourceLocation where{fmt::format("{}: {}", kind_.command, typed.name), 0, true};
    if (typed.is_set) return {true, where, "true"};
    const auto node = [&](const std::string& word) {
        if (typed.spec.value.kind == ValueKind::boolean) {
            const std::vector<std::string> words = switch_words(typed.spec);
            if (std::ranges::find(words, word) == words.end())
                throw unknown_word(kind_.command, typed.name, word, words);
            if (word == "on" || word == "off") return ConfigNode{word == "on", where, word};
            return ConfigNode{word, where, word};
        }
        ConfigNode parsed = is_plain_text(typed.spec) ? ConfigNode{word, where, word} : read_toml_value(word, where);
        parsed.text = shortened(printable(word)); // without the quotes that a file would have
        return parsed;
    };
    if (typed.spec.parts.empty() && typed.words.size() == 1) return node(typed.words.front());
    const std::string all = shortened(printable(fmt::format("{}", fmt::join(typed.words, " "))));
    ConfigNode list{ConfigList{}, where, all};
    for (const std::string& word : typed.words) list.get_if<ConfigList>()->push_back(node(word));
    if (!typed.spec.is_spread) return list;
    return {ConfigTable{{"uniform", std::move(list)}}, where, all}; // from one to the other
}

KindSettings KindOptions::settings() const
{
    work_.engine(kind_.command); // throws for one that there is not
    ConfigTable table;
    for (const Typed& typed : typed_) {
        const ParameterSpec& value = typed.spec.value;
        if (value.key == placed_ && typed.words.empty() && value.otherwise)
            say_note(fmt::format("{} is {}, the default", typed.name, to_string(*value.otherwise)));
        if (!typed.is_set && typed.words.empty()) continue;
        if (typed.words.size() > std::max<std::size_t>(typed.spec.count, typed.spec.is_spread ? 2 : 1))
            throw typed.spec.value.key == placed_
                ? InputError(fmt::format("{}: {} {}: must be one word", kind_.command, typed.name,
                                         shortened(printable(fmt::format("{}", fmt::join(typed.words, " "))))))
                : InputError(fmt::format("{}: {}: is given twice", kind_.command, typed.name));
        table.push_back({typed.spec.value.key, node_of(typed)});
    }
    KindSettings settings = read_kind(kind_, table, {kind_.command, 0, true}, kind_.command);
    check_is_no_input(command(), out, settings);
    for (const std::filesystem::path& file : outs.files()) check_is_no_input(command(), file, settings);
    return settings;
}

std::string KindOptions::command_comment(const std::string& what) const
{
    std::vector<std::string> words;
    for (const Typed& typed : typed_) {
        const bool is_placed = typed.spec.value.key == placed_;
        if (typed.is_set) words.push_back(typed.name);
        for (std::size_t i = 0; i < typed.words.size(); ++i) {
            if (!is_placed && (i == 0 || typed.spec.is_file)) words.push_back(typed.name);
            words.push_back(is_placed ? file_word(typed.words[i]) : typed.words[i]);
        }
    }
    return poissonlab::command_comment(kind_.command, words, seed(), what);
}

void KindOptions::say_note(const std::string& note) const
{
    if (!note.empty() && !is_quiet()) fmt::print(stderr, "poissonlab: note: {}\n", note);
}

void KindOptions::say_written(const std::string& what) const
{
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin_;
    if (kept_standard_output() < 0)
        say_note(fmt::format("{}: {}, made in {}", printable(out.string()), what, duration_text(time.count())));
}

void print_numbers(const std::vector<DistributionNumber>& numbers)
{
    nlohmann::ordered_json json, meanings;
    for (const DistributionNumber& number : numbers) {
        const bool is_whole = number.value == std::floor(number.value) && std::abs(number.value) < 0x1p53;
        if (is_whole)
            json[number.key] = static_cast<std::int64_t>(number.value); // counts have no decimals
        else
            json[number.key] = number.value;
        meanings[number.key] = number.meaning;
    }
    json["meanings"] = std::move(meanings);
    fmt::print("{}\n", json.dump(2));
}

Option OutputFiles::option()
{
    std::vector<std::string> ends = formats.endings;
    if (formats.may_be_points) ends.push_back("a point file");
    return {"--out", &names, fmt::format("A file: {}; -: standard output; may be repeated", fmt::join(ends, ", ")),
            "FILE", required};
}

void OutputFiles::check(const std::string& command) const
{
    for (const std::string& name : names) checked_output(command, "--out", name, formats);
}

std::vector<std::filesystem::path> OutputFiles::files() const
{
    std::vector<std::filesystem::path> all;
    for (const std::string& name : names) all.push_back(output_name(name, formats));
    return all;
}

Command kind_command(const Kind& kind, OutputFiles files, std::string notes, void (*work)(const KindOptions&),
                     std::string placed, const PictureWidth& width)
{
    const auto o = std::make_shared<KindOptions>(kind, std::move(files), std::move(placed));
    o->pixels = width.usual;
    std::vector<Option> others{o->outs.option()};
    if (width.most > 0)
        others.push_back(allowing({"--pixels", &o->pixels, "The width of a .png; default: " + width.otherwise, "W"},
                                  Integers{1, width.most}));
    return kind_command(o, std::move(others), std::move(notes), work);
}

InputError KindOptions::of_command(const InputError& error) const
{
    const std::string message = error.what();
    const bool has_place = !error.place().file.empty() && !error.place().is_argument;
    // Work names keys as configs do; who typed an option reads its name.
    const auto typed = std::ranges::find(typed_, error.key(), [](const Typed& each) { return each.spec.value.key; });
    if (!has_place && typed != typed_.end())
        return InputError(
            fmt::format("{}: {} {}: {}", kind_.command, typed->name, shortened(error.value()), error.allowed()));
    return has_place || message.starts_with(kind_.command) ? error
                                                           : InputError(fmt::format("{}: {}", kind_.command, message));
}

}
