// Every key of every kind refuses the same wrong value in the same words in a config and in a command.
#include "host/kinds/kinds.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

/// A good value of each key that is needed, as it is typed.
std::vector<std::pair<std::string, std::string>> needed_values(const Kind& kind, const std::string& but)
{
    std::vector<std::pair<std::string, std::string>> values;
    for (const KeySpec& spec : kind.keys())
        if (spec.is_required && spec.value.key != but)
            values.emplace_back(spec.value.key, spec.value.kind == ParameterSpec::Kind::integer ? "9" : "0.5");
    return values;
}

/// What a config's table with "?" for the key is told to have there; nothing where that is no matter for it.
std::string allowed_in_table(const Kind& kind, const std::string& key)
{
    ConfigTable table;
    for (const auto& [needed, value] : needed_values(kind, key))
        table.push_back({needed, value == "9" ? ConfigNode{std::int64_t{9}, {"c.toml", 1}, value}
                                              : ConfigNode{value, {"c.toml", 1}, value}});
    if (kind.command == "tiles build" && key != "colors")
        table.push_back({"colors", {std::int64_t{2}, {"c.toml", 1}, "2"}});
    table.push_back({key, {std::string("?"), {"c.toml", 1}, "?"}});
    try {
        read_kind(kind, table, {"c.toml", 1}, "table");
    } catch (const InputError& error) {
        if (error.key() == key) return error.allowed();
    }
    return {};
}

TEST(KindDoors, RefuseTheSameInTheSameWords)
{
    const TemporaryFolder folder;
    int compared = 0;
    for (const Kind& kind : all_kinds()) {
        // A window and a picture are needed by those, which this test has no words for.
        if (kind.command.empty() || kind.command == "tiling" || kind.command == "texture build") continue;
        for (const KeySpec& spec : kind.keys()) {
            const std::string key = spec.value.key, option = option_name(spec);
            const std::string allowed = allowed_in_table(kind, key);
            if (allowed.empty() || spec.value.kind == ParameterSpec::Kind::boolean || !spec.parts.empty()) continue;
            if (key == "scene" || key == "terrain" || key == "kind") continue; // place, name of another key
            std::vector<std::string> words = test::words_of(kind.command);
            if (kind.command == "distribute instances") words.emplace_back("forest");
            if (kind.command == "tiles build" || kind.command == "packing") words.emplace_back("corner");
            for (const auto& [needed, value] : needed_values(kind, key))
                words.insert(words.end(), {needed == "points_per_tile" ? "--points" : option_name(needed), value});
            if (kind.command == "tiles build" && key != "colors") words.insert(words.end(), {"--colors", "2"});
            words.insert(words.end(), {option, "?", "--out", "out.csv"});
            const Outcome outcome = run_program(folder.path(), words);
            EXPECT_EQ(outcome.status, 2);
            EXPECT_EQ(outcome.error, "poissonlab: error: " + kind.command + ": " + option + " ?: " + allowed + "\n");
            ++compared;
        }
    }
    EXPECT_GE(compared, 28);
}

}
}
