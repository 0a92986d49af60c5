#include "host/settings/keys/command_words.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

/// Options for keys that a command has; "" for other words.
std::string option_of(const std::string& key)
{
    if (key == "method") return "--method";
    return key == "min_distance" ? "--min-distance" : "";
}

TEST(CommandWords, HaveOptionsForKeys)
{
    const auto words = [](const std::string& text) { return in_words_of_commands(text, option_of); };
    EXPECT_EQ(words(""), "");
    EXPECT_EQ(words("method = lloyd or bridson"), "--method lloyd or bridson");
    EXPECT_EQ(words("a min_distance that varies"), "a --min-distance that varies");
    EXPECT_EQ(words("min_distance"), "--min-distance");
    EXPECT_EQ(words("any method of the others"), "any method of the others") << "a word of English";
    EXPECT_EQ(words("other_key = 3"), "other_key = 3") << "which the command has not";
    EXPECT_EQ(words("{ method = a, min_distance = 2 }, method = b"), "{ method = a, min_distance = 2 }, --method b");
}

}
}
