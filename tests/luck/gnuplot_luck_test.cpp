// A gnuplot that is missing, fails, lies, or has no fonts: the results are there, and the report can be made later.
#include "tests/luck/bad_luck.hpp"

#include <sstream>

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
    expect_one_line(run("out", with_gnuplot("echo one; echo two >&2; exit 3")), 1,
                    "gnuplot failed with status 3: one two");
    expect_one_line(run("out", with_gnuplot("exit 0")), 1, ".svg is missing");
    expect_one_line(run("out", with_gnuplot(garbage)), 1, ".svg is damaged");
    const std::string no_fonts = "export FONTCONFIG_FILE=" + quoted(path("no-fonts.conf").string());
    expect_one_line(shell(no_fonts + "\n$P report out --print --quiet"), 1, "gnuplot finds no fonts");
    EXPECT_TRUE(std::filesystem::exists(path("out") / "results.json"));
    EXPECT_THAT(left_over(path("out")), ::testing::IsEmpty());

    EXPECT_EQ(run_program(folder_.path(), {"report", "out", "--quiet"}).status, 0);
    ASSERT_EQ(run("plain").status, 0);
    EXPECT_EQ(lasting_files(path("out")), lasting_files(path("plain")));
}

/// A process that has ended and waits for its parent to hear of it, such as the init of a container, runs no more.
bool is_running(const std::string& pid)
{
    const std::string status = content_of("/proc/" + pid + "/stat"); // "12 (name) S ..."
    const std::size_t name_end = status.rfind(')');
    return name_end != std::string::npos && status.compare(name_end, 3, ") Z") != 0;
}

/// Ctrl-C while curves are drawn: no error, and neither gnuplot nor its files stay.
TEST_F(GnuplotLuck, EndsWithTheProgram)
{
    write_config("tiny.toml", "[[method]]\nsampler = \"random\"\n");
    std::filesystem::create_directories(path("tmp"));
    const std::string gnuplot = with_gnuplot("echo $$ >> " + quoted(path("pids").string()) + "; exec sleep 50");
    // Shells let background jobs ignore SIGINT; SIGTERM goes the same way.
    const Outcome outcome = shell("export TMPDIR=$PWD/tmp " + gnuplot +
                                  "\n$P run tiny.toml --out out --quiet & lab=$!\n"
                                  "while ! test -s pids; do sleep 0.05; done; kill -TERM $lab; wait $lab");
    EXPECT_EQ(outcome.status, 130);
    EXPECT_THAT(outcome.error, ::testing::HasSubstr("poissonlab: interrupted"));
    EXPECT_THAT(outcome.error, ::testing::Not(::testing::HasSubstr("error")));
    EXPECT_TRUE(std::filesystem::is_empty(path("tmp")));
    std::istringstream pids(content_of(path("pids")));
    for (std::string pid; pids >> pid;) EXPECT_FALSE(is_running(pid)) << "gnuplot is still there";
}

}
}
