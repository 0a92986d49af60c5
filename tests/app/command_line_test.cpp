// The program's arguments, messages and exit statuses.
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include <sys/stat.h>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;

class CommandLine : public testing::Test
{
protected:
    Outcome run(const std::vector<std::string>& arguments) const { return run_program(folder_.path(), arguments); }

    /// Expects an exit status and this line, and nothing else.
    void expect_error(const std::vector<std::string>& arguments, int status, const std::string& message) const
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, status);
        EXPECT_EQ(outcome.error, "poissonlab: error: " + message + "\n");
        EXPECT_EQ(outcome.out, "");
    }

    /// Expects an exit status and one line of error that has this in it.
    void expect_error_like(const std::vector<std::string>& arguments, int status, const std::string& part) const
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, status);
        EXPECT_THAT(outcome.error, testing::StartsWith("poissonlab: error: "));
        EXPECT_THAT(outcome.error, HasSubstr(part));
        EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
    }

    TemporaryFolder folder_;
    std::string config_ = folder_.write("c.toml", "[analysis]\npoints = 16\nrealizations = 1\n"
                                                  "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.5\n");
};

TEST_F(CommandLine, HelpAndVersion)
{
    const Outcome help = run({"--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* word : {"run", "analyze", "report", "devices", "samplers", "Examples:", "Exit status"})
        EXPECT_THAT(help.out, HasSubstr(word));
    EXPECT_EQ(run({"help"}).out, help.out);
    EXPECT_THAT(run({"run", "--help"}).out, HasSubstr("--set KEY=VALUE"));
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"run"}, {"distribute", "stipple"}}) {
        std::vector<std::string> topic = command, asked = command;
        topic.insert(topic.begin(), "help");
        asked.emplace_back("--help");
        EXPECT_EQ(run(topic).out, run(asked).out);
    }
    const Outcome version = run({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_THAT(version.out, testing::StartsWith("poissonlab 0."));
    for (const char* library : {"CGAL 5.", "OpenImageIO 2.", "OpenEXR 3."})
        EXPECT_THAT(version.out, HasSubstr(library)) << "what was built in";
}

TEST_F(CommandLine, TheManualPageHasEveryCommandAndOption)
{
    const Outcome page = run({"help", "man-page"});
    EXPECT_EQ(page.status, 0);
    for (const char* line : {".SS run\n", ".SS tiles build\n", ".SS samplers\n", "\\fB\\-\\-out\\fR \\fIDIR\\fR\n"})
        EXPECT_THAT(page.out, HasSubstr(line));
}

TEST_F(CommandLine, SamplersAreListedWithTheirParameters)
{
    const Outcome samplers = run({"samplers"});
    EXPECT_EQ(samplers.status, 0);
    EXPECT_THAT(samplers.out, HasSubstr("dart-throwing: Dart throwing (2D, 3D, device memory ~ N)"));
    EXPECT_THAT(samplers.out, HasSubstr("relative_radius = a number greater than 0 and at most 1"));
    EXPECT_EQ(run({"help", "samplers"}).out, samplers.out);
}

/// Each of the ten things is a command that there is, with options that it has.
TEST_F(CommandLine, WithoutArgumentsItShowsWhatPeopleDo)
{
    const Outcome opening = run({});
    EXPECT_EQ(opening.status, 2);
    EXPECT_EQ(opening.out, "");
    EXPECT_THAT(opening.error, HasSubstr("`poissonlab help` lists all commands"));
    const std::string page = run({"help", "man-page"}).out;
    std::istringstream lines(opening.error);
    int commands = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  ") || line.starts_with("    ")) continue;
        ++commands;
        std::istringstream words(line);
        std::string first, second;
        words >> first >> second;
        EXPECT_TRUE(page.find(".SS " + first + "\n") != page.npos ||
                    page.find(".SS " + first + " " + second + "\n") != page.npos)
            << line;
    }
    EXPECT_EQ(commands, 10);
}

TEST_F(CommandLine, WrongArguments)
{
    expect_error_like({"rnu", "x"}, 2, "unknown command \"rnu\"; did you mean \"run\"?");
    expect_error({"run"}, 2, "run: needs CONFIG (see poissonlab run --help)");
    expect_error({"run", config_, "--otu", "x"}, 2,
                 "run: --otu: there is no such option; did you mean \"--out\"? (see poissonlab run --help)");
    // Part of a name goes before letters that were missed.
    expect_error(
        {"distribute", "darts", "--distance", "4"}, 2,
        "distribute darts: --distance: there is no such option; did you mean \"--min-distance\"? (see poissonlab "
        "distribute darts --help)");
    expect_error({"distribute", "darts", "--distance=4"}, 2,
                 "distribute darts: --distance=4: there is no such option; did you mean \"--min-distance\"? (see "
                 "poissonlab distribute darts --help)");
    expect_error({"run", config_, "another"}, 2, "run: another: is one argument too many (see poissonlab run --help)");
    expect_error({"run", config_, "--threads", "0"}, 2,
                 "run: --threads 0: must be an integer from 1 to 4096 (see poissonlab run --help)");
    expect_error_like({"run", config_, "--threads", "many"}, 2, "--threads");
    expect_error_like({"help", "smaplers"}, 2, "did you mean \"samplers\"?");
    expect_error_like({"analyze"}, 2, "analyze: needs FILE");
    expect_error_like({"report", "a", "b"}, 2, "--out is missing");
}

/// The program refuses devices and pipes. It does not wait for bytes that nobody writes, or fill the memory with a file
/// that has no end.
TEST_F(CommandLine, DevicesAndPipes)
{
    ASSERT_EQ(::mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
    expect_error({"run", "/dev/zero"}, 2, "/dev/zero: is a pipe or a device; a config file (.toml) is needed");
    expect_error({"run", "pipe"}, 2, "pipe: is a pipe or a device; a config file (.toml) is needed");
    expect_error({"analyze", "/dev/zero"}, 2, "/dev/zero: is a device, not a file");
    expect_error({"tiles", "verify", "/dev/zero"}, 2, "/dev/zero: is a device, not a file");
    folder_.write("all.toml", "include = [\"pipe\"]\n");
    expect_error_like({"run", "all.toml"}, 2, "pipe is a pipe or a device");
    for (const std::string file : {"pipe", "/dev/zero"}) {
        folder_.write("file.toml", "[[method]]\nsampler = \"file\"\npath = \"" + file + "\"\n");
        expect_error_like({"run", "file.toml"}, 2, file + " is a pipe or a device; a file is needed");
    }
}

TEST_F(CommandLine, NumbersAreNumbers)
{
    for (const std::string word : {"foo", "1x", "nan", "inf"})
        expect_error_like({"distribute", "hatch", "--image", "1", "--points", "9", "--angle", word, "--out", "a.svg"},
                          2, "--angle " + word + ": must be a number");
}

TEST_F(CommandLine, WrongConfigs)
{
    expect_error({"run", "no.toml"}, 2, "no.toml: cannot be read: No such file or directory");
    expect_error({"run", "."}, 2, ".: is a folder; a config file (.toml) is needed");
    folder_.write("bad.toml", "seed = 1\nseed = 2\n");
    expect_error({"run", "bad.toml"}, 2,
                 "bad.toml:2: Error while parsing key-value pair: cannot redefine existing integer 'seed'");
    expect_error({"run", "c.toml", "--set", "sede=2"}, 2,
                 "--set sede=2: sede = 2: unknown key; did you mean \"seed\"? "
                 "known keys: title, seed, engine, device, analysis, method, tile_set, tiling, construction, "
                 "distribution, scheme, texture, packing, include");
    expect_error({"run", "c.toml", "--set", "analysis.points=abc"}, 2,
                 "--set analysis.points=abc: points = \"abc\": must be an integer from 1 to 134217728");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

TEST_F(CommandLine, SetTakesOneArgument)
{
    // CONFIG after --set must not be taken for a second value.
    expect_error_like({"run", "--set", "seed=x", "c.toml"}, 2, "--set seed=x: seed = \"x\": ");
}

TEST_F(CommandLine, NoSuchDevice)
{
    expect_error_like({"run", "c.toml", "--device", "no-such-device"}, 3, "no-such-device");
    expect_error_like({"run", "c.toml", "--set", "device=no-such-device"}, 3, "no-such-device");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
}

TEST_F(CommandLine, UnwritableOut)
{
    expect_error_like({"run", "c.toml", "--out", "/proc/poissonlab-out"}, 1, "/proc/poissonlab-out");
    expect_error({"run", "c.toml", "--out", "c.toml"}, 2, "--out c.toml: is a file; a folder is needed");
}

TEST_F(CommandLine, ReportOfNothing)
{
    expect_error_like({"report", "."}, 2, "results.json");
    expect_error_like({"report", "nowhere"}, 2, "nowhere");
}

TEST_F(CommandLine, DevicesAreListedOrMissed)
{
    const Outcome devices = run({"devices"});
    if (devices.status == 0)
        EXPECT_THAT(devices.out, testing::StartsWith("0  "));
    else
        EXPECT_EQ(devices.status, 3);
}

}
}
