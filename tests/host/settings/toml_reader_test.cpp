#include "host/settings/toml_reader.hpp"

#include "tests/support/errors.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(TomlReader, KeepsOrderLinesAndText)
{
    const ConfigTable table = read_toml("title = \"ρ\" # a comment\n"
                                        "\n"
                                        "b = [0.70, 1e-3,\n"
                                        "     +2.50]\n"
                                        "a = { x = 0x10, \"é\" = true }\n",
                                        "c.toml");
    ASSERT_EQ(table.size(), 3U);
    EXPECT_EQ(table[0].key, "title");
    EXPECT_EQ(*table[0].node.get_if<std::string>(), "ρ");
    EXPECT_EQ(table[0].node.text, "\"ρ\"");
    EXPECT_EQ(to_string(table[0].node.location), "c.toml:1");

    EXPECT_EQ(table[1].key, "b");
    const auto& list = *table[1].node.get_if<ConfigList>();
    ASSERT_EQ(list.size(), 3U);
    EXPECT_EQ(*list[0].get_if<double>(), 0.7);
    EXPECT_EQ(list[0].text, "0.70");
    EXPECT_EQ(list[1].text, "1e-3");
    EXPECT_EQ(list[2].text, "+2.50");
    EXPECT_EQ(to_string(list[2].location), "c.toml:4");

    const auto& inner = *table[2].node.get_if<ConfigTable>();
    ASSERT_EQ(inner.size(), 2U);
    EXPECT_EQ(*inner[0].node.get_if<std::int64_t>(), 16);
    EXPECT_EQ(inner[0].node.text, "0x10");
    EXPECT_EQ(*inner[1].node.get_if<bool>(), true);
    EXPECT_EQ(inner[1].node.text, "true");
}

TEST(TomlReader, ColumnsCountCharactersNotBytes)
{
    const ConfigTable table = read_toml("a = { \"é\" = \"ρρρ\", x = 0.70 }\n", "c.toml");
    EXPECT_EQ((*table[0].node.get_if<ConfigTable>())[1].node.text, "0.70");
}

TEST(TomlReader, SyntaxErrorsNameFileAndLine)
{
    const auto error = [](const std::string& text) { return message_of([&] { read_toml(text, "c.toml"); }); };
    EXPECT_EQ(error("a = 1\nb = = 2\n"), "c.toml:2: Error while parsing value: could not determine value type");
    EXPECT_EQ(error("a = 1\na = 2\n"),
              "c.toml:2: Error while parsing key-value pair: cannot redefine existing integer 'a'");
    EXPECT_EQ(error("a = \"x\xff\"\n"), "c.toml:1: Encountered invalid utf-8 sequence");
    EXPECT_EQ(error("a = 99999999999999999999\n").substr(0, 9), "c.toml:1:");
    EXPECT_EQ(error("a = [1,\n").substr(0, 9), "c.toml:1:");
}

TEST(TomlReader, ValuesOfArgumentsNeedNoQuotes)
{
    const auto value = [](const std::string& text) { return read_toml_value(text, {"--set k=v", 0, true}); };
    EXPECT_EQ(*value("reference").get_if<std::string>(), "reference");
    EXPECT_EQ(*value("\"in quotes\"").get_if<std::string>(), "in quotes");
    EXPECT_EQ(*value("two words").get_if<std::string>(), "two words");
    EXPECT_EQ(*value("7").get_if<std::int64_t>(), 7);
    EXPECT_EQ(*value("0.70").get_if<double>(), 0.7);
    EXPECT_EQ(value("0.70").text, "0.70");
    EXPECT_EQ(value("[0.6, 0.70]").get_if<ConfigList>()->at(1).text, "0.70");
    EXPECT_EQ(to_string(value("[0.6, 0.70]").get_if<ConfigList>()->at(1).location), "--set k=v");
    EXPECT_EQ(*value("1\nother = 2").get_if<std::string>(), "1\nother = 2") << "no second key";
    EXPECT_EQ(message_of([&] { value("[0.6, "); }).substr(0, 11), "--set k=v: ");
}

}
}
