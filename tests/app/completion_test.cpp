// `poissonlab completion`: shells complete commands, options, and the words that options know.
#include "tests/support/command_test.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class Completion : public test::CommandTest
{
protected:
    Completion() : CommandTest("completion") {}

    /// The completions that bash offers for the last of these words.
    std::string offered(const std::string& words) const
    {
        std::ofstream(folder_.path() / "poissonlab.bash") << printed("bash");
        const std::string script = "cd '" + folder_.path().string() + "' && source poissonlab.bash && COMP_WORDS=(" +
                                   words +
                                   ") && COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) && _poissonlab && "
                                   "echo \"${COMPREPLY[*]}\" > offered";
        EXPECT_EQ(std::system(("bash -c \"" + escaped(script) + "\"").c_str()), 0) << words;
        std::stringstream text;
        text << std::ifstream(folder_.path() / "offered").rdbuf();
        return text.str();
    }

private:
    static std::string escaped(const std::string& script)
    {
        std::string text;
        for (const char letter : script) {
            if (letter == '"' || letter == '$' || letter == '\\') text += '\\';
            text += letter;
        }
        return text;
    }
};

TEST_F(Completion, BashCompletesCommandsOptionsAndWords)
{
    EXPECT_EQ(offered("poissonlab til"), "tiling tiles\n");
    EXPECT_EQ(offered("poissonlab tiles bu"), "build\n");
    EXPECT_EQ(offered("poissonlab tiles build --rel"), "--relative-radius\n");
    EXPECT_EQ(offered("poissonlab tiles build corner --colors 2 --engine re"), "reference\n");
    EXPECT_EQ(offered("poissonlab tiles build sph"), "sphere\n");
    EXPECT_EQ(offered("poissonlab distribute stipple --by ga"), "gaussian\n");
    folder_.write("photo.png", "");
    EXPECT_EQ(offered("poissonlab distribute stipple --image ph"), "photo.png\n");
}

TEST_F(Completion, KnowsTwoShells)
{
    EXPECT_THAT(printed("zsh"), HasSubstr("#compdef poissonlab"));
    EXPECT_THAT(printed("zsh"), HasSubstr("'tiles build --engine' 'opencl reference'"));
    expect_error("fish", "completion: SHELL fish: must be one of \"bash\", \"zsh\"; did you mean \"bash\"?");
}

}
}
