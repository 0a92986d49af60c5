// Kinds say the same at every door.
#include "host/kinds/kinds.hpp"

#include "base/files/whole_file.hpp"
#include "host/kinds/kind_help.hpp"
#include "host/settings/toml_reader.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace poissonlab {
namespace {

TEST(Kinds, AreThoseOfTheDocumentation)
{
    EXPECT_EQ(read_whole_file(source_folder() + "/docs/kinds.md"), kinds_markdown())
        << "poissonlab kinds --markdown > docs/kinds.md";
}

TEST(Kinds, HaveKeysOnceWithHelp)
{
    for (const Kind& kind : all_kinds()) {
        std::set<std::string> keys;
        for (const KeySpec& spec : kind.keys()) {
            EXPECT_TRUE(keys.insert(spec.value.key).second) << kind.word << ": " << spec.value.key;
            EXPECT_FALSE(spec.value.help.empty()) << kind.word << ": " << spec.value.key;
            EXPECT_TRUE(spec.is_required || spec.value.otherwise || !spec.value.unless_given.empty() ||
                        spec.value.kind == ParameterSpec::Kind::text)
                << kind.word << ": " << spec.value.key << ": what holds without it?";
        }
    }
}

/// A date is no value of any key: each refuses it with its line and what it takes.
TEST(Kinds, RefuseValuesOfOtherTypesOfEachKey)
{
    for (const Kind& kind : all_kinds())
        for (const KeySpec& spec : kind.keys()) {
            const ConfigTable table = read_toml("\n\n" + spec.value.key + " = 1979-05-27", "c.toml");
            const std::string message = message_of([&] {
                read_kind(kind, table, {"c.toml", 1}, "[[" + kind.table + "]]");
            });
            const bool is_later = message.find("needs ") != std::string::npos; // of a key that was read before it
            EXPECT_TRUE(is_later || message.starts_with("c.toml:3: " + spec.value.key + " = 1979-05-27: must be "))
                << kind.word << ": " << message;
        }
}

TEST(Kinds, RefuseUnknownKeys)
{
    for (const Kind& kind : all_kinds()) {
        const ConfigTable table = read_toml("colour = 3", "c.toml");
        EXPECT_THAT(message_of([&] {
                        read_kind(kind, table, {"c.toml", 1}, "[[distribution]]");
                    }),
                    testing::StartsWith("c.toml:1: colour = 3: unknown key"));
    }
}

}
}
