// The frame of tests of one command of the program: a folder to run it in, and its output and messages.
#pragma once

#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace poissonlab::test {

/// Words with blanks between them.
inline std::vector<std::string> words_of(const std::string& text)
{
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

class CommandTest : public testing::Test
{
protected:
    /// `command` is its name, of one word or two.
    explicit CommandTest(std::string command) : command_(std::move(command)) {}

    /// Runs the command with words that hold no blanks.
    Outcome run(const std::string& arguments) const
    {
        return run_program(folder_.path(), words_of(command_ + " " + arguments));
    }

    /// The program's output when all goes well.
    std::string printed(const std::string& arguments) const
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.error, "");
        return outcome.out;
    }

    /// Expects this line of error, and nothing else.
    void expect_error(const std::string& arguments, const std::string& message) const
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.error, "poissonlab: error: " + message + "\n");
        EXPECT_EQ(outcome.out, "");
    }

    TemporaryFolder folder_;

private:
    std::string command_;
};

}
