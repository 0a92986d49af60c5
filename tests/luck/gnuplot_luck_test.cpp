// A gnuplot that is missing, fails, lies, or has no fonts: the results are there, and the report can be made later.
#include "luck/bad_luck.hpp"

namespace poissonlab {
namespace {

class GnuplotLuck : public BadLuck
{
protected:
    /// Environment in which gnuplot is this shell script.
    std::string with_gnuplot(const std::string& script) const
    {
        const auto file = folder_.write("bin/gnuplot", "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
        return "PATH=" + quoted(path("bin").string()) + ":$PATH";
    }
};

TEST_F(GnuplotLuck, IsSaidInOneLineAndMendedByReport)
{
    write_config("tiny.toml", "[[method]]\nsampler = \"random\"\n");
    folder_.write("no-fonts.conf", "<?xml version=\"1.0\"?><fontconfig><dir>/proc/none</dir></fontconfig>");
    struct Case
    {
        std::string environment;
        std::string words;
    };
    const std::string garbage = "for i in 0 1 2 3 4 5 6 7; do echo garbage > $i.svg; echo garbage > $i.png; done";
    for (const Case& c : {
             Case{"PATH=/proc/none", "gnuplot is not installed"},
             Case{with_gnuplot("kill -SEGV $$"), "gnuplot was ended by signal 11"},
         }) {
        SCOPED_TRACE(c.words);
        expect_one_line(run("out", c.environment), 1, c.words);
    }
    expect_one_line(run("out", with_gnuplot("echo one; echo two >&2; exit 3")), 1, "gnuplot failed with status 3: one two");
    expect_one_line(run("out", with_gnuplot("exit 0")), 1, "a picture of it is missing");
    expect_one_line(run("out", with_gnuplot(garbage)), 1, "a picture of it is damaged");
    expect_one_line(run("out", "FONTCONFIG_FILE=" + quoted(path("no-fonts.conf").string())), 1, "gnuplot finds no fonts");
    EXPECT_TRUE(std::filesystem::exists(path("out") / "results.json"));
    EXPECT_THAT(left_over(path("out")), ::testing::IsEmpty());

    EXPECT_EQ(run_program(folder_.path(), {"report", "out", "--quiet"}).status, 0);
    ASSERT_EQ(run("plain").status, 0);
    EXPECT_EQ(lasting_files(path("out")), lasting_files(path("plain")));
}

}
}
