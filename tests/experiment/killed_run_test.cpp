// Runs that are killed at random moments, and stopped by Ctrl-C.
#include "experiment/lasting_results.hpp"
#include "experiment/survival_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <thread>

extern char** environ;

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using Seconds = std::chrono::duration<double>;

class KilledRun : public testing::Test
{
protected:
    /// Starts `poissonlab run ARGUMENTS`, with what it says in `log`, and gives its process.
    pid_t start(const std::vector<std::string>& arguments) const
    {
        std::vector<std::string> words = {POISSONLAB_BINARY, "run"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addchdir_np(&actions, folder_.path().c_str());
        posix_spawn_file_actions_addopen(&actions, 1, "log", O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_adddup2(&actions, 1, 2);
        pid_t process = 0;
        EXPECT_EQ(posix_spawn(&process, POISSONLAB_BINARY, &actions, nullptr, argv.data(), environ), 0);
        posix_spawn_file_actions_destroy(&actions);
        return process;
    }

    static int wait_for(pid_t process)
    {
        int status = 0;
        EXPECT_EQ(::waitpid(process, &status, 0), process);
        return status;
    }

    std::string log() const { return content_of(folder_.path() / "log"); }

    TemporaryFolder folder_;
};

TEST_F(KilledRun, GoesOnFromAnyMoment)
{
    folder_.write("c.toml", survival_config);
    ::setenv("POISSONLAB_CACHE", (folder_.path() / "cache").c_str(), 1);
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(wait_for(start({"c.toml", "--out", "undisturbed"})), 0) << log();
    const Seconds whole = std::chrono::steady_clock::now() - begin;
    const auto expected = lasting_results(folder_.path() / "undisturbed");
    ASSERT_GT(expected.size(), 100U) << "points, tables, images, pictures";

    // Five times ten moments: uniform over twice a tenth of a whole run, so that ten of them reach its end on average.
    std::mt19937 random(20261121);
    for (int campaign = 0; campaign < 5; ++campaign) {
        fs::remove_all(folder_.path() / "out");
        fs::remove_all(folder_.path() / "cache");
        for (int kill = 0; kill < 10; ++kill) {
            const pid_t process = start({"c.toml", "--out", "out"});
            std::this_thread::sleep_for(std::uniform_real_distribution(0.0, 0.2)(random) * whole);
            ::kill(process, SIGKILL);
            wait_for(process);
        }
        ASSERT_EQ(wait_for(start({"c.toml", "--out", "out"})), 0) << log();
        const auto found = lasting_results(folder_.path() / "out");
        for (const auto& [name, content] : expected) {
            ASSERT_TRUE(found.contains(name)) << name << " is missing in campaign " << campaign;
            EXPECT_EQ(found.at(name), content) << name << " in campaign " << campaign;
        }
        EXPECT_EQ(found.size(), expected.size()) << "files that an undisturbed run does not leave";
    }
    ::unsetenv("POISSONLAB_CACHE");
}

TEST_F(KilledRun, StopsAtCtrlCAmidWorkThatTakesMinutes)
{
    folder_.write("c.toml", "[analysis]\npoints = 65536\nrealizations = 2\n[[method]]\nsampler = \"random\"\n"
                            "[[method]]\nsampler = \"lloyd\"\niterations = 1000000\nstart = \"random\"\n");
    const pid_t process = start({"c.toml"});
    while (log().find("Random: 2 realizations") == std::string::npos) std::this_thread::sleep_for(Seconds(0.05));
    std::this_thread::sleep_for(Seconds(0.5));
    const auto begin = std::chrono::steady_clock::now();
    ::kill(process, SIGINT);
    const int status = wait_for(process);
    const Seconds taken = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_LT(taken.count(), 10) << "a second on a machine that is not busy, of work for hours";
    EXPECT_THAT(log(), testing::EndsWith("poissonlab: interrupted; finished work is kept in out/c/.units: the same command "
                                         "goes on from there (poissonlab run c.toml)\n"));
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
        EXPECT_EQ(entry.path().filename().string().find(".tmp"), std::string::npos) << entry.path();
}

TEST_F(KilledRun, TwoAtOnceInOneFolderDoNotHurtEachOther)
{
    folder_.write("c.toml", survival_config);
    ASSERT_EQ(wait_for(start({"c.toml", "--out", "undisturbed"})), 0) << log();
    const pid_t first = start({"c.toml", "--out", "out"});
    const pid_t second = start({"c.toml", "--out", "out"});
    EXPECT_EQ(wait_for(first), 0) << log();
    EXPECT_EQ(wait_for(second), 0) << log();
    EXPECT_EQ(lasting_results(folder_.path() / "out"), lasting_results(folder_.path() / "undisturbed"));
}

}
}
