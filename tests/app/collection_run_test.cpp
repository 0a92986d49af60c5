// `poissonlab run` of a collection, and reports over it.
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CollectionRun : public testing::Test
{
protected:
    void SetUp() override
    {
        const std::string tiny = "engine = \"reference\"\n[analysis]\npoints = 64\nrealizations = 2\n";
        folder_.write("a.toml", "title = \"First\"\n" + tiny + "[[method]]\nsampler = \"random\"\n");
        folder_.write("more/b.toml", "title = \"Second\"\nseed = 5\n" + tiny +
                                         "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.60\n");
        folder_.write("all.toml", "title = \"All\"\ninclude = [\"more/*.toml\", \"a.toml\"]\n");
    }

    Outcome run(const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> arguments = {"run", "all.toml"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(folder_.path(), arguments);
    }

    nlohmann::json json(const std::string& file) const
    {
        return nlohmann::json::parse(content_of(folder_.path() / "out/all" / file));
    }

    bool has(const std::string& file) const { return fs::exists(folder_.path() / "out/all" / file); }

    TemporaryFolder folder_;
};

TEST_F(CollectionRun, MakesAFolderOfEachAndOneReport)
{
    const Outcome outcome = run();
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(json("collection.json"), nlohmann::json::parse(R"({"format": "poissonlab-collection", "format_version": 1,
                                        "title": "All", "command": "poissonlab run all.toml", "runs": ["b", "a"]})"));
    EXPECT_TRUE(has("index.html"));
    EXPECT_EQ(json("a/results.json")["title"], "First");
    EXPECT_EQ(json("b/results.json")["seed"], 5);
    EXPECT_TRUE(has("a/random/spectrum.exr"));
    EXPECT_TRUE(has("b/dart-throwing-rho-0.60/realization-001.dat"));
}

TEST_F(CollectionRun, EachRunIsTheOneOfItsCommand)
{
    ASSERT_EQ(run({"--set", "seed=9", "--threads", "1"}).status, 0);
    EXPECT_EQ(json("b/results.json")["command"], "poissonlab run more/b.toml --set seed=9 --threads 1");
    ASSERT_EQ(run_program(folder_.path(), {"run", "more/b.toml", "--set", "seed=9", "--threads", "1"}).status, 0);
    auto alone = nlohmann::json::parse(content_of(folder_.path() / "out/b/results.json"));
    auto collected = json("b/results.json");
    for (auto* results : {&alone, &collected}) {
        results->erase("machine");
        for (auto& series : (*results)["series"]) series.erase("timing");
    }
    EXPECT_EQ(collected, alone);
    for (const auto& [name, content] : files_below(folder_.path() / "out/b/dart-throwing-rho-0.60")) {
        if (!name.ends_with(".dat") && !name.ends_with(".exr") && !name.ends_with(".csv")) continue;
        EXPECT_EQ(content, content_of(folder_.path() / "out/all/b/dart-throwing-rho-0.60" / name)) << name;
    }
}

TEST_F(CollectionRun, SaysWhichOfHowManyIsRunning)
{
    const std::string out = run().out;
    EXPECT_THAT(out, testing::StartsWith("[1/2] Second\nDart throwing, rho = 0.60: 2 realizations"));
    EXPECT_THAT(out, HasSubstr("\n[2/2] First\nRandom: 2 realizations"));
    EXPECT_THAT(out, testing::EndsWith("\nout/all/index.html\n"));
    EXPECT_EQ(run({"--quiet"}).out, "out/all/index.html\n");
}

TEST_F(CollectionRun, ThatFailsKeepsWhatIsDone)
{
    ASSERT_EQ(run().status, 0);
    // 64 points often reach this radius, not always: found out while running.
    folder_.write("a.toml", "[analysis]\npoints = 64\nrealizations = 40\n"
                            "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.79\n");
    const Outcome outcome = run({"--set", "seed=1"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, HasSubstr("a.toml:6: "));
    EXPECT_EQ(json("b/results.json")["seed"], 1) << "the new one";
    EXPECT_EQ(json("a/results.json")["title"], "First") << "the old one";
    EXPECT_EQ(json("collection.json")["runs"], nlohmann::json({"b"}));
    EXPECT_TRUE(has("index.html")) << "of what is done";
    EXPECT_THAT(content_of(folder_.path() / "out/all/index.html"), testing::Not(HasSubstr("First")));
}

TEST_F(CollectionRun, MistakesShowBeforeAnythingRuns)
{
    folder_.write("a.toml", "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 1.5\n");
    const Outcome outcome = run();
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, HasSubstr("a.toml:3: relative_radius = 1.5"));
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
    folder_.write("a.toml", "[[method]]\nsampler = \"random\"\n");
    folder_.write("out/all/a/random/thesis.txt", "years of work");
    EXPECT_THAT(run().error, HasSubstr("which is not a result of poissonlab"));
    EXPECT_FALSE(has("b"));
}

TEST_F(CollectionRun, RunsAndCollectionsDoNotShareAFolder)
{
    ASSERT_EQ(run().status, 0);
    EXPECT_THAT(run_program(folder_.path(), {"run", "a.toml", "--out", "out/all"}).error,
                HasSubstr("--out out/all: is the folder of a collection"));
    ASSERT_EQ(run_program(folder_.path(), {"run", "a.toml"}).status, 0);
    EXPECT_THAT(run({"--out", "out/a"}).error, HasSubstr("--out out/a: has the results of a single run"));
}

TEST_F(CollectionRun, ReportsTakeCollectionsApart)
{
    ASSERT_EQ(run().status, 0);
    fs::remove(folder_.path() / "out/all/index.html");
    ASSERT_EQ(run_program(folder_.path(), {"report", "out/all"}).status, 0);
    EXPECT_TRUE(has("index.html"));
    ASSERT_EQ(run_program(folder_.path(), {"run", "a.toml", "--set", "seed=4"}).status, 0);
    const Outcome outcome = run_program(folder_.path(), {"report", "out/all", "out/a", "--out", "out/both"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
}

}
}
