#include "app/help_lines.hpp"

#include "app/command_line.hpp"
#include "app/command_tree.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

TEST(HelpLines, KeepWhatFits)
{
    for (const char* text : {"", "\n", "a", "Two lines\n  of text\n", "  --seed N    The seed\n"})
        EXPECT_EQ(within_columns(text, 40), text);
}

TEST(HelpLines, AreBrokenBetweenWords)
{
    EXPECT_EQ(within_columns("one two three four", 9), "one two\nthree\nfour");
    EXPECT_EQ(within_columns("  one two three", 9), "  one two\n  three") << "the indent is that of the line";
    EXPECT_EQ(within_columns("a longestofwords b", 6), "a\nlongestofwords\nb") << "longer words stay whole";
    EXPECT_EQ(within_columns("  -a    one two three four", 20), "  -a    one two\n        three four")
        << "in its column";
}

TEST(HelpLines, BreakCommandsBeforeAnOption)
{
    EXPECT_EQ(within_columns("  poissonlab run a --out b --quiet", 28), "  poissonlab run a --out b \\\n      --quiet");
    EXPECT_EQ(within_columns("  poissonlab run 'a --out b' --quiet", 24), "  poissonlab run 'a --out b' --quiet")
        << "quoted words are no options";
}

/// Prints the help of a command and of those below it, and checks its lines. Returns the number of commands.
std::size_t check_help(const Command& command, std::vector<std::string> words)
{
    words.push_back(command.name);
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    arguments.push_back("--help");
    testing::internal::CaptureStdout();
    actions_called_for(static_cast<int>(arguments.size()), arguments.data());
    std::fflush(stdout);
    std::istringstream lines(testing::internal::GetCapturedStdout());
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count)
        EXPECT_LE(line.size(), help_columns) << command.name << "\n" << line;
    EXPECT_GT(count, 5u) << command.name;
    std::size_t commands = 1;
    for (const Command& part : command.commands) commands += check_help(part, words);
    return commands;
}

TEST(HelpLines, OfEveryCommandFitATerminal)
{
    std::size_t commands = 0;
    for (const Command& command : all_commands("poissonlab")) commands += check_help(command, {"poissonlab"});
    EXPECT_GT(commands, 50u);
}

}
}
