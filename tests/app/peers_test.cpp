// Recipes for the samplers of others: those of Debian's SciPy run, and what is missing is left out with a word.
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::vector<std::string> small_run(const std::string& recipe)
{
    return {"run",   source_folder() + "/configs/peers/" + recipe,
            "--set", "analysis.points=256",
            "--set", "analysis.realizations=2",
            "--out", "o"};
}

TEST(Peers, SamplersOfSciPyTakePart)
{
    const TemporaryFolder folder;
    // Debian's Python: another one that is first in PATH may lack the package.
    const Outcome outcome = run_program(folder.path(), small_run("scipy.toml"), "PATH=/usr/bin:/bin");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("left out"))) << "package python3-scipy";
    const auto series = nlohmann::json::parse(content_of(folder.path() / "o/results.json"))["series"];
    ASSERT_EQ(series.size(), 6U);
    for (const auto& one : series) EXPECT_NEAR(one["points"].get<double>(), 256, 60) << one["label"];
    // Sobol points fill every elementary interval: 256 of them have one coordinate in each 256th.
    EXPECT_EQ(series[1]["label"], "SciPy, Sobol");
    EXPECT_LT(series[1]["measures"]["integration"][2]["relative_variance"].get<double>(), 0.1);
}

TEST(Peers, AreLeftOutWhereTheyAreMissing)
{
    const TemporaryFolder folder;
    const Outcome outcome = run_program(folder.path(), small_run("sample-elimination.toml"), "PATH=/usr/bin:/bin");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("cySampleElim: left out: there is no program cy-sample-elimination"));
}

}
}
