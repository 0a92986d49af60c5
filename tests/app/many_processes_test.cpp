// Any number of processes makes equal results: ranks of MPI, and shards.
#include "tests/app/lasting_results.hpp"
#include "tests/app/survival_config.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

    /// Starts the file that mpirun starts as well, because pictures name the program that drew them.
    static Outcome run(const std::vector<std::string>& arguments)
    {
        return run_program(folder_->path(), arguments, "LC_ALL=C");
    }

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
    const Outcome merged = run({"merge", "shard-1", "shard-2", "shard-3", "--out", "all"});
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
        EXPECT_EQ(outcome.error,
                  std::string("poissonlab: error: run: --shard ") + shard + ": must be i/n, with i from 1 to n\n");
    }
    EXPECT_EQ(run({"merge", "c.toml", "--out", "x"}).error,
              "poissonlab: error: merge: c.toml: has no .units folder; output folders of `run --shard` are needed\n");
    EXPECT_FALSE(fs::exists(folder_->path() / "x"));
}

#ifdef POISSONLAB_HAS_MPI

/// mpirun in a container runs as root and on fewer cores than processes.
const std::string mpirun = quoted(mpiexec_file()) + " --allow-run-as-root --oversubscribe ";

Outcome run_ranks(const fs::path& folder, int ranks, const std::string& arguments)
{
    return run_in_shell(folder,
                        mpirun + "-n " + std::to_string(ranks) + " " + quoted(program_file()) + " " + arguments);
}

/// One line of ours, whatever mpirun adds.
void expect_one_error(const Outcome& outcome, const std::string& beginning)
{
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, HasSubstr("poissonlab: error: " + beginning));
    const auto first = outcome.error.find("poissonlab: error");
    EXPECT_EQ(outcome.error.find("poissonlab: error", first + 1), std::string::npos) << outcome.error;
}

TEST_F(ManyProcesses, RanksMakeTheSameResults)
{
    for (const int ranks : {1, 2, 4}) {
        const std::string out = "ranks-" + std::to_string(ranks);
        const Outcome outcome = run_ranks(folder_->path(), ranks, "run c.toml --threads 1 --out " + out);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_EQ(outcome.error, "");
        EXPECT_THAT(outcome.out, testing::EndsWith(out + "/index.html\n"));
        expect_same(out);
        const std::string results = content_of(folder_->path() / out / "results.json");
        EXPECT_EQ(results.find("\"processes\": " + std::to_string(ranks)) != std::string::npos, ranks > 1);
    }
}

TEST_F(ManyProcesses, RanksOfAShard)
{
    folder_->write("few.toml", "[analysis]\npoints = 64\nrealizations = 5\n[[method]]\nsampler = \"random\"\n");
    const Outcome first = run_ranks(folder_->path(), 2, "run few.toml --threads 1 --shard 1/2");
    EXPECT_EQ(first.status, 0) << first.error;
    EXPECT_THAT(first.out, HasSubstr("shard 1/2 is done"));
    const Outcome last = run_ranks(folder_->path(), 2, "run few.toml --threads 1 --shard 2/2");
    EXPECT_EQ(last.status, 0) << last.error;
    EXPECT_THAT(last.out, testing::EndsWith("few/index.html\n"));
}

/// The 32 realizations that both experiments begin with are analysed once, by whoever it is.
TEST_F(ManyProcesses, ExperimentsOfTheSameSetsShareThem)
{
    const std::string method = "[[method]]\nsampler = \"random\"\n";
    folder_->write("short.toml", "[analysis]\npoints = 64\nrealizations = 40\n" + method);
    folder_->write("long.toml", "[analysis]\npoints = 64\nrealizations = 70\npoint_files = \"first\"\n" + method);
    folder_->write("pair.toml", "include = [\"long.toml\", \"short.toml\"]\n");
    ASSERT_EQ(run({"run", "pair.toml", "--out", "pair-1"}).status, 0);
    const Outcome outcome = run_ranks(folder_->path(), 3, "run pair.toml --out pair-3 --threads 1");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    auto first = lasting_results(folder_->path() / "pair-1"), second = lasting_results(folder_->path() / "pair-3");
    first.erase("collection.json"); // has the command
    second.erase("collection.json");
    EXPECT_EQ(first, second);
}

/// Several pieces each; of chains and with a density their sizes are counted first, by all.
TEST_F(ManyProcesses, RanksWriteOneFileOfPoints)
{
    write_tile_set(folder_->path() / "strips.ptiles", random_tile_set(PoissonTileKind::corner, 2, 3, 9));
    write_tile_set(folder_->path() / "chains.ptiles", with_random_ranks(random_chain_set(3, 20)));
    const auto same = [](const std::string& arguments, const std::string& extension) {
        const std::string one = "one" + extension;
        ASSERT_EQ(run_program_line(folder_->path(), "tiles points " + arguments + one).status, 0);
        for (const int ranks : {1, 2, 5}) {
            const Outcome outcome = run_ranks(folder_->path(), ranks, "tiles points " + arguments + "some" + extension);
            EXPECT_EQ(outcome.status, 0) << outcome.error;
            EXPECT_EQ(outcome.error, "");
            EXPECT_TRUE(content_of(folder_->path() / one) == content_of(folder_->path() / ("some" + extension)))
                << arguments << ranks;
        }
    };
    same("strips.ptiles --window -3 5 700 701 --seed 7 --out ", ".npy");
    same("chains.ptiles --window 0 0 500 500 --density 0.5 --out ", ".h5");
    same("strips.ptiles --window 0 0 20 20 --out ", ".txt");
    for (const auto& entry : fs::directory_iterator(folder_->path()))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".tmp")) << entry.path();
    expect_one_error(run_ranks(folder_->path(), 3, "tiles points none.ptiles --torus 2 --out a.npy"), "none.ptiles: ");
}

/// Dozens of blocks, of which each process makes some; the parts that it keeps are gone afterwards.
TEST_F(ManyProcesses, RanksThrowTheDartsOfOneSet)
{
    const std::string arguments = "points dart-throwing --points 30000 --memory 0.003 --quiet --out darts/";
    fs::create_directories(folder_->path() / "darts");
    for (const int ranks : {1, 2, 3}) {
        const std::string file = std::to_string(ranks) + ".npy";
        const Outcome outcome = run_ranks(folder_->path(), ranks, arguments + file);
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_TRUE(content_of(folder_->path() / "darts" / file) == content_of(folder_->path() / "darts/1.npy"));
    }
    expect_one_error(run_ranks(folder_->path(), 2, arguments + "4.npy --relative-radius 0.9"),
                     "points dart-throwing: --relative-radius 0.9: ");
    const std::string command = quoted(program_file()) + " " + arguments + "5.npy";
    const Outcome died = run_in_shell(folder_->path(), mpirun + "-n 1 " + command + " : -n 1 sh -c " +
                                                           quoted("ulimit -f 1; exec " + command));
    EXPECT_NE(died.status, 0);
    for (const auto& entry : fs::directory_iterator(folder_->path() / "darts"))
        EXPECT_THAT(entry.path().filename().string(), testing::MatchesRegex("[123].npy"));
}

/// Each process has some slabs; with random starts points go from process to process in each iteration.
TEST_F(ManyProcesses, RanksRelaxThePointsOfOneSet)
{
    fs::create_directories(folder_->path() / "relaxed");
    const auto same = [](const std::string& arguments, const std::string& extension, const std::vector<int>& crews) {
        for (const int ranks : crews) {
            const std::string file = "relaxed/" + std::to_string(ranks) + extension;
            const Outcome outcome = run_ranks(folder_->path(), ranks, "points " + arguments + " --quiet --out " + file);
            EXPECT_EQ(outcome.status, 0) << outcome.error;
            EXPECT_TRUE(content_of(folder_->path() / file) == content_of(folder_->path() / ("relaxed/1" + extension)))
                << arguments << ", " << ranks << " processes";
        }
    };
    same("lloyd --points 5000 --iterations 5 --memory 0.001 --start jittered --keep best", ".npy", {1, 2, 3});
    same("gaussian-blue-noise --points 5000 --iterations 3 --levels 1", ".txt", {1, 3});
    expect_one_error(run_ranks(folder_->path(), 2, "points lloyd --points 100 --out relaxed/4.npy"),
                     "points lloyd: needs --iterations");
    const std::string command =
        quoted(program_file()) + " points lloyd --points 90000 --iterations 1 --quiet --out relaxed/5.npy";
    const Outcome died = run_in_shell(folder_->path(), mpirun + "-n 1 " + command + " : -n 1 sh -c " +
                                                           quoted("ulimit -f 1; exec " + command));
    EXPECT_NE(died.status, 0);
    for (const auto& entry : fs::directory_iterator(folder_->path() / "relaxed"))
        EXPECT_THAT(entry.path().filename().string(), testing::MatchesRegex("[123]\\.(npy|txt)"));
}

/// mpirun ends the others; whoever starts it again gets the file.
TEST_F(ManyProcesses, ARankThatDiesLeavesNoFileOfPoints)
{
    write_tile_set(folder_->path() / "strips.ptiles", random_tile_set(PoissonTileKind::corner, 2, 3, 9));
    const std::string command = quoted(program_file()) + " tiles points strips.ptiles --torus 900 --out died.npy";
    const Outcome outcome = run_in_shell(folder_->path(), mpirun + "-n 1 " + command + " : -n 1 sh -c " +
                                                              quoted("ulimit -f 1; exec " + command));
    EXPECT_NE(outcome.status, 0);
    EXPECT_FALSE(fs::exists(folder_->path() / "died.npy"));
    EXPECT_EQ(run_ranks(folder_->path(), 2, "tiles points strips.ptiles --torus 900 --out died.npy").status, 0);
    EXPECT_EQ(fs::file_size(folder_->path() / "died.npy"), 128 + std::uint64_t{900} * 900 * 9 * 16);
}

TEST_F(ManyProcesses, FailureBeforeTheWorkIsSaidOnce)
{
    fs::create_directories(folder_->path() / "taken/random");
    folder_->write("taken/random/mine.txt", "not a result\n");
    expect_one_error(run_ranks(folder_->path(), 3, "run c.toml --out taken"), "--out taken: has \"random\"");
    // Units are there in one, but results cannot take their places.
    fs::create_directories(folder_->path() / "file");
    folder_->write("file/.units", "a file where the folder of units should be\n");
    const Outcome outcome = run_ranks(folder_->path(), 3, "run c.toml --out file");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.error, HasSubstr("file/.units/crew-"));
}

TEST_F(ManyProcesses, RanksWithDifferentDevicesAreRefused)
{
    const std::string program = quoted(program_file()) + " run c.toml --out differ";
    const Outcome outcome =
        run_in_shell(folder_->path(), mpirun + "-n 1 " + program + " : -n 1 env OCL_ICD_VENDORS=/nothing " + program);
    expect_one_error(outcome, "");
    EXPECT_THAT(outcome.error, HasSubstr("would not do the same work as the first one: \"device = none\" is not"));
}

TEST_F(ManyProcesses, MistakesAreSaidOnce)
{
    expect_one_error(run_ranks(folder_->path(), 3, "run nothing.toml"), "nothing.toml: cannot be read");
}

TEST_F(ManyProcesses, WhatFailsAmidTheWorkIsSaidOnce)
{
    // 64 points often reach this radius, not always.
    folder_->write("fails.toml", "[analysis]\npoints = 64\nrealizations = 200\n[[method]]\nsampler = \"random\"\n"
                                 "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.79\n");
    const Outcome outcome = run_ranks(folder_->path(), 3, "run fails.toml --threads 1");
    expect_one_error(outcome, "");
    EXPECT_THAT(outcome.error, HasSubstr("fails.toml:8: relative_radius = 0.79"));
    EXPECT_THAT(outcome.error, HasSubstr("1 of 2 could not be made: Dart throwing"));
    const auto results = nlohmann::json::parse(content_of(folder_->path() / "out/fails/results.json"));
    EXPECT_EQ(results["series"].size(), 1U) << "the other is there";
    EXPECT_EQ(results["missing"].size(), 1U);
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
    EXPECT_THAT(content_of(folder_->path() / "both-2/collection.json"),
                testing::ContainsRegex("\"runs\": \\[[[:space:]]*\"b\",[[:space:]]*\"a\"[[:space:]]*\\]"));
}

#endif

}
}
