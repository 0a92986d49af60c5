// Every key of every kind of work, given the same value at each door: a table of a config, the options of a command, a
// call of Python. They make the same settings, or refuse in the same words but for how the door spells the key.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/toml_reader.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace poissonlab {
namespace {

using ValueKind = ParameterSpec::Kind;

/// The words of a value, as a command has them: several of a list.
using TypedWords = std::vector<std::string>;

/// A key with its value.
struct TypedKey
{
    KeySpec spec;
    TypedWords words;
};

/// The keys of a kind of all_kinds(), which are many to describe.
const std::vector<KeySpec>& keys_of(const Kind& kind)
{
    static std::map<const Kind*, std::vector<KeySpec>> known;
    const auto [found, is_new] = known.try_emplace(&kind);
    if (is_new) found->second = kind.keys();
    return found->second;
}

/// The key that a command takes by its place.
std::string placed_key(const Kind& kind)
{
    if (kind.command == "distribute instances") return "scene";
    if (kind.command == "texture cells") return "alphabet";
    return kind.command == "tiles build" || kind.command == "packing" || kind.command == "texture build" ? "kind" : "";
}

bool is_text(const KeySpec& spec)
{
    const ValueKind kind = spec.value.kind;
    if (kind == ValueKind::text && spec.count > 1) return true; // a list of texts
    return spec.own.empty() && (kind == ValueKind::text || kind == ValueKind::choice || kind == ValueKind::sampler);
}

bool is_number(const std::string& word)
{
    return !word.empty() && word.find_first_not_of("+-.0123456789e") == word.npos && word != "e";
}

/// The value in a config's table.
std::string toml_value(const TypedKey& key)
{
    const auto quoted = [&](const std::string& word) {
        const bool is_bare = !is_text(key.spec) && (is_number(word) || word == "true");
        return is_bare ? word : "\"" + word + "\"";
    };
    if (key.words.size() == 1 && key.spec.parts.empty()) return quoted(key.words.front());
    std::vector<std::string> items;
    for (const std::string& word : key.words) items.push_back(quoted(word));
    return fmt::format("[{}]", fmt::join(items, ", "));
}

/// A door's answer: settings, or why there are none.
struct Answer
{
    std::string settings;
    std::string refusal;
};

template <class Door>
Answer answer_of(const Door& door)
{
    try {
        return {door().resolved, ""};
    } catch (const InputError& error) {
        return {"", error.what()};
    }
}

Answer answer_of_table(const Kind& kind, const std::vector<TypedKey>& keys)
{
    std::string text = "\n";
    for (const TypedKey& key : keys) text += key.spec.value.key + " = " + toml_value(key) + "\n";
    return answer_of([&] { return read_kind(kind, read_toml(text, "c.toml"), {"c.toml", 1}, "[[table]]"); });
}

/// Reads keys as python/module/kind_module.cpp reads the text that python/poissonlab/toml.py makes.
Answer answer_of_python(const Kind& kind, const std::vector<TypedKey>& keys)
{
    std::string text;
    for (const TypedKey& key : keys) text += key.spec.value.key + " = " + toml_value(key) + "\n";
    return answer_of([&] {
        try {
            return read_kind(kind, read_toml(text, "work"), {"work"}, "");
        } catch (const InputError& error) {
            throw error.place().file == "work" ? error.moved_to({"work"}) : error;
        }
    });
}

/// Words go where the parser of the command line puts them.
Answer answer_of_command(const Kind& kind, const std::vector<TypedKey>& keys)
{
    KindOptions typed(kind, placed_key(kind));
    const std::vector<Option> options = typed.options();
    for (const TypedKey& key : keys) {
        const bool is_placed = key.spec.value.key == placed_key(kind);
        const auto option = std::ranges::find_if(options, [&](const Option& one) {
            return is_placed ? !one.name.starts_with("--") : one.name == option_name(key.spec);
        });
        if (option == options.end()) throw std::logic_error(kind.command + " has no " + key.spec.value.key);
        if (bool* const* const flag = std::get_if<bool*>(&option->target))
            **flag = true;
        else if (key.spec.value.kind == ValueKind::boolean)
            *std::get<std::vector<std::string>*>(option->target) = {"on"};
        else
            *std::get<std::vector<std::string>*>(option->target) = key.words;
    }
    return answer_of([&] { return typed.settings(); });
}

void replace_all(std::string& text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// A refusal without its place, quotes, signs of lists, and the spelling of keys.
std::string words_alone(const Kind& kind, std::string refusal)
{
    for (const std::string& begin : {kind.command + ": ", std::string("work: "), std::string("[[table]]: ")})
        if (!begin.starts_with(":") && refusal.starts_with(begin)) refusal = refusal.substr(begin.size());
    if (refusal.starts_with("c.toml:")) refusal = refusal.substr(refusal.find(' ') + 1);
    replace_all(refusal, "[[table]]: ", "");
    std::vector<KeySpec> keys = keys_of(kind);
    std::ranges::sort(keys, std::greater(), [](const KeySpec& spec) { return option_name(spec).size(); });
    for (const KeySpec& spec : keys) replace_all(refusal, option_name(spec), spec.value.key);
    std::string placed = placed_key(kind);
    std::ranges::transform(placed, placed.begin(), [](unsigned char letter) { return std::toupper(letter); });
    if (!placed.empty() && refusal.starts_with(placed)) refusal.replace(0, placed.size(), placed_key(kind));
    for (const char* sign : {"\"", "[", "]", ",", " ="}) replace_all(refusal, sign, "");
    // Doors differ in how they take files.
    replace_all(refusal, " by its path from the config's folder", "");
    replace_all(refusal, "a list of pictures' files in quotes", "a picture's file");
    return refusal;
}

/// A value that the key may have, as long as others have nothing against it; not its default.
TypedWords good_words(const KeySpec& spec)
{
    const ParameterSpec& value = spec.value;
    if (!spec.parts.empty()) return TypedWords(spec.count, "1");
    if (value.kind == ValueKind::boolean) return {"true"};
    if (!spec.own.empty()) return {spec.is_file ? "grey.pgm" : "1"};
    if (spec.is_spread) return {fmt::format("{}", (value.minimum + std::min(value.maximum, value.minimum + 1)) / 2)};
    if (spec.is_region) return {"rectangle 0 0 9 9"};
    if (spec.is_formula) return {"0.5"};
    if (spec.is_file) return {"grey.pgm"};
    switch (value.kind) {
    case ValueKind::choice:
        return {value.choices.back()};
    case ValueKind::sampler:
        return {"jittered"};
    case ValueKind::integer: {
        const auto low = static_cast<std::int64_t>(value.minimum);
        const bool is_default = value.otherwise && std::get<std::int64_t>(*value.otherwise) == low;
        return {std::to_string(is_default ? low + 1 : low)};
    }
    case ValueKind::number:
        return {fmt::format("{}", (value.minimum + std::min(value.maximum, value.minimum + 1)) / 2)};
    default:
        return {"light"};
    }
}

/// Values that it must not have.
std::vector<TypedWords> wrong_words(const KeySpec& spec)
{
    const ParameterSpec& value = spec.value;
    if (value.kind == ValueKind::boolean) return {}; // words of commands are "on" and "off"
    if (!spec.parts.empty() && spec.fewest > 0) return {TypedWords(spec.count, "?")};
    if (!spec.parts.empty()) return {TypedWords(spec.count, "?"), TypedWords(spec.count - 1, "1")};
    if (!spec.own.empty() || spec.is_region || value.kind == ValueKind::choice || value.kind == ValueKind::sampler)
        return {{"?"}};
    if (spec.is_formula) return {{"?"}, {"nothere.png"}};
    if (spec.is_file) return {{"nothere.png"}};
    if (value.kind == ValueKind::text) return {{"?"}};
    const double step = value.kind == ValueKind::integer ? 1 : 0.5;
    std::vector<TypedWords> wrong{{"?"}, {fmt::format("{}", value.minimum - step)}};
    if (value.maximum < 1e15) wrong.push_back({fmt::format("{}", value.maximum + step)});
    return wrong;
}

class KindDoors : public testing::Test
{
protected:
    KindDoors()
    {
        std::string picture = "P2 32 32 255\n";
        for (int i = 0; i < 32 * 32; ++i) picture += std::to_string(i * 7 % 256) + "\n";
        folder_.write("grey.pgm", picture);
        std::filesystem::current_path(folder_.path());
    }
    ~KindDoors() override { std::filesystem::current_path(before_); }

    /// One key with a value, and good values of the keys that are needed.
    static std::vector<TypedKey> typed(const Kind& kind, const KeySpec& key, const TypedWords& words)
    {
        std::vector<TypedKey> keys{{key, words}};
        for (const KeySpec& spec : keys_of(kind))
            if (spec.value.key != key.value.key && spec.is_required) keys.push_back({spec, good_words(spec)});
        return keys;
    }

    /// Returns the answer that both doors give.
    static Answer compared(const Kind& kind, const std::vector<TypedKey>& keys)
    {
        const Answer table = answer_of_table(kind, keys), python = answer_of_python(kind, keys);
        const std::string about = fmt::format("{} {} {}: {} = {}", kind.table, kind.word, kind.command,
                                              keys.front().spec.value.key, toml_value(keys.front()));
        EXPECT_EQ(python.settings, table.settings) << about;
        EXPECT_EQ(words_alone(kind, python.refusal), words_alone(kind, table.refusal)) << about;
        if (kind.command.empty()) return table;
        const Answer command = answer_of_command(kind, keys);
        EXPECT_EQ(command.settings, table.settings) << about << "\n" << table.refusal << "\n" << command.refusal;
        EXPECT_EQ(words_alone(kind, command.refusal), words_alone(kind, table.refusal)) << about;
        if (!command.refusal.empty()) {
            EXPECT_TRUE(command.refusal.starts_with(kind.command + ": ")) << command.refusal;
        }
        return table;
    }

    TemporaryFolder folder_;

private:
    std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(KindDoors, MakeTheSameOfTheSameValue)
{
    int made = 0, refused = 0;
    for (const Kind& kind : all_kinds())
        for (const KeySpec& key : keys_of(kind)) {
            const Answer answer = compared(kind, typed(kind, key, good_words(key)));
            ++(answer.refusal.empty() ? made : refused);
        }
    // Some keys need others that have no part here, and are refused in the same words.
    EXPECT_GE(made, 120) << refused;
}

TEST_F(KindDoors, RefuseTheSameInTheSameWords)
{
    int refused = 0;
    for (const Kind& kind : all_kinds())
        for (const KeySpec& key : keys_of(kind))
            for (const TypedWords& words : wrong_words(key)) {
                const Answer answer = compared(kind, typed(kind, key, words));
                EXPECT_NE(answer.refusal, "") << kind.table << " " << kind.word << " " << kind.command << ": "
                                              << key.value.key << ": " << fmt::format("{}", fmt::join(words, " "));
                refused += !answer.refusal.empty();
            }
    EXPECT_GE(refused, 250);
}

/// The folder of the config counts, not the one that the program is called in; options count from there.
TEST_F(KindDoors, FilesOfTablesAreFoundBesideTheConfig)
{
    std::filesystem::create_directory("configs");
    for (const char* name : {"grey.pgm", "beside.pgm"}) // the first is what keys that are needed as well name
        std::filesystem::copy_file("grey.pgm", std::string("configs/") + name);
    int found = 0;
    for (const Kind& kind : all_kinds())
        for (const KeySpec& key : keys_of(kind)) {
            if (!key.is_file) continue;
            std::string text;
            for (const TypedKey& one : typed(kind, key, {"beside.pgm"}))
                text += one.spec.value.key + " = " + toml_value(one) + "\n";
            const std::string about = fmt::format("{} {} {}: {}", kind.table, kind.word, kind.command, key.value.key);
            try {
                const KindSettings settings =
                    read_kind(kind, read_toml(text, "configs/c.toml"), {"configs/c.toml", 1}, "[[table]]");
                EXPECT_THAT(settings.inputs, testing::Contains("configs/beside.pgm")) << about;
                ++found;
            } catch (const InputError& error) { // another key is needed, or the picture is no tile set
                EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("no such file"))) << about;
            }
        }
    EXPECT_GE(found, 10);
}

/// A table and a command of the same work are kinds of their own where one of them only draws: what both have is one
/// description.
TEST_F(KindDoors, TablesAndCommandsOfPackingsHaveTheSameLimits)
{
    const std::vector<KeySpec>& command = keys_of(*find_kind("", "packing"));
    for (const KeySpec& key : keys_of(*find_kind("packing", ""))) {
        const auto same = std::ranges::find(command, key.value.key, [](const KeySpec& spec) { return spec.value.key; });
        if (same == command.end()) continue;
        EXPECT_EQ(same->allowed(), key.allowed()) << key.value.key;
        EXPECT_EQ(same->value.help, key.value.help) << key.value.key;
    }
}

}
}
