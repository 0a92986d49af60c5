// Other programs as samplers, played by /bin/sh.
#include "host/sampling/classics/command_sampler.hpp"

#include "base/points/point_file.hpp"
#include "experiment/config/plan.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <set>
#include <thread>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::MatchesRegex;

const CommandValues values{1024, 3, 77, 5, "/dir/o"};

TEST(CommandWords, HaveFields)
{
    EXPECT_THAT(command_words("mine -n {points} '--dim={dimension} x' {seed}{realization} \"{out}.npy\"", values),
                ElementsAre("mine", "-n", "1024", "--dim=3 x", "775", "/dir/o.npy"));
    EXPECT_THAT(command_words("awk '{{print}} {x = 1; {}; { a }}' {{{out}", values),
                ElementsAre("awk", "{print} {x = 1; {}; { a }}", "{{/dir/o"));
    EXPECT_THAT(command_words("a {{seed}}{out}", values), ElementsAre("a", "{seed}/dir/o"));
}

TEST(CommandWords, Mistakes)
{
    const auto error_of = [](const std::string& command) {
        return message_of([&] { command_words(command, values); });
    };
    EXPECT_EQ(error_of("mine {sed} {out}"),
              "{sed} is none of {points}, {dimension}, {seed}, {realization} and {out}; {{sed}} stands for itself");
    EXPECT_THAT(error_of("mine {points}"), HasSubstr("must have {out}"));
    EXPECT_THAT(error_of("mine {{out}}"), HasSubstr("must have {out}"));
    EXPECT_EQ(error_of("mine 'x {out}"), "a quote or backslash at the end is left open");
    EXPECT_EQ(error_of(" "), "must name a program");
}

TEST(CommandSeed, IsPositiveAndDiffers)
{
    std::set<std::uint32_t> seeds;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        for (std::uint32_t realization = 0; realization < 50; ++realization) {
            const std::uint32_t given = command_seed(seed, realization);
            EXPECT_GE(given, 1U);
            EXPECT_LT(given, 1U << 31);
            EXPECT_EQ(given, command_seed(seed, realization));
            seeds.insert(given);
        }
    EXPECT_GE(seeds.size(), 999U) << "two of 1,000 numbers below 2^31 are equal with a probability of 0.0002";
}

class CommandSampling : public testing::Test
{
protected:
    /// A config whose method runs a script of /bin/sh, with points, seed, realization and out as $1 to $4.
    fs::path config_with(const std::string& script, const std::string& more = "") const
    {
        folder_.write("script.sh", script);
        return folder_.write("c.toml", "seed = 3\n[analysis]\npoints = 16\nrealizations = 2\n[[method]]\n"
                                       "sampler = \"command\"\n"
                                       "command = \"/bin/sh script.sh {points} {seed} {realization} {out}\"\n" +
                                           more);
    }

    std::unique_ptr<Sampler> sampler_of(const std::string& script, const std::string& more = "") const
    {
        const auto plan = make_plan(read_config(config_with(script, more)));
        return plan.at(0).sampler->create(plan[0].parameters, plan[0].request, Engine::reference, {});
    }

    /// The message of a failure, from the text after the command on.
    std::string failure_of(const std::string& script, const std::string& more = "") const
    {
        const std::string message = message_of([&] { sampler_of(script, more)->sample(1); });
        const std::string command = "{out}\": ";
        const std::size_t at = message.find(command);
        EXPECT_THAT(message, HasSubstr("c.toml:7: command = "));
        return at == std::string::npos ? message : message.substr(at + command.size());
    }

    TemporaryFolder folder_;
};

TEST_F(CommandSampling, ReadsWhatTheProgramWrites)
{
    const auto sampler = sampler_of("echo \"0.$1 0.$2\" > $4; echo \"0.5 0.$3\" >> $4; echo talk; echo more >&2\n");
    const PointSet points = sampler->sample(1);
    const std::string seed = std::to_string(command_seed(3, 1));
    EXPECT_EQ(points.dimension, 2);
    EXPECT_EQ(points.coordinates, (std::vector<double>{0.16, std::stod("0." + seed), 0.5, 0.1}));
    EXPECT_TRUE(sampler->traits().sizes_vary);
}

TEST_F(CommandSampling, TakesEveryFormat)
{
    write_points(folder_.path() / "set.npy", PointSet{2, {0.25, 0.5, 0.75, 0.125}});
    write_points(folder_.path() / "set.ply", PointSet{2, {0.25, 0.5, 0.75, 0.125}});
    for (const char* type : {"npy", "ply"}) {
        const auto sampler = sampler_of("cp set." + std::string(type) + " $4." + type + "\n");
        EXPECT_EQ(sampler->sample(0).coordinates, (std::vector<double>{0.25, 0.5, 0.75, 0.125})) << type;
    }
}

TEST_F(CommandSampling, RunsInTheFolderOfTheConfigWithoutInput)
{
    folder_.write("answer.txt", "0.5 0.5\n");
    const auto sampler = sampler_of("cat > input; test -s input || cp answer.txt $4\n");
    EXPECT_EQ(sampler->sample(0).size(), 1U);
}

TEST_F(CommandSampling, SaysHowAProgramFailed)
{
    EXPECT_EQ(failure_of("echo working; echo 'no luck today' >&2; exit 3\n"),
              "realization 1: it ended with exit status 3; it said:\n    working\n    no luck today");
    EXPECT_EQ(failure_of("exit 1\n"), "realization 1: it ended with exit status 1");
    EXPECT_EQ(failure_of("kill -SEGV $$\n"), "realization 1: a signal ended it: Segmentation fault");
    EXPECT_EQ(failure_of("echo hello\n"),
              "realization 1: it wrote no file at the path that it was given in place of {out}; it said:\n    hello");
    EXPECT_EQ(failure_of("echo 0.1 0.1 > $4.a; echo 0.2 0.2 > $4.b\n"),
              "realization 1: it wrote 2 files, points.a and points.b among them; one is needed");
}

TEST_F(CommandSampling, ShowsTheEndOfLongOutput)
{
    const std::string failure =
        failure_of("i=0; while [ $i -lt 20000 ]; do echo line $i; i=$((i + 1)); done; exit 1\n");
    EXPECT_THAT(failure, testing::EndsWith("    line 19998\n    line 19999"));
    EXPECT_EQ(std::ranges::count(failure, '\n'), 8);
    EXPECT_THAT(failure_of("printf 'a\\033[31mred'; exit 1\n"), testing::EndsWith("    a?[31mred"));
}

TEST_F(CommandSampling, RefusesFilesThatAreNoPointSet)
{
    EXPECT_THAT(failure_of("echo 0.1 1.5 > $4\n"), MatchesRegex("realization 1: its file points:1: .*1\\.5.*"));
    EXPECT_THAT(failure_of(": > $4\n"), HasSubstr("realization 1: its file points"));
    EXPECT_THAT(failure_of("echo some words > $4\n"), HasSubstr("its file points:1: "));
    EXPECT_THAT(failure_of("printf '0.1 0.1\\n#\\n0.2 0.2\\n' > $4\n"),
                HasSubstr("it wrote 2 realizations; one is needed"));
    EXPECT_THAT(failure_of("echo 0.1 0.1 0.1 > $4\n"),
                HasSubstr("it wrote 3D points; the experiment has dimension = 2"));
}

/// Says whether a process still runs. A killed one that its new parent has not yet collected is a zombie.
bool runs(pid_t pid)
{
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string number, name, state;
    return (stat >> number >> name >> state) && state != "Z" && state != "X";
}

TEST_F(CommandSampling, EndsWhatTakesTooLongWithAllThatItStarted)
{
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(failure_of("echo $$ > pid; sleep 50 & echo $! >> pid; wait\n", "time_limit = 0.5\n"),
              "realization 1: it did not end within time_limit = 0.5 seconds");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20)) << "and not after 50";
    std::istringstream pids(content_of(folder_.path() / "pid"));
    // A busy machine takes a while to run a process once more, in which it dies of its signal.
    const auto died = begin + std::chrono::seconds(20);
    for (pid_t pid = 0; pids >> pid;) {
        while (runs(pid) && std::chrono::steady_clock::now() < died)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        EXPECT_FALSE(runs(pid));
    }
}

TEST_F(CommandSampling, DoesNotWaitForWhatAProgramLeavesBehind)
{
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(sampler_of("echo 0.5 0.5 > $4; sleep 50 &\n")->sample(0).size(), 1U);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST_F(CommandSampling, LeavesNoFiles)
{
    const TemporaryFolder temporary;
    const std::string environment = "TMPDIR=" + quoted(temporary.path().string());
    config_with("echo 0.$2 0.5 > $4\n");
    EXPECT_EQ(run_program(folder_.path(), {"run", "c.toml"}, environment).status, 0);
    config_with("echo 0.5 0.5 > $4; exit 1\n");
    EXPECT_EQ(run_program(folder_.path(), {"run", "c.toml", "--out", "x"}, environment).status, 2);
    EXPECT_TRUE(fs::is_empty(temporary.path()));
    EXPECT_FALSE(fs::exists(folder_.path() / "x"));
}

TEST_F(CommandSampling, InterruptsEndTheProgram)
{
    config_with("echo $$ > pid; exec sleep 50\n");
    const std::string command = "cd " + quoted(folder_.path().string()) + " && " + quoted(program_file()) +
                                " run c.toml >log 2>&1 & lab=$!; while ! test -s " +
                                quoted((folder_.path() / "pid").string()) +
                                "; do sleep 0.05; done; kill -INT $lab; wait $lab";
    // Shells let background jobs ignore SIGINT; SIGTERM goes the same way.
    const int status = std::system((std::string(command).replace(command.find("-INT"), 4, "-TERM")).c_str());
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_THAT(content_of(folder_.path() / "log"),
                testing::StartsWith("poissonlab: interrupted; finished work is kept"));
    EXPECT_NE(::kill(std::stoi(content_of(folder_.path() / "pid")), 0), 0) << "the program is gone";
}

TEST_F(CommandSampling, MistakesShowBeforeAnythingRuns)
{
    const auto error_of = [&](const std::string& method) {
        return message_of([&] { make_plan(parse_config("[[method]]\nsampler = \"command\"\n" + method, "c.toml")); });
    };
    EXPECT_EQ(error_of(""),
              "c.toml:1: sampler = \"command\": needs command, such as \"mysampler {points} {seed} {out}\"");
    EXPECT_EQ(
        error_of("command = \"no-such-program {out}\"\n"),
        "c.toml:3: command = \"no-such-program {out}\": there is no program no-such-program in the folders of PATH");
    EXPECT_THAT(error_of("command = \"./nothing {out}\"\n"),
                HasSubstr("there is no program ./nothing (paths are relative"));
    EXPECT_THAT(error_of("command = \"sh {points}\"\n"),
                HasSubstr("c.toml:3: command = \"sh {points}\": must have {out}"));
    EXPECT_THAT(error_of("command = 3\n"), HasSubstr("must be a command in quotes, such as"));
    EXPECT_THAT(error_of("command = \"sh {out}\"\ntime_limit = 0\n"), HasSubstr("must be a number greater than 0"));
    EXPECT_THAT(error_of("command = \"sh {out}\"\nneeds = \"sh '\"\n"),
                HasSubstr("c.toml:4: needs = \"sh '\": a quote or backslash at the end is left open"));
}

TEST_F(CommandSampling, IsLeftOutWhereWhatItNeedsIsNotThere)
{
    const auto run = [&](const std::string& more) {
        folder_.write("c.toml", "[analysis]\npoints = 16\nrealizations = 2\n[[method]]\nsampler = \"random\"\n"
                                "[[method]]\nlabel = \"Mine\"\nsampler = \"command\"\n" +
                                    more);
        fs::remove_all(folder_.path() / "out");
        return run_program(folder_.path(), {"run", "c.toml"});
    };
    const auto series_made = [&] {
        return nlohmann::json::parse(content_of(folder_.path() / "out/c/results.json"))["series"].size();
    };
    Outcome outcome = run("command = \"no-such-program {out}\"\nneeds = \"no-such-program --help\"\n");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("Mine: left out: there is no program no-such-program in the folders of PATH"));
    EXPECT_EQ(series_made(), 1U);
    outcome = run("command = \"sh -c 'echo 0.5 0.5 > {out}'\"\nneeds = \"sh -c 'exit 1'\"\n");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("Mine: left out: what it needs is not there: sh -c 'exit 1'"));
    EXPECT_EQ(series_made(), 1U);
    outcome = run("command = \"sh -c 'echo 0.5 0.5 > {out}'\"\nneeds = \"sh -c 'exit 0'\"\n");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("left out")));
    EXPECT_EQ(series_made(), 2U);
}

TEST_F(CommandSampling, NothingButWhatIsNotThereIsAnError)
{
    folder_.write("c.toml", "[[method]]\nsampler = \"command\"\nlabel = \"Mine\"\n"
                            "command = \"sh -c x {out}\"\nneeds = \"no-such-program\"\n");
    const Outcome outcome = run_program(folder_.path(), {"run", "c.toml"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, HasSubstr("c.toml: no series is left. Mine: left out: there is no program"));
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

TEST_F(CommandSampling, SeriesAreNamedAfterTheLabelOrTheProgram)
{
    const auto plan =
        make_plan(parse_config("[[method]]\nsampler = \"command\"\n"
                               "command = [\"sh -c x {out}\", \"/bin/sh y {out}\", \"cat {out}\"]\n"
                               "[[method]]\nsampler = \"command\"\ncommand = \"sh z {out}\"\nlabel = \"Mine\"\n",
                               "c.toml"));
    ASSERT_EQ(plan.size(), 4U);
    EXPECT_EQ(plan[0].name, "command-sh");
    EXPECT_EQ(plan[0].label, "sh");
    EXPECT_EQ(plan[1].label, "sh (2)");
    EXPECT_EQ(plan[2].name, "command-cat");
    EXPECT_EQ(plan[2].label, "cat");
    EXPECT_EQ(plan[3].name, "Mine");
    EXPECT_EQ(plan[3].label, "Mine");
}

TEST(YourMethod, IsWhatTheDocumentationShows)
{
    const std::string page = content_of(source_folder() + "/docs/your-method.md");
    const auto expect_lines_of = [&](const std::string& file, const std::string& first, const std::string& last) {
        std::istringstream lines(content_of((source_folder() + "/configs/") + file));
        bool inside = false;
        std::string shown;
        for (std::string line; std::getline(lines, line);) {
            inside = inside || line.starts_with(first);
            if (inside) shown += "    " + line + "\n";
            if (line.starts_with(last)) break;
        }
        EXPECT_THAT(page, HasSubstr(shown)) << file;
    };
    expect_lines_of("your-method.awk", "#", "}");
    expect_lines_of("your-method.toml", "[[method]]", "label");
}

TEST(YourMethod, Runs)
{
    const TemporaryFolder out;
    const Outcome outcome =
        run_program(out.path(), {"run", source_folder() + "/configs/your-method.toml", "--set", "analysis.points=256",
                                 "--set", "analysis.realizations=2", "--out", "o"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    // One point in each row and column is what N-rooks is.
    const PointSet points = read_points(out.path() / "o/N-rooks/realization-001.dat").at(0);
    ASSERT_EQ(points.size(), 256U);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        std::set<int> cells;
        for (std::size_t i = 0; i < 256; ++i) cells.insert(static_cast<int>(256 * points.coordinates[2 * i + axis]));
        EXPECT_EQ(cells.size(), 256U);
    }
}

}
}
