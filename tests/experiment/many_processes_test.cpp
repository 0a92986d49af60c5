// The same results from any number of processes: ranks of MPI, and shards.
#include "experiment/lasting_results.hpp"
#include "experiment/survival_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ManyProcesses : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        folder_ = new TemporaryFolder;
        folder_->write("c.toml", survival_config);
        const Outcome outcome = run({"run", "c.toml", "--out", "one"});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        one_ = lasting_results(folder_->path() / "one");
    }
    static void TearDownTestSuite()
    {
        delete folder_;
        folder_ = nullptr;
    }

    static Outcome run(const std::vector<std::string>& arguments) { return run_program(folder_->path(), arguments); }

    /// A small number of files, or of names, says more than all their contents.
    static void expect_same(const std::string& out)
    {
        const auto found = lasting_results(folder_->path() / out);
        EXPECT_EQ(found.size(), one_.size());
        for (const auto& [name, content] : one_) {
            ASSERT_TRUE(found.contains(name)) << name;
            EXPECT_EQ(found.at(name), content) << name;
        }
    }

    static inline TemporaryFolder* folder_ = nullptr;
    static inline std::map<std::string, std::string> one_;
};

TEST_F(ManyProcesses, ShardsOfOneFolder)
{
    for (const char* shard : {"2/3", "3/3"}) {
        const Outcome outcome = run({"run", "c.toml", "--out", "shared", "--shard", shard});
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_THAT(outcome.out, HasSubstr(std::string("shard ") + shard + " is done"));
        EXPECT_FALSE(fs::exists(folder_->path() / "shared/results.json"));
    }
    const Outcome last = run({"run", "c.toml", "--out", "shared", "--shard", "1/3"});
    EXPECT_EQ(last.status, 0) << last.error;
    EXPECT_THAT(last.out, testing::EndsWith("shared/index.html\n"));
    expect_same("shared");
}

TEST_F(ManyProcesses, ShardsOfFoldersThatAreMerged)
{
    for (const std::string shard : {"1", "2", "3"})
        ASSERT_EQ(run({"run", "c.toml", "--out", "shard-" + shard, "--shard", shard + "/3"}).status, 0);
    const Outcome merged = run({"merge", "all", "shard-1", "shard-2", "shard-3"});
    EXPECT_EQ(merged.status, 0) << merged.error;
    EXPECT_THAT(merged.out, HasSubstr("shard-2: "));
    const Outcome last = run({"run", "c.toml", "--out", "all"});
    EXPECT_EQ(last.status, 0) << last.error;
    // 34 of three series, and one of two that are deterministic.
    EXPECT_THAT(last.out, HasSubstr("104 of 104 realizations are there already\n"));
    expect_same("all");
}

TEST_F(ManyProcesses, MistakesInShards)
{
    for (const char* shard : {"0/3", "4/3", "1/0", "1", "1/3x", "x/3", "/", "-1/3"}) {
        const Outcome outcome = run({"run", "c.toml", "--out", "x", std::string("--shard=") + shard});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.error, std::string("poissonlab: error: --shard ") + shard +
                                     ": must be i/n, with i from 1 to n\n");
    }
    EXPECT_EQ(run({"merge", "x", "c.toml"}).error,
              "poissonlab: error: merge: c.toml: has no .units folder; output folders of `run --shard` are needed\n");
    EXPECT_FALSE(fs::exists(folder_->path() / "x"));
}

#ifdef POISSONLAB_MPIEXEC

/// mpirun in a container runs as root and on fewer cores than processes.
Outcome run_ranks(const fs::path& folder, int ranks, const std::string& arguments)
{
    const TemporaryFolder streams;
    const auto out = streams.path() / "out", error = streams.path() / "error";
    const std::string command = "cd " + quoted(folder.string()) + " && " + quoted(POISSONLAB_MPIEXEC) +
                                " --allow-run-as-root --oversubscribe -n " + std::to_string(ranks) + " " +
                                quoted(POISSONLAB_BINARY) + " " + arguments + " > " + quoted(out.string()) + " 2> " +
                                quoted(error.string()) + " < /dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(error)};
}

class Ranks : public ManyProcesses, public testing::WithParamInterface<int>
{
};

TEST_P(Ranks, MakeTheSameResults)
{
    const std::string out = "ranks-" + std::to_string(GetParam());
    const Outcome outcome = run_ranks(folder_->path(), GetParam(), "run c.toml --threads 1 --out " + out);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    EXPECT_THAT(outcome.out, testing::EndsWith(out + "/index.html\n"));
    expect_same(out);
    const auto machine = nlohmann::json::parse(content_of(folder_->path() / out / "results.json"))["machine"];
    EXPECT_EQ(machine.value("processes", 1), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Mpi, Ranks, testing::Values(1, 2, 4));

TEST_F(ManyProcesses, MistakesAreSaidOnce)
{
    const Outcome outcome = run_ranks(folder_->path(), 3, "run nothing.toml");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, testing::StartsWith("poissonlab: error: nothing.toml: cannot be read"));
    EXPECT_EQ(outcome.error.find("poissonlab: error", 1), std::string::npos);
}

TEST_F(ManyProcesses, WhatFailsAmidTheWorkIsSaidOnce)
{
    // 64 points often reach this radius, not always.
    folder_->write("fails.toml", "[analysis]\npoints = 64\nrealizations = 200\n[[method]]\nsampler = \"random\"\n"
                                 "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.79\n");
    const Outcome outcome = run_ranks(folder_->path(), 3, "run fails.toml --threads 1");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, HasSubstr("fails.toml:8: relative_radius = 0.79"));
    const auto first = outcome.error.find("poissonlab: error");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(outcome.error.find("poissonlab: error", first + 1), std::string::npos);
}

TEST_F(ManyProcesses, CollectionsAreSharedOutAsAWhole)
{
    folder_->write("a.toml", "[analysis]\npoints = 64\nrealizations = 3\n[[method]]\nsampler = \"random\"\n");
    folder_->write("b.toml", "[analysis]\npoints = 64\nrealizations = 5\n[[method]]\nsampler = \"random\"\n"
                             "[[method]]\nsampler = \"jittered\"\n");
    folder_->write("both.toml", "include = [\"b.toml\", \"a.toml\"]\n");
    ASSERT_EQ(run({"run", "both.toml", "--out", "both-1"}).status, 0);
    const Outcome outcome = run_ranks(folder_->path(), 2, "run both.toml --out both-2 --threads 1");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    auto first = lasting_results(folder_->path() / "both-1"), second = lasting_results(folder_->path() / "both-2");
    first.erase("collection.json"); // has the command
    second.erase("collection.json");
    EXPECT_EQ(first, second);
    EXPECT_EQ(nlohmann::json::parse(content_of(folder_->path() / "both-2/collection.json"))["runs"],
              (nlohmann::json{"b", "a"}));
}

#endif

}
}
