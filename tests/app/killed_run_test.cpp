// Runs that are killed at random moments, and stopped by Ctrl-C.
#include "tests/app/lasting_results.hpp"
#include "tests/app/survival_config.hpp"
#include "tests/support/started_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <random>
#include <string>
#include <thread>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;

class KilledRun : public testing::Test
{
protected:
    /// One run that nobody disturbs, for all tests: how long it takes, and its results.
    static void SetUpTestSuite()
    {
        const TemporaryFolder folder;
        folder.write("c.toml", survival_config);
        ::setenv("POISSONLAB_CACHE", (folder.path() / "cache").c_str(), 1);
        const auto begin = std::chrono::steady_clock::now();
        ASSERT_EQ(StartedProgram(folder.path(), {"run", "c.toml", "--out", "out"}).wait(), 0)
            << content_of(folder.path() / "log");
        whole_ = std::chrono::steady_clock::now() - begin;
        undisturbed_ = lasting_results(folder.path() / "out");
        ASSERT_GT(undisturbed_.size(), 100U) << "points, tables, images, pictures";
    }
    static void TearDownTestSuite() { ::unsetenv("POISSONLAB_CACHE"); }

    KilledRun() { ::setenv("POISSONLAB_CACHE", (folder_.path() / "cache").c_str(), 1); }

    /// Starts `poissonlab run ARGUMENTS`.
    StartedProgram start(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "run");
        return {folder_.path(), std::move(arguments)};
    }

    std::string log() const { return content_of(folder_.path() / "log"); }

    TemporaryFolder folder_;
    static inline Seconds whole_{};
    static inline std::map<std::string, std::string> undisturbed_;
};

TEST_F(KilledRun, GoesOnFromAnyMoment)
{
    folder_.write("c.toml", survival_config);
    // Five times ten moments: uniform over twice a tenth of a whole run, so that ten of them reach its end on average.
    std::mt19937 random(20261121);
    for (int campaign = 0; campaign < 5; ++campaign) {
        fs::remove_all(folder_.path() / "out");
        fs::remove_all(folder_.path() / "cache");
        for (int kill = 0; kill < 10; ++kill) {
            StartedProgram process = start({"c.toml", "--out", "out"});
            std::this_thread::sleep_for(std::uniform_real_distribution(0.0, 0.2)(random) * whole_);
            process.send(SIGKILL);
            process.wait();
        }
        ASSERT_EQ(start({"c.toml", "--out", "out"}).wait(), 0) << log();
        const auto found = lasting_results(folder_.path() / "out");
        for (const auto& [name, content] : undisturbed_) {
            ASSERT_TRUE(found.contains(name)) << name << " is missing in campaign " << campaign;
            EXPECT_EQ(found.at(name), content) << name << " in campaign " << campaign;
        }
        EXPECT_EQ(found.size(), undisturbed_.size()) << "files that an undisturbed run does not leave";
    }
}

TEST_F(KilledRun, StopsAtCtrlCAmidWorkThatTakesMinutes)
{
    folder_.write("c.toml", "[analysis]\npoints = 65536\nrealizations = 2\n[[method]]\nsampler = \"random\"\n"
                            "[[method]]\nsampler = \"lloyd\"\niterations = 1000000\nstart = \"random\"\n");
    StartedProgram process = start({"c.toml"});
    while (log().find("Random: 2 realizations") == std::string::npos) std::this_thread::sleep_for(Seconds(0.05));
    std::this_thread::sleep_for(Seconds(0.5));
    const auto begin = std::chrono::steady_clock::now();
    process.send(SIGINT);
    const int status = process.wait();
    const Seconds taken = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_LT(taken.count(), 10) << "far less than the work; bench_interrupt holds the second that it should take";
    EXPECT_THAT(log(),
                testing::EndsWith("poissonlab: interrupted; finished work is kept in out/c/.units: the same command "
                                  "goes on from there (poissonlab run c.toml)\n"));
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
        EXPECT_EQ(entry.path().filename().string().find(".tmp"), std::string::npos) << entry.path();
}

TEST_F(KilledRun, TwoAtOnceInOneFolderDoNotHurtEachOther)
{
    folder_.write("c.toml", survival_config);
    StartedProgram first = start({"c.toml", "--out", "out"});
    StartedProgram second = start({"c.toml", "--out", "out"});
    EXPECT_EQ(first.wait(), 0) << log();
    EXPECT_EQ(second.wait(), 0) << log();
    EXPECT_EQ(lasting_results(folder_.path() / "out"), undisturbed_);
}

}
}
