// `poissonlab diff` on results that the program made itself.
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class DiffCommand : public testing::Test
{
protected:
    /// Runs the config into a folder.
    void run(const std::string& out, const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> arguments = {"run", "c.toml", "--quiet", "--out", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run_program(folder_.path(), arguments);
        ASSERT_EQ(outcome.status, 0) << outcome.error;
    }

    Outcome diff(const std::vector<std::string>& arguments) const
    {
        std::vector<std::string> all = {"diff"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return run_program(folder_.path(), all);
    }

    TemporaryFolder folder_;
    std::string config_ = folder_.write("c.toml", "engine = \"reference\"\n[analysis]\npoints = 256\nrealizations = 4\n"
                                                  "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.6\n"
                                                  "[[method]]\nsampler = \"regular\"\n");
};

/// The lines about times, which other work on the machine may change, are left out.
bool is_about_times(const nlohmann::json& number) { return number["quantity"] == "time to generate"; }

TEST_F(DiffCommand, FindsNothingInTheSameResults)
{
    run("a");
    const Outcome outcome = diff({"a", "a"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("2 series in both."));
    EXPECT_THAT(outcome.out, HasSubstr(" 0 changed, 0 within their error"));
}

TEST_F(DiffCommand, TellsASeedFromAMethod)
{
    run("a");
    run("seed", {"--set", "seed=2"});
    const auto seeds = nlohmann::json::parse(diff({"a", "seed", "--json"}).out);
    for (const auto& number : seeds["numbers"])
        EXPECT_TRUE(number["verdict"] != "changed" || is_about_times(number)) << number;

    // Darts become random points under the name of darts.
    folder_.write("c.toml", "engine = \"reference\"\n[analysis]\npoints = 256\nrealizations = 4\n"
                            "[[method]]\nsampler = \"random\"\n");
    run("random");
    const auto results = folder_.path() / "random/results.json";
    auto json = nlohmann::json::parse(content_of(results));
    const auto a = nlohmann::json::parse(content_of(folder_.path() / "a/results.json"));
    json["series"][0]["name"] = a["series"][0]["name"];
    folder_.write("random/results.json", json.dump());
    const Outcome outcome = diff({"a", "random"});
    EXPECT_EQ(outcome.status, 4) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("worse"));
    EXPECT_THAT(outcome.out, HasSubstr("relative radius"));
    EXPECT_THAT(outcome.out, HasSubstr("missing"));
    EXPECT_THAT(outcome.out, HasSubstr("the configs differ"));
}

TEST_F(DiffCommand, SaysWhatIsWrong)
{
    const Outcome nothing = diff({"nowhere", "nowhere"});
    EXPECT_EQ(nothing.status, 2);
    EXPECT_THAT(nothing.error, HasSubstr("nowhere: no such folder"));
    EXPECT_EQ(diff({"a"}).status, 2);
    EXPECT_THAT(run_program(folder_.path(), {"diff", "--help"}).out, HasSubstr("Exit status 4"));
}

}
}
