// Standard streams that are closed or full. What was meant for them must not end up in files.
#include "tests/luck/bad_luck.hpp"

namespace poissonlab {
namespace {

class StreamLuck : public BadLuck
{
};

TEST_F(StreamLuck, IsAFailureOnlyWhereOutputIsLost)
{
    write_config("tiny.toml", "[[method]]\nsampler = \"random\"\n");
    ASSERT_EQ(run("plain").status, 0);
    const auto plain = lasting_files(path("plain"));
    struct Case
    {
        std::string streams;
        int status;
        bool is_told;
    };
    for (const Case& c : {
             Case{">&-", 1, true},
             Case{"> /dev/full", 1, true},
             Case{"2>&-", 0, false},
             Case{"2> /dev/full", 0, false},
             Case{"<&- >&- 2>&-", 1, false},
         }) {
        SCOPED_TRACE(c.streams);
        const Outcome outcome = shell("\"$P\" run tiny.toml --out out " + c.streams);
        EXPECT_EQ(outcome.status, c.status);
        if (c.is_told) expect_one_line(outcome, c.status, "cannot write to");
        if (c.status == 0) {
            EXPECT_EQ(lasting_files(path("out")), plain);
        }
        for (const auto& [name, content] : lasting_files(path("out"))) {
            ASSERT_TRUE(plain.contains(name)) << name;
            EXPECT_EQ(content, plain.at(name)) << name;
        }
        std::filesystem::remove_all(path("out"));
    }
}

TEST_F(StreamLuck, IsAFailureOfEveryCommand)
{
    for (const std::string command : {"devices", "--help", "tiling corner --colors 2 --window 0 0 9 9"})
        expect_one_line(shell("\"$P\" " + command + " > /dev/full"), 1, "cannot write to");
}

}
}
