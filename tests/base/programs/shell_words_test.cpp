#include "base/programs/shell_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cstdio>

namespace poissonlab {
namespace {

using testing::ElementsAre;

/// The words that /bin/sh makes of a text, one a line.
std::string words_of_the_shell(const std::string& text)
{
    std::FILE* shell = ::popen(("printf '<%s>\\n' " + text).c_str(), "r");
    std::string out;
    std::array<char, 256> part{};
    for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), shell)) > 0;) out.append(part.data(), n);
    EXPECT_EQ(::pclose(shell), 0) << text;
    return out;
}

std::string in_lines(const std::vector<std::string>& words)
{
    std::string out;
    for (const std::string& word : words) out += "<" + word + ">\n";
    return out;
}

TEST(ShellWords, AreThoseOfTheShell)
{
    for (const char* text :
         {"a", "  a  b\tc ", "'a b' \"c d\"", "a'b c'd", "'' \"\" x", "a\\ b \\\\ \\'", R"("a\"b\\c\$\`d\e")",
          R"('a\b' 'it'\''s')", "\"it's\"", "{points} {seed}", "a=b --c=\"d e\""})
        EXPECT_EQ(in_lines(split_shell_words(text).value()), words_of_the_shell(text)) << text;
}

TEST(ShellWords, NothingButQuotesHasAMeaning)
{
    EXPECT_THAT(split_shell_words("$HOME *.txt a;b # no | comment > x").value(),
                ElementsAre("$HOME", "*.txt", "a;b", "#", "no", "|", "comment", ">", "x"));
    EXPECT_TRUE(split_shell_words(" \t").value().empty());
}

TEST(ShellWords, MustEnd)
{
    for (const char* text : {"'a", "a \"b", "a\\", "\"a\\"}) EXPECT_FALSE(split_shell_words(text)) << text;
}

RC_GTEST_PROP(ShellWords, ComeBackFromQuotes, (const std::vector<std::string>& words))
{
    std::string text;
    for (const std::string& word : words) text += " " + shell_word(word);
    RC_ASSERT(split_shell_words(text) == words);
}

TEST(ShellWords, AreQuotedForTheShell)
{
    for (const char* word : {"plain", "a b", "it's", "$HOME", "", "a\nb", "\"", "\\", "*"})
        EXPECT_EQ(words_of_the_shell(shell_word(word)), in_lines({word})) << word;
    EXPECT_EQ(shell_word("--set"), "--set");
}

}
}
